// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "shell/extended_surface.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

/// Where tests put picks, paths and regions.
namespace bspline_curve::test_support {

/// A surface with what seeks points on it.
struct TestSurface {
    explicit TestSurface(TriangleMesh mesh);

    /// The point of the surface nearest to a point of the user's space.
    [[nodiscard]] SurfacePoint nearest(const Vec3& user) const;
    [[nodiscard]] std::vector<SurfacePoint> nearest(const std::vector<Vec3>& points) const;
    /// In the user's space.
    [[nodiscard]] std::vector<Vec3> positions(const std::vector<SurfacePoint>& points) const;
    /// The farthest that midpoints of chords of a polyline lie from the surface.
    [[nodiscard]] double farthestChord(const std::vector<Vec3>& points) const;

    Surface surface;
    ExtendedSurface extended;
    TriangleTree tree;
};

/// The points of a mesh nearest to some others.
[[nodiscard]] std::vector<Vec3> onSurface(const TriangleMesh& mesh, std::vector<Vec3> points);
/// The vertices with some indices.
[[nodiscard]] std::vector<Vec3> verticesOf(
    const TriangleMesh& mesh, const std::vector<int>& indices
);
/// The vertices nearest to some points.
[[nodiscard]] std::vector<Vec3> verticesNear(
    const std::vector<Vec3>& vertices, std::vector<Vec3> points
);

using Predicate = std::function<bool(const Vec3&)>;

[[nodiscard]] Predicate ball(const Vec3& centre, double radius);
/// The faces whose centre is in a set.
[[nodiscard]] Region facesWhere(const Surface& surface, const Predicate& isIn);
/// The mesh without the faces whose centre is in a set.
[[nodiscard]] TriangleMesh withoutFaces(TriangleMesh mesh, const Predicate& isIn);

/// A curve to draw.
struct CurveCase {
    std::string name;
    TriangleMesh mesh;
    std::vector<Vec3> picks;
    SolverOptions options{};
};

/// For names of parameterised tests.
std::ostream& operator<<(std::ostream& stream, const CurveCase& scene);

/// Near the unit sphere.
inline const std::vector<Vec3> kSpherePicks = {
    {1, 0.1, 0.2}, {0.2, 1, 0.1}, {-0.7, 0.3, 0.7}, {-0.3, -0.9, 0.2}
};
/// Near a torus of the usual radii.
inline const std::vector<Vec3> kTorusPicks = {
    {1.3, 0.1, 0.1}, {0.1, 1.0, 0.3}, {-0.9, 0.5, -0.25}, {-0.8, -0.8, 0.2}
};

}  // namespace bspline_curve::test_support
