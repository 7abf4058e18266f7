// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Directions of some picks.
struct PickDirections {
    std::vector<std::pair<int, Vec3>> entries{};  ///< ids of picks, from 0

    /// One for each of so many picks, see CurveInputs::tangents; empty where there are none. Throws
    /// InputError (BadOption) where a pick is not there.
    [[nodiscard]] std::vector<Vec3> of(std::size_t count) const;

    friend bool operator==(const PickDirections&, const PickDirections&) = default;
};

/// "1: 1, 0, 0; 4: 0 1 0": picks counted from 1, and a vector that is not zero for each; "": none.
/// Throws InputError (BadOption) naming what is none of these; `name`: of the option.
[[nodiscard]] PickDirections parsePickDirections(const std::string& text, const std::string& name);

/// The same back again, to the bit.
[[nodiscard]] std::string describe(const PickDirections& directions);

}  // namespace bspline_curve
