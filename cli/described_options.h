// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/parameter_values.h"

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bspline_curve::cli {

/// The group of a verb's own options in its help.
inline constexpr const char* kMainGroup = "Options";

/// What the program has beyond the description of a parameter.
struct OptionExtras {
    std::string aliases{};  ///< ",--lambda"
    /// Of an enumeration: any other word goes here.
    std::string* other = nullptr;
    std::string otherHelp{};  ///< what such a word is
    /// Follows the words that are listed; of a text: what it is.
    std::string otherType{"|FILE"};
    bool isRequired = false;  ///< of an enumeration
    bool hasDefault = true;   ///< of a number; false: the help names none
    std::string help{};       ///< of a switch or number, in place of what is described
};

/// Options of a verb that the parameters of a filter describe: avoid_margin is --avoid-margin, with
/// its help, range and default. Options of enumerations that need a selection are left out.
class DescribedOptions {
public:
    /// Both must outlive this.
    DescribedOptions(CLI::App& app, const FilterDescription& filter) : app_(app), values_(filter) {}

    /// The default that this verb has instead; or, after parsing, what was meant.
    void set(std::string_view id, ParameterValue value) { values_.set(id, std::move(value)); }

    /// Declares the option of a parameter, listed under `group` in the help.
    CLI::Option* add(
        std::string_view id, const OptionExtras& extras = {}, const std::string& group = kMainGroup
    );

    /// What was given, else the defaults.
    [[nodiscard]] const ParameterValues& values() const { return values_; }

    /// Whether the option was on the command line.
    [[nodiscard]] bool isGiven(std::string_view id) const { return said_.contains(id); }

    /// Whether one of them was, but for some.
    [[nodiscard]] bool isAnyGivenBut(std::span<const std::string_view> ids) const;

private:
    /// Throws where a text is not what the option with a flag takes.
    using TextCheck = std::function<void(const std::string& text, const std::string& flag)>;

    void keep(const std::string& id, ParameterValue value);
    CLI::Option* addText(
        const ParameterDescription& parameter,
        const std::string& flags,
        const OptionExtras& extras,
        const TextCheck& check,
        const std::string& typeName
    );
    CLI::Option* addChoice(
        const ParameterDescription& parameter, const std::string& flags, const OptionExtras& extras
    );
    template <class Number>
    CLI::Option* addNumber(
        const ParameterDescription& parameter, const std::string& flags, const OptionExtras& extras
    );

    CLI::App& app_;
    ParameterValues values_;
    std::set<std::string, std::less<>> said_;
};

/// "--avoid-margin" for avoid_margin.
[[nodiscard]] std::string flagOf(std::string_view parameterId);

}  // namespace bspline_curve::cli
