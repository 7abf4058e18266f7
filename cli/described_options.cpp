// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/described_options.h"

#include "bspline_curve/curve_options.h"
#include "cli/value_checks.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace bspline_curve::cli {

namespace {

constexpr bool kHasSelections = false;

template <class Number>
Interval<Number> rangeOf(const ParameterDescription& parameter) {
    using Limits = std::numeric_limits<Number>;
    return {
        .low = parameter.min ? static_cast<Number>(*parameter.min) : Limits::lowest(),
        .high = parameter.max ? static_cast<Number>(*parameter.max) : Limits::max(),
        .withLow = !parameter.excludesMin
    };
}

// Whether a text can be parsed.
template <class Parse>
auto parsed(const Parse& parse) {
    return [parse](const std::string& text, const std::string& flag) {
        static_cast<void>(parse(text, flag));
    };
}

}  // namespace

std::string flagOf(std::string_view parameterId) {
    std::string flag = "--" + std::string(parameterId);
    std::ranges::replace(flag, '_', '-');
    return flag;
}

void DescribedOptions::keep(const std::string& id, ParameterValue value) {
    values_.set(id, std::move(value));
    said_.insert(id);
}

bool DescribedOptions::isAnyGivenBut(std::span<const std::string_view> ids) const {
    return std::ranges::any_of(said_, [&](const std::string& id) {
        return std::ranges::find(ids, id) == ids.end();
    });
}

template <class Number>
CLI::Option* DescribedOptions::addNumber(
    const ParameterDescription& parameter, const std::string& flags, const OptionExtras& extras
) {
    const Interval<Number> range = rangeOf<Number>(parameter);
    const auto keepNumber = [this, id = parameter.id](const Number& value) { keep(id, value); };
    const std::string& help = extras.help.empty() ? parameter.help : extras.help;
    CLI::Option* const option =
        app_.add_option_function<Number>(flags, keepNumber, help + " (" + range.text() + ")")
            ->check(range.validator())
            ->type_name(std::is_integral_v<Number> ? "N" : "X");
    if (extras.hasDefault) {
        option->default_str(CLI::detail::to_string(values_.get<Number>(parameter.id)));
    }
    return option;
}

CLI::Option* DescribedOptions::addChoice(
    const ParameterDescription& parameter, const std::string& flags, const OptionExtras& extras
) {
    const std::vector<std::string> ids = parameter.optionIds(kHasSelections);
    const auto keepWord =
        [this, id = parameter.id, ids, other = extras.other](const std::string& word) {
            said_.insert(id);
            if (std::ranges::find(ids, word) != ids.end()) {
                keep(id, word);
            } else {
                *other = word;  // without one the check lets only options pass
            }
        };
    std::string help = parameter.fullHelp(kHasSelections);
    std::string words = joined(ids);
    if (extras.other != nullptr) {
        help += " " + extras.otherHelp;
        words += extras.otherType;
    }
    CLI::Option* const option =
        app_.add_option_function<std::string>(flags, keepWord, help)->type_name(words);
    if (extras.other == nullptr) {
        option->check(oneOf(ids));
    }
    return extras.isRequired ? option->required()
                             : option->default_str(values_.get<std::string>(parameter.id));
}

// A text that is kept as it is, where check(text, flag) does not throw.
CLI::Option* DescribedOptions::addText(
    const ParameterDescription& parameter,
    const std::string& flags,
    const OptionExtras& extras,
    const TextCheck& check,
    const std::string& typeName
) {
    const auto keepText = [this, key = parameter.id, check](const std::string& text) {
        if (check) {
            check(text, flagOf(key));
        }
        keep(key, text);
    };
    const std::string& help = extras.help.empty() ? parameter.help : extras.help;
    return app_.add_option_function<std::string>(flags, keepText, help)->type_name(typeName);
}

CLI::Option* DescribedOptions::add(
    std::string_view id, const OptionExtras& extras, const std::string& group
) {
    const ParameterDescription& parameter = values_.filter().parameter(id);
    const std::string flags = flagOf(id) + extras.aliases;
    CLI::Option* option = nullptr;
    switch (parameter.type) {
        case ParameterType::Bool:
            option = app_.add_flag_function(
                flags,
                [this, key = parameter.id](std::int64_t /*times*/) { keep(key, true); },
                extras.help.empty() ? parameter.help : extras.help
            );
            break;
        case ParameterType::Int:
            option = addNumber<int>(parameter, flags, extras);
            break;
        case ParameterType::Double:
        case ParameterType::Percentage:
            option = addNumber<double>(parameter, flags, extras);
            break;
        case ParameterType::Enum:
            option = addChoice(parameter, flags, extras);
            break;
        case ParameterType::Length:
            option = addText(parameter, flags, extras, parsed(parseLength), "LENGTH")
                         ->default_str(values_.get<std::string>(parameter.id));
            break;
        case ParameterType::Tolerances:
            option = addText(parameter, flags, extras, parsed(parsePickTolerances), "LENGTH,...")
                         ->default_str(values_.get<std::string>(parameter.id));
            break;
        case ParameterType::Picks:
            option = addText(parameter, flags, extras, parsed(parsePickChoice), "PICKS");
            break;
        case ParameterType::Tangents:
            option = addText(parameter, flags, extras, parsed(parsePickDirections), "PICK:X,Y,Z");
            break;
        case ParameterType::Text:
            option = addText(parameter, flags, extras, nullptr, extras.otherType);
            break;
        default:
            throw std::invalid_argument(parameter.id + " is no option of the program");
    }
    return option->group(group);
}

}  // namespace bspline_curve::cli
