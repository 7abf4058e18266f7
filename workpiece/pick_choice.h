// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bspline_curve {

/// Picks that are chosen, whatever curve they are of.
struct PickChoice {
    bool areAll = false;
    std::vector<int> ids{};  ///< from 0, in any order, where not all are chosen

    /// The ids of those of a curve of so many picks; unchecked where they were given.
    [[nodiscard]] std::vector<int> of(std::size_t count) const;

    friend bool operator==(const PickChoice&, const PickChoice&) = default;
};

/// "1, 4", "1 4": picks counted from 1; "all"; "": none. Throws InputError (BadOption) naming what
/// is none of these; `name`: of the option.
[[nodiscard]] PickChoice parsePickChoice(const std::string& text, const std::string& name);

/// The same back again: "1,4".
[[nodiscard]] std::string describe(const PickChoice& choice);

}  // namespace bspline_curve
