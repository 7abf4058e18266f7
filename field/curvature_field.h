// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// Principal curvatures of one vertex, relative to the length kCurvatureLength: no unit. Positive
/// where the surface is convex seen from outside.
struct PrincipalCurvatures {
    double largest = 0.0, smallest = 0.0;
};

/// Curvatures are multiplied by this share of the diagonal: a fillet with the radius of a twentieth
/// of the diagonal has the curvature 1, and so e^-1 as cost by (25).
inline constexpr double kCurvatureLength = 0.05;
/// A field of curvature is clamped to these, so that its cost (25) stays within [e^-8, e].
inline constexpr double kLeastCurvature = -1.0, kMostCurvature = 8.0;

/// Principal curvatures of the vertices, #V: averages over discs of the radius `scale`, relative to
/// the diagonal, in [0, 1]; never over less than the quadrics that they are fitted to, which take
/// two rings of vertices or, where mean edges are longer than twice `scale`, one. Zero at vertices
/// without faces. The same in every unit and position. About 4 us per vertex on two threads where
/// the scale is up to three edges, 6 to 13 where it is thirteen.
[[nodiscard]] std::vector<PrincipalCurvatures> principalCurvatures(
    const Surface& surface, double scale, const Progress& progress = {}
);

/// (25): the largest curvature, clamped.
[[nodiscard]] double maximalCurvature(const PrincipalCurvatures& curvatures);

/// How much more the surface bends to one side than to the other, in [0, kMostCurvature]: over a
/// ridge the largest curvature, less what it bends the other way across.
[[nodiscard]] double ridgeStrength(const PrincipalCurvatures& curvatures);

/// The ridges of the surface turned inside out.
[[nodiscard]] double valleyStrength(const PrincipalCurvatures& curvatures);

}  // namespace bspline_curve
