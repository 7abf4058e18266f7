// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace bspline_curve {

namespace {

bool isOfWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string quoted(const std::string& label) {
    return "\"" + label + "\"";
}

const ParameterDescription* parameterCalled(const FilterDescription& filter, std::string_view id) {
    const auto found = std::ranges::find(filter.parameters, id, &ParameterDescription::id);
    return found == filter.parameters.end() ? nullptr : &*found;
}

/// The parameter that these words of a message name: "field weight", "Gauss points", "weld".
const ParameterDescription* parameterNamed(
    const FilterDescription& filter, std::string_view words
) {
    std::string id(words);
    std::ranges::transform(id, id.begin(), [](unsigned char c) {
        return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    });
    // Options of fields have it before their ids in the filter for curves alone.
    constexpr std::string_view kPrefix = "field_";
    const std::string shortId = id.starts_with(kPrefix) ? id.substr(kPrefix.size()) : id;
    for (const std::string& candidate : {id, std::string(kPrefix) + id, shortId}) {
        if (const ParameterDescription* const found = parameterCalled(filter, candidate)) {
            return found;
        }
    }
    return nullptr;
}

/// Puts labels into a message, from its begin to its end.
class Labeller {
public:
    Labeller(const std::string& message, const FilterDescription& filter)
        : rest_(message), filter_(filter) {}

    std::string labelled() {
        takeSubject();
        while (!rest_.empty()) {
            if (rest_.front() == '"') {
                takeQuoted();
            } else if (isOfWord(rest_.front())) {
                takeWord();
            } else {
                const char between = take(1).front();
                isAmongOptions_ = isAmongOptions_ && (between == ' ' || between == ',');
            }
        }
        return text_;
    }

private:
    std::string_view take(std::size_t count) {
        const std::string_view taken = rest_.substr(0, count);
        text_ += taken;
        rest_.remove_prefix(taken.size());
        return taken;
    }

    void putLabel(const ParameterDescription& parameter, std::size_t length) {
        named_ = &parameter;
        text_ += quoted(parameter.label);
        rest_.remove_prefix(length);
    }

    void takeSubject() {
        constexpr std::array<std::string_view, 5> kVerbs{
            " is ", " are ", " must be ", " has ", " = "
        };
        std::size_t end = std::string_view::npos;
        for (const std::string_view verb : kVerbs) {
            end = std::min(end, rest_.find(verb));
        }
        if (end == std::string_view::npos) {
            return;
        }
        const std::string_view subject = rest_.substr(0, end);
        // "picks are given …" is no sentence about the option of that name.
        const bool isPlural = rest_.substr(end).starts_with(" are ");
        if (isPlural && subject.find(' ') == std::string_view::npos) {
            return;
        }
        if (const ParameterDescription* const parameter = parameterNamed(filter_, subject)) {
            putLabel(*parameter, end);
        }
    }

    void takeQuoted() {
        const std::size_t end = rest_.find('"', 1);
        if (end == std::string_view::npos) {
            take(rest_.size());
            return;
        }
        const std::string_view content = rest_.substr(1, end - 1);
        const EnumOption* const choice = last_ == "layer" ? nullptr : choiceCalled(content);
        if (choice == nullptr) {
            take(end + 1);
        } else {
            text_ += quoted(choice->label);
            rest_.remove_prefix(end + 1);
        }
        last_ = {};
    }

    void takeWord() {
        const std::size_t end = std::ranges::find_if_not(rest_, isOfWord) - rest_.begin();
        const std::string_view word = rest_.substr(0, end);
        const bool isOption = word.find('_') != std::string_view::npos || isAmongOptions_;
        const ParameterDescription* const parameter =
            isOption ? parameterCalled(filter_, word) : nullptr;
        if (parameter != nullptr) {
            putLabel(*parameter, end);
        } else {
            take(end);
            // "the options a, b and c": a list goes on over its last word.
            isAmongOptions_ = word == "option" || word == "options" ||
                              (isAmongOptions_ && (word == "and" || word == "or"));
        }
        last_ = word;
    }

    [[nodiscard]] const EnumOption* choiceCalled(std::string_view id) const {
        const auto in = [&](const ParameterDescription& parameter) -> const EnumOption* {
            const std::optional<std::size_t> index = parameter.indexOf(id);
            return index ? &parameter.options[*index] : nullptr;
        };
        if (const EnumOption* const choice = named_ == nullptr ? nullptr : in(*named_)) {
            return choice;
        }
        for (const ParameterDescription& parameter : filter_.parameters) {
            if (const EnumOption* const choice = in(parameter)) {
                return choice;
            }
        }
        return nullptr;
    }

    std::string text_;
    std::string_view rest_;
    const FilterDescription& filter_;
    const ParameterDescription* named_ = nullptr;  // the last one
    std::string_view last_;                        // word
    bool isAmongOptions_ = false;
};

}  // namespace

std::string withLabels(const std::string& message, const FilterDescription& filter) {
    return Labeller(message, filter).labelled();
}

}  // namespace bspline_curve
