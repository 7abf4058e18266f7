// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/surface.h"

#include <functional>
#include <vector>

/// What tests ask of curves that follow a field.
namespace bspline_curve::test_support {

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
