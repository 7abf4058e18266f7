// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve_designer.h"
#include "support/meshes.h"
#include "support/places.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <tuple>
#include <vector>

/// What tests of curves share: designers in shells of every kind, and what is asked of a curve,
/// judged from the outside by SplineData and SurfacePolyline alone.
namespace bspline_curve::test_support {

// ---- Shells of every kind ----

[[nodiscard]] CurveDesigner designerIn(ShellKind kind, TriangleMesh mesh);

/// Tests that hold in shells of every kind.
class EitherShell : public testing::TestWithParam<ShellKind> {
protected:
    [[nodiscard]] static CurveDesigner designerOn(TriangleMesh mesh);
};

inline const auto kEitherShell =
    testing::Values(ShellKind::Local, ShellKind::FullResolution, ShellKind::Simplified);

[[nodiscard]] std::string nameOf(ShellKind kind);
[[nodiscard]] std::string nameOfShell(const testing::TestParamInfo<ShellKind>& instance);

// ---- Curves ----

/// The exported spline at t, by de Boor's algorithm on its full knot vector.
[[nodiscard]] Vec3 pointOfSpline(const SplineData& spline, double t);

/// Largest distance of two splines at the same of `count` parameters; where `reversed`, of the
/// second at 1 - t.
[[nodiscard]] double largestGap(
    const SplineData& a, const SplineData& b, bool reversed = false, int count = 500
);

[[nodiscard]] double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

[[nodiscard]] double distanceToPolyline(const Vec3& p, const SurfacePolyline& line);

/// Hausdorff distance of two polylines, up to the vertices' spacing: vertices to segments, both
/// ways.
[[nodiscard]] double largestDistance(const SurfacePolyline& a, const SurfacePolyline& b);

[[nodiscard]] double length(const std::vector<Vec3>& points);
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
Curve goodCurve(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const SolverOptions& options = {},
    const CurveInputs& inputs = {}
);

/// Expects the same spline and the same polyline, to the last bit.
void expectSameBits(const Curve& curve, const Curve& reference);

// ---- Curves that follow a field ----

/// The values of a function at the vertices of a mesh.
[[nodiscard]] std::vector<double> sampled(
    const TriangleMesh& mesh, const std::function<double(const Vec3&)>& function
);

/// A field given at the vertices, at a point of the surface.
[[nodiscard]] double valueAt(
    const Surface& surface, const SurfacePoint& point, const std::vector<double>& field
);

/// Mean of a field given at the vertices, over the length of an open polyline.
[[nodiscard]] double meanAlong(
    const Surface& surface, const SurfacePolyline& line, const std::vector<double>& field
);

/// Mean of a function of the position over the length of an open polyline, where `isCounted` at
/// both ends of a segment.
[[nodiscard]] double meanWhere(
    const SurfacePolyline& line,
    const std::function<double(const Vec3&)>& function,
    const std::function<bool(const Vec3&)>& isCounted = [](const Vec3&) { return true; }
);

}  // namespace bspline_curve::test_support
