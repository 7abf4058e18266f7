// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/labels.h"

#include <cctype>
#include <cstddef>
#include <string_view>

namespace bspline_curve {

namespace {

bool isOfWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

const ParameterDescription* parameterCalled(const FilterDescription& filter, std::string_view id) {
    for (const ParameterDescription& parameter : filter.parameters) {
        if (parameter.id == id) {
            return &parameter;
        }
    }
    return nullptr;
}

}  // namespace

std::string withLabels(const std::string& message, const FilterDescription& filter) {
    std::string labelled;
    for (std::size_t begin = 0; begin < message.size();) {
        std::size_t end = begin;
        while (end < message.size() && isOfWord(message[end])) {
            ++end;
        }
        const std::string_view word = std::string_view(message).substr(begin, end - begin);
        const ParameterDescription* const parameter =
            word.find('_') == std::string_view::npos ? nullptr : parameterCalled(filter, word);
        if (parameter == nullptr) {
            labelled += word;
        } else {
            labelled += "\"" + parameter->label + "\"";
        }
        if (end < message.size()) {
            labelled += message[end++];
        }
        begin = end;
    }
    return labelled;
}

}  // namespace bspline_curve
