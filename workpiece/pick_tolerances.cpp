// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"
#include "text/error_messages.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

namespace bspline_curve {

namespace {

constexpr std::string_view kSpaces = " \t";
constexpr std::string_view kWeight = "weight";

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    return text.substr(0, text.find_last_not_of(kSpaces) + 1);
}

PickTolerances::Entry entryOf(std::string_view text, const std::string& name) {
    if (!text.starts_with(kWeight)) {
        return {.within = parseLength(std::string(text), name)};
    }
    PickTolerances::Entry entry;
    const std::string number(trimmed(text.substr(kWeight.size())));
    const char* const begin = number.c_str();
    const char* const end = begin + number.size();
    const auto [stop, error] = std::from_chars(begin, end, entry.weight);
    const bool isWeight = error == std::errc() && stop == end && std::isfinite(entry.weight);
    if (!isWeight || entry.weight <= 0.0) {
        throw InputError(
            InputErrorCode::BadOption,
            name + " has \"" + std::string(text) +
                R"(", but a weight must be a number above 0, as "weight 100")"
        );
    }
    return entry;
}

/// A member of the entry of each of so many picks.
template <class Value>
std::vector<Value> ofEach(
    const std::vector<PickTolerances::Entry>& entries,
    std::size_t count,
    Value PickTolerances::Entry::* member
) {
    if (entries.size() > 1 && entries.size() != count) {
        throw InputError(
            InputErrorCode::BadOption,
            "there are " + std::to_string(entries.size()) + " pick tolerances for " +
                describeCount(count, "pick", "picks") + ": give one for all, or one for each"
        );
    }
    std::vector<Value> values;
    for (std::size_t i = 0; i < count && !entries.empty(); ++i) {
        values.push_back(entries[entries.size() == 1 ? 0 : i].*member);
    }
    return values;
}

}  // namespace

std::vector<MeshLength> PickTolerances::within(std::size_t count) const {
    return ofEach(entries, count, &Entry::within);
}

std::vector<double> PickTolerances::weights(std::size_t count) const {
    return ofEach(entries, count, &Entry::weight);
}

PickTolerances parsePickTolerances(const std::string& text, const std::string& name) {
    PickTolerances tolerances;
    std::string_view rest = text;
    while (true) {
        const std::size_t comma = rest.find(',');
        tolerances.entries.push_back(entryOf(trimmed(rest.substr(0, comma)), name));
        if (comma == std::string_view::npos) {
            return tolerances;
        }
        rest.remove_prefix(comma + 1);
    }
}

}  // namespace bspline_curve
