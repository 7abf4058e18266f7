// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>

namespace bspline_curve {

struct TurnValue {
    double value, byAngle;  ///< and its derivative
};

/// The angle, from its sine and its cosine, both times the same factor: the series of 2 asin x to
/// the seventh power of x = sin(angle / 2), exact to 0.3 % up to a right angle. By roots alone, so
/// that it is the same on every processor.
[[nodiscard]] TurnValue turnOf(double sine, double cosine);

/// How a node of a path and its normal move by its unknown, its way across the path.
struct NodeWay {
    Vec3 across = Vec3::Zero(), turn = Vec3::Zero();
    double u = 0.0, v = 0.0;  ///< of its foot, in its face
    double fieldBy = 0.0;     ///< derivative of I
};

/// The turn of a path at a node, the length that is its own, and their derivatives by the unknowns
/// before, at and after it.
struct PathTurn {
    double value = 0.0, length = 0.0;
    std::array<double, 3> valueBy{}, lengthBy{};
};

/// `in`, `out`: the segments before and after the node. `ways`: of the three nodes.
[[nodiscard]] PathTurn pathTurn(
    const Vec3& in, const Vec3& out, const Vec3& normal, const std::array<const NodeWay*, 3>& ways
);

/// What a segment beside a pick turns by to the pick's tangent, or from it, on the half of it that
/// is the pick's own, and derivatives by the other node's unknown.
struct HalfTurn {
    double value = 0.0, length = 0.0, valueBy = 0.0, lengthBy = 0.0;
};

/// `way`: from the pick to the other node, which is before it along the path, or after. `across`:
/// how that node moves by its unknown.
[[nodiscard]] HalfTurn halfTurn(
    const Vec3& way, bool isBefore, const Vec3& tangent, const Vec3& normal, const Vec3& across
);

}  // namespace bspline_curve
