// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// How the verbs declare options of the core's structs: name, member, range and help in one line
// each; the default comes from the struct.
namespace bspline_curve::cli {

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

/// [low, high]
template <class Number>
Interval<Number> within(Number low, Number high) {
    return {.low = low, .high = high};
}

/// (low, high]
inline Interval<double> withinAbove(double low, double high) {
    return {.low = low, .high = high, .withLow = false};
}

template <class Number>
Interval<Number> atLeast(Number low) {
    return {.low = low, .high = std::numeric_limits<Number>::max()};
}

inline Interval<double> moreThan(double low) {
    return {.low = low, .high = std::numeric_limits<double>::max(), .withLow = false};
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
        return isKnown ? std::string() : word + " is none of " + joined(words);
    };
    return {check, ""};
}

/// The names of an enumeration's values.
template <class Enum>
using Names = std::vector<std::pair<std::string, Enum>>;

/// Declares options that set members of one struct, and keeps what was given until apply().
template <class Options>
class OptionTable {
public:
    /// Options are listed under `group` in the help, with the values of `defaults`.
    OptionTable(CLI::App& app, std::string group, const Options& defaults = {})
        : app_(app), group_(std::move(group)), defaults_(defaults) {}

    template <class Number>
    void number(
        const char* flags,
        Number Options::* member,
        const Interval<Number>& range,
        const std::string& help
    ) {
        const auto keep = [this, member](const Number& value) { set(member, value); };
        app_.add_option_function<Number>(flags, keep, help + " (" + range.text() + ")")
            ->check(range.validator())
            ->type_name(std::is_integral_v<Number> ? "N" : "X")
            ->default_str(CLI::detail::to_string(defaults_.*member))
            ->group(group_);
    }

    template <class Enum>
    void choice(
        const char* flags, Enum Options::* member, const Names<Enum>& names, const std::string& help
    ) {
        std::vector<std::string> words;
        std::string defaultWord;
        for (const auto& [name, value] : names) {
            words.push_back(name);
            defaultWord = value == defaults_.*member ? name : defaultWord;
        }
        const auto keep = [this, member, names](const std::string& word) {
            const auto found = std::ranges::find(names, word, &std::pair<std::string, Enum>::first);
            set(member, found->second);  // the check below let only names pass
        };
        app_.add_option_function<std::string>(flags, keep, help)
            ->check(oneOf(words))
            ->type_name(joined(words))
            ->default_str(defaultWord)
            ->group(group_);
    }

    void flag(const char* flags, bool Options::* member, const std::string& help) {
        const auto keep = [this, member](std::int64_t /*times*/) { set(member, true); };
        app_.add_flag_function(flags, keep, help)->group(group_);
    }

    /// Sets the members that were given; the others keep what they are.
    void apply(Options& options) const {
        for (const auto& change : changes_) {
            change(options);
        }
    }

private:
    template <class Value>
    void set(Value Options::* member, const Value& value) {
        changes_.emplace_back([member, value](Options& options) { options.*member = value; });
    }

    CLI::App& app_;
    std::string group_;
    Options defaults_;
    std::vector<std::function<void(Options&)>> changes_;
};

}  // namespace bspline_curve::cli
