// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <string_view>
#include <system_error>

namespace bspline_curve {

namespace {

constexpr std::string_view kAllPicks = "all";
constexpr std::string_view kBetweenPicks = ", \t";

[[noreturn]] void refuseChoice(const std::string& text, const std::string& name) {
    throw InputError(
        InputErrorCode::BadOption,
        name + " is \"" + text + R"(", but must be numbers of picks, from 1, as "1,4", or "all")"
    );
}

}  // namespace

std::vector<int> PickChoice::of(std::size_t count) const {
    if (!areAll) {
        return ids;
    }
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

PickChoice parsePickChoice(const std::string& text, const std::string& name) {
    PickChoice choice;
    std::string_view rest = text;
    const auto skipBetween = [&rest] {
        rest.remove_prefix(std::min(rest.find_first_not_of(kBetweenPicks), rest.size()));
    };
    for (skipBetween(); !rest.empty(); skipBetween()) {
        const std::string_view word = rest.substr(0, rest.find_first_of(kBetweenPicks));
        rest.remove_prefix(word.size());
        if (word == kAllPicks && choice == PickChoice()) {
            choice.areAll = true;
            continue;
        }
        int number = 0;
        const char* const begin = word.data();
        const char* const end = begin + word.size();
        const auto [stop, error] = std::from_chars(begin, end, number);
        if (choice.areAll || error != std::errc() || stop != end || number < 1) {
            refuseChoice(text, name);
        }
        choice.ids.push_back(number - 1);
    }
    return choice;
}

std::string describe(const PickChoice& choice) {
    if (choice.areAll) {
        return std::string(kAllPicks);
    }
    std::string text;
    for (const int id : choice.ids) {
        text.append(text.empty() ? "" : ",").append(std::to_string(id + 1));
    }
    return text;
}

}  // namespace bspline_curve
