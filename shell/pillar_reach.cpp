// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_reach.h"

#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

// Two sheets that face each other take this share of the gap each.
constexpr double kShareOfGap = 0.4;
// A line that passes a face this close beside its edges, in barycentric coordinates, still counts.
constexpr double kEdgeMargin = 1e-6;

// Where the line p + t d passes the triangle (a, b, c); 0 where it does not.
double lineParameter(const Vec3& p, const Vec3& d, const std::array<Vec3, 3>& corners) {
    const Vec3 e1 = corners[1] - corners[0];
    const Vec3 e2 = corners[2] - corners[0];
    const Vec3 normal = e1.cross(e2);
    const double slope = normal.dot(d);
    if (slope == 0.0) {
        return 0.0;
    }
    const Vec3 turn = d.cross(corners[0] - p) / slope;
    const double u = -e2.dot(turn);
    const double v = e1.dot(turn);
    return std::min({u, v, 1.0 - u - v}) < -kEdgeMargin ? 0.0 : normal.dot(corners[0] - p) / slope;
}

}  // namespace

void keepPillarsApart(
    const ExtendedSurface& extended, std::array<std::vector<double>, 2>& lengths
) {
    // One tree of the faces and of the pillars, which are triangles without area there.
    const auto n = static_cast<int>(extended.vertices.size());
    const auto faceCount = static_cast<int>(extended.faces.size());
    std::vector<Vec3> points = extended.vertices;
    for (const int side : {0, 1}) {
        for (int v = 0; v < n; ++v) {
            const double reach = (side == 0 ? 1.0 : -1.0) * lengths[side][v];
            points.emplace_back(extended.vertices[v] + reach * extended.directions[v]);
        }
    }
    std::vector<Triangle> triangles = extended.faces;
    for (int v = 0; v < n; ++v) {
        triangles.push_back({v, n + v, 2 * n + v});
    }
    const std::array<std::vector<double>, 2> wanted = lengths;
    const TriangleTree tree(points, triangles);
    tree.forEachOverlappingPair([&](int i, int j) {
        if (i >= faceCount || j < faceCount) {
            return;
        }
        const int v = j - faceCount;
        const Triangle& face = extended.faces[i];
        if (std::find(face.begin(), face.end(), v) != face.end()) {
            return;
        }
        const double t = lineParameter(
            extended.vertices[v],
            extended.directions[v],
            {extended.vertices[face[0]], extended.vertices[face[1]], extended.vertices[face[2]]}
        );
        const std::size_t side = t > 0.0 ? 0 : 1;
        if (t != 0.0 && std::abs(t) <= wanted[side][v]) {
            lengths[side][v] = std::min(lengths[side][v], kShareOfGap * std::abs(t));
        }
    });
}

}  // namespace bspline_curve
