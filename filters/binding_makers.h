// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/option_bindings.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// How bindings of parameters to members are made.
namespace bspline_curve {

/// Binds a member whose type is the value's own.
template <class Options, class Value>
Binding<Options> bound(const std::string& id, Value Options::* member) {
    return {
        .id = id,
        .read = [member](
                    const ParameterValue& value, Options& options
                ) { options.*member = std::get<Value>(value); },
        .write = [member](const Options& options) -> ParameterValue { return options.*member; }
    };
}

/// Binds a length that is given as text.
template <class Options>
Binding<Options> boundLength(const std::string& id, MeshLength Options::* member) {
    return {
        .id = id,
        .read = [id, member](
                    const ParameterValue& value, Options& options
                ) { options.*member = parseLength(std::get<std::string>(value), id); },
        .write = [member](const Options& options) -> ParameterValue {
            return describe(options.*member);
        }
    };
}

/// Binds the tolerance of all picks; where the text gives one for each, pickTolerancesOf() does.
template <class Options>
Binding<Options> boundTolerance(const std::string& id, MeshLength Options::* member) {
    return {
        .id = id,
        .read =
            [id, member](const ParameterValue& value, Options& options) {
                const PickTolerances parsed = parsePickTolerances(std::get<std::string>(value), id);
                options.*member =
                    parsed.entries.size() == 1 ? parsed.entries.front().within : MeshLength();
            },
        .write = [member](const Options& options) -> ParameterValue {
            return describe(options.*member);
        }
    };
}

/// Binds picks that are chosen by text.
template <class Options>
Binding<Options> boundPicks(const std::string& id, PickChoice Options::* member) {
    return {
        .id = id,
        .read = [id, member](
                    const ParameterValue& value, Options& options
                ) { options.*member = parsePickChoice(std::get<std::string>(value), id); },
        .write = [member](const Options& options) -> ParameterValue {
            return describe(options.*member);
        }
    };
}

/// Binds directions of picks that are given by text.
template <class Options>
Binding<Options> boundDirections(const std::string& id, PickDirections Options::* member) {
    return {
        .id = id,
        .read = [id, member](
                    const ParameterValue& value, Options& options
                ) { options.*member = parsePickDirections(std::get<std::string>(value), id); },
        .write = [member](const Options& options) -> ParameterValue {
            return describe(options.*member);
        }
    };
}

template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

/// Binds a member that is chosen by name.
template <class Options, class Enum>
Binding<Options> chosen(const std::string& id, Enum Options::* member, const Names<Enum>& names) {
    const auto read = [member, names](const ParameterValue& value, Options& options) {
        const auto found = std::ranges::find(
            names, std::get<std::string>(value), &std::pair<std::string, Enum>::first
        );
        if (found != names.end()) {
            options.*member = found->second;
        }
    };
    const auto write = [member, names](const Options& options) -> ParameterValue {
        const auto found =
            std::ranges::find(names, options.*member, &std::pair<std::string, Enum>::second);
        if (found == names.end()) {
            throw std::logic_error("an enumerator without a name");
        }
        return found->first;
    };
    return {.id = id, .read = read, .write = write};
}

}  // namespace bspline_curve
