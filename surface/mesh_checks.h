// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

namespace bspline_curve {

/// Coordinates beyond this size count as not finite: their products would overflow in the exact
/// predicates.
inline constexpr double kLargestCoordinate = 1e60;

/// Whether no coordinate is NaN or that large.
[[nodiscard]] bool isUsable(const Vec3& point);

/// Checks the arrays of a mesh: it has faces, every coordinate of a vertex that faces use is
/// finite, every index names a vertex.
/// Throws InputError: EmptyMesh, NonFiniteCoordinate (vertices), IndexOutOfRange (faces). O(n).
void checkArrays(const TriangleMesh& mesh);

/// Least height of a triangle, relative to its largest coordinate: 16 ulps.
inline constexpr double kRelativeArea = 0x1p-48;

/// Whether a triangle has an area that rounding cannot undo; see checkFacesHaveArea.
[[nodiscard]] bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c);

/// Checks that every face has three different vertices and an area that rounding cannot undo: twice
/// the area exceeds 2^-48 (16 ulps) x longest edge x largest coordinate. Below that, the height of
/// the triangle is less than the error that storing its corners has made, so that the direction of
/// its normal means nothing; above it, the area is positive in exact arithmetic too.
/// Returns the sum of the areas.
/// Throws InputError: DegenerateFace (faces). Expects checked arrays. O(n).
double checkFacesHaveArea(const TriangleMesh& mesh);

}  // namespace bspline_curve
