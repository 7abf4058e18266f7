// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/places.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve::test_support {

TestSurface::TestSurface(TriangleMesh mesh)
    : surface(std::move(mesh)),
      extended(extendSurface(surface, 3)),
      tree(surface.vertices(), surface.faces()) {}

SurfacePoint TestSurface::nearest(const Vec3& user) const {
    return tree.closestPoint(user).point;
}

std::vector<SurfacePoint> TestSurface::nearest(const std::vector<Vec3>& points) const {
    std::vector<SurfacePoint> result;
    for (const Vec3& point : points) {
        result.push_back(nearest(point));
    }
    return result;
}

std::vector<Vec3> TestSurface::positions(const std::vector<SurfacePoint>& points) const {
    std::vector<Vec3> result;
    for (const SurfacePoint& point : points) {
        result.push_back(surface.position(point));
    }
    return result;
}

double TestSurface::farthestChord(const std::vector<Vec3>& points) const {
    double most = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 middle = 0.5 * (points[i - 1] + points[i]);
        most = std::max(most, std::sqrt(tree.closestPoint(middle).squaredDistance));
    }
    return most;
}

std::vector<Vec3> onSurface(const TriangleMesh& mesh, std::vector<Vec3> points) {
    const TriangleTree tree(mesh.vertices, mesh.faces);
    for (Vec3& p : points) {
        p = tree.closestPoint(p).position;
    }
    return points;
}

std::vector<Vec3> verticesOf(const TriangleMesh& mesh, const std::vector<int>& indices) {
    std::vector<Vec3> result;
    for (const int i : indices) {
        result.push_back(mesh.vertices[i]);
    }
    return result;
}

std::vector<Vec3> verticesNear(const std::vector<Vec3>& vertices, std::vector<Vec3> points) {
    for (Vec3& p : points) {
        p = *std::ranges::min_element(vertices, {}, [&](const Vec3& v) {
            return (v - p).squaredNorm();
        });
    }
    return points;
}

Predicate ball(const Vec3& centre, double radius) {
    return [=](const Vec3& p) { return (p - centre).norm() < radius; };
}

Region facesWhere(const Surface& surface, const Predicate& isIn) {
    Region region;
    for (int f = 0; f < surface.faceCount(); ++f) {
        if (isIn(surface.position({f, Vec3::Constant(1.0 / 3.0)}))) {
            region.push_back(f);
        }
    }
    return region;
}

TriangleMesh withoutFaces(TriangleMesh mesh, const Predicate& isIn) {
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        const auto& [a, b, c] = face;
        return isIn((mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0);
    });
    return mesh;
}

std::ostream& operator<<(std::ostream& stream, const CurveCase& scene) {
    return stream << scene.name;
}

}  // namespace bspline_curve::test_support
