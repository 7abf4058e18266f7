// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/sentences.h"

#include <cctype>
#include <cstddef>

namespace bspline_curve {

std::string asSentence(std::string note) {
    note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    return note + ".";
}

void addSentences(std::vector<std::string>& sentences, const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
        sentences.push_back(asSentence(note));
    }
}

std::string describeLayers(const std::vector<std::string>& names) {
    constexpr std::size_t kMostNames = 6;
    const std::size_t named = names.size() > kMostNames ? kMostNames - 1 : names.size();
    std::string text = "The mesh is parted into " + std::to_string(names.size()) + " layers: ";
    for (std::size_t i = 0; i < named; ++i) {
        const bool isLast = i + 1 == names.size();
        text += (i == 0 ? "\"" : isLast ? " and \"" : ", \"") + names[i] + "\"";
    }
    if (named < names.size()) {
        text += " and " + std::to_string(names.size() - named) + " more";
    }
    return text + ".";
}

}  // namespace bspline_curve
