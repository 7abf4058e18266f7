// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"

#include <vector>

/// What tests ask of a curve, judged from the outside: by SplineData and SurfacePolyline alone.
namespace bspline_curve::test_support {

/// The exported spline at t, by de Boor's algorithm on its full knot vector.
[[nodiscard]] Vec3 pointOfSpline(const SplineData& spline, double t);

/// Largest distance of two splines at the same of `count` parameters; where `reversed`, of the
/// second at 1 - t.
[[nodiscard]] double largestGap(
    const SplineData& a, const SplineData& b, bool reversed = false, int count = 500
);

[[nodiscard]] double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Hausdorff distance of two polylines, up to the vertices' spacing: vertices to segments, both
/// ways.
[[nodiscard]] double largestDistance(const SurfacePolyline& a, const SurfacePolyline& b);

[[nodiscard]] double length(const SurfacePolyline& line);

/// Number of turns about the z axis through `centre`, of a closed polyline.
[[nodiscard]] double turnsAboutZ(const SurfacePolyline& line, const Vec3& centre = Vec3::Zero());

/// Expects the contract of SurfacePolyline: every vertex in a face with coordinates in [0, 1] that
/// sum to 1, at the position that they name; consecutive vertices share a face and do not coincide;
/// parameters ascend from 0 (open: to 1).
void expectStrict(const Surface& surface, const SurfacePolyline& line);

/// Expects a strict polyline of a usable curve that passes the picks in order.
void expectGoodCurve(
    const CurveDesigner& designer, const Curve& curve, const std::vector<Vec3>& picks
);

/// Designs a curve and expects the above.
[[nodiscard]] Curve goodCurve(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const SolverOptions& options = {},
    const SamplingOptions& sampling = {}
);

[[nodiscard]] SolverOptions closedOptions();

}  // namespace bspline_curve::test_support
