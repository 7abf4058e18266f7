// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "spline/pick_constraint.h"

#include <array>
#include <functional>
#include <span>

// Open curves that run past their first or last pick and turn back to it.
namespace bspline_curve {

/// A way through picks, by its parameter.
using Way = std::function<Vec3(double)>;

/// For each of its ends, something about how a way comes to it from the pick beside it.
template <class Value>
using AtEnds = std::array<Value, 2>;

/// Unit directions in which a way comes to its first and to its last pick.
[[nodiscard]] AtEnds<Vec3> arrivalsOf(const Way& way, std::span<const PickConstraint> picks);

/// How far a way runs past its ends, seen in these directions, or away from them again, while it is
/// near to them; relative to the chord to the pick beside the end.
[[nodiscard]] AtEnds<double> overrunsOf(
    const Way& way, std::span<const PickConstraint> picks, const AtEnds<Vec3>& directions
);

}  // namespace bspline_curve
