// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// What options accept, and how they say so.
namespace bspline_curve::cli {

/// "; did you mean valley?" where one of `words` differs from `word` by at most two letters (one in
/// words of up to three); else "".
[[nodiscard]] std::string didYouMean(std::string_view word, std::span<const std::string> words);

/// An interval of numbers; its text is part of the help.
template <class Number>
struct Interval {
    Number low, high;
    bool withLow = true;

    [[nodiscard]] bool contains(Number value) const {
        return (withLow ? value >= low : value > low) && value <= high &&
               std::isfinite(static_cast<double>(value));
    }

    [[nodiscard]] std::string text() const {
        if (low <= std::numeric_limits<Number>::lowest()) {
            return "finite";
        }
        const std::string lowText = CLI::detail::to_string(low);
        if (high >= std::numeric_limits<Number>::max()) {
            return (withLow ? ">= " : "> ") + lowText;
        }
        return (withLow ? "in [" : "in (") + lowText + ", " + CLI::detail::to_string(high) + "]";
    }

    [[nodiscard]] CLI::Validator validator() const {
        const auto check = [self = *this](const std::string& word) {
            Number value{};
            if (!CLI::detail::lexical_cast(word, value)) {
                const bool isWhole = std::is_integral_v<Number>;
                return word + (isWhole ? " is not a whole number" : " is not a number");
            }
            return self.contains(value) ? std::string() : word + " must be " + self.text();
        };
        return {check, ""};
    }
};

template <class Number>
Interval<Number> atLeast(Number low) {
    return {.low = low, .high = std::numeric_limits<Number>::max()};
}

/// "a|b|c"
[[nodiscard]] inline std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : "|") + word;
    }
    return text;
}

[[nodiscard]] inline CLI::Validator oneOf(const std::vector<std::string>& words) {
    const auto check = [words](const std::string& word) {
        const bool isKnown = std::ranges::find(words, word) != words.end();
        return isKnown ? std::string()
                       : word + " is none of " + joined(words) + didYouMean(word, words);
    };
    return {check, ""};
}

}  // namespace bspline_curve::cli
