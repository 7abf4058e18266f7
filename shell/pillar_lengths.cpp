// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_lengths.h"

#include "bspline_curve/progress.h"
#include "shell/face_geometry.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bspline_curve {
namespace {

// Two sheets that face each other take this share of the gap each.
constexpr double kShareOfGap = 0.4;
// Margin of intersections beside an edge, in barycentric coordinates: no gap between two faces.
constexpr double kEdgeMargin = 1e-6;
// Progress is reported after so many pairs of triangles: milliseconds.
constexpr std::size_t kPairsPerReport = 100000;

}  // namespace

void limitPillarLengths(
    const ExtendedSurface& extended,
    std::array<std::vector<double>, 2>& lengths,
    const Progress& progress
) {
    report(progress, 0.0, "placing pillars");
    // One tree of the faces and of the pillars, which are triangles without area there.
    const auto n = static_cast<int>(extended.vertices.size());
    const auto faceCount = static_cast<int>(extended.faces.size());
    std::vector<Vec3> points = extended.vertices;
    for (const int side : {0, 1}) {
        for (int v = 0; v < n; ++v) {
            const double length = (side == 0 ? 1.0 : -1.0) * lengths[side][v];
            points.emplace_back(extended.vertices[v] + length * extended.directions[v]);
        }
    }
    std::vector<Triangle> triangles = extended.faces;
    for (int v = 0; v < n; ++v) {
        triangles.push_back({v, n + v, 2 * n + v});
    }
    const std::array<std::vector<double>, 2> wanted = lengths;
    const TriangleTree tree(points, triangles);
    std::size_t visited = 0;
    tree.forEachOverlappingPair([&](int face, int j) {
        if (visited++ % kPairsPerReport == 0) {
            report(progress, 0.5, "placing pillars");
        }
        const int v = j - faceCount;
        if (face >= faceCount || v < 0 || cornerOf(extended.faces[face], v) >= 0) {
            return;
        }
        const double t =
            intersectLine(
                extended.vertices[v], extended.directions[v], cornersOf(extended, face), kEdgeMargin
            )
                .value_or(0.0);
        const std::size_t side = t > 0.0 ? 0 : 1;
        if (t != 0.0 && std::abs(t) <= wanted[side][v]) {
            lengths[side][v] = std::min(lengths[side][v], kShareOfGap * std::abs(t));
        }
    });
}

}  // namespace bspline_curve
