// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/random_curves.h"

#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve::test_support {

SurfacePolyline polylineThrough(
    const Surface& surface, const std::vector<SurfacePoint>& points, bool closed
) {
    SurfacePolyline line;
    line.closed = closed;
    line.surfacePoints = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        line.points.push_back(surface.position(points[i]));
        line.parameters.push_back(static_cast<double>(i) / static_cast<double>(points.size()));
    }
    return line;
}

SurfacePolyline polylineAlong(
    const Surface& surface, const std::vector<int>& vertices, bool closed
) {
    std::vector<SurfacePoint> points;
    for (const int vertex : vertices) {
        SurfacePoint point{.face = *surface.facesAround(vertex).begin()};
        point.barycentric[cornerOf(surface.faces()[point.face], vertex)] = 1.0;
        points.push_back(point);
    }
    return polylineThrough(surface, points, closed);
}

SurfacePolyline alongGrid(
    const Surface& surface, int n, const std::vector<std::array<int, 2>>& grid, bool closed
) {
    std::vector<int> vertices;
    for (const auto& [i, j] : grid) {
        vertices.push_back(j * (n + 1) + i);
    }
    return polylineAlong(surface, vertices, closed);
}

namespace {

/// A point in a face: inside, on a side or at a corner; now and then hardly off a side.
SurfacePoint pointIn(int face, Random& random) {
    Vec3 barycentric = random.barycentric();
    const int kind = random.integer(0, 9);
    const int k = random.integer(0, 2);
    if (kind < 6) {
        barycentric[k] = 0.0;
    } else if (kind == 6) {
        barycentric = Vec3::Unit(k);
    } else if (kind == 7) {
        barycentric[k] = 1e-11;
    } else if (kind == 8) {
        barycentric[k] = 1e-7;
    }
    return {face, barycentric / barycentric.sum()};
}

SurfacePolyline walk(const Surface& surface, Random& random, int start) {
    std::vector<SurfacePoint> points{pointIn(start, random)};
    const int steps = random.integer(1, 25);
    for (int i = 0; i < steps; ++i) {
        const std::vector<int> faces = facesHolding(surface, points.back());
        const int face = faces[random.integer(0, static_cast<int>(faces.size()) - 1)];
        points.push_back(pointIn(face, random));
    }
    return polylineThrough(surface, points, false);
}

SurfacePolyline loopInFace(const Surface& surface, Random& random, int face) {
    std::vector<SurfacePoint> points;
    const int count = random.integer(3, 8);
    for (int i = 0; i < count; ++i) {
        points.push_back(pointIn(face, random));
    }
    return polylineThrough(surface, points, true);
}

SurfacePolyline loopRoundVertex(const Surface& surface, Random& random, int face) {
    const int vertex = surface.faces()[face][random.integer(0, 2)];
    if (surface.isBoundaryVertex(vertex)) {
        return loopInFace(surface, random, face);
    }
    std::vector<SurfacePoint> points;
    for (const int each : surface.facesAround(vertex)) {
        const int k = cornerOf(surface.faces()[each], vertex);
        SurfacePoint point{.face = each};
        point.barycentric[(k + 1) % 3] = random.uniform(0.05, 1.0);
        point.barycentric[k] = 1.0 - point.barycentric[(k + 1) % 3];
        points.push_back(point);
    }
    return polylineThrough(surface, points, true);
}

}  // namespace

SurfacePolyline randomCurve(const Surface& surface, Random& random) {
    const int face = random.integer(0, surface.faceCount() - 1);
    switch (random.integer(0, 3)) {
        case 0:
            return loopInFace(surface, random, face);
        case 1:
            return loopRoundVertex(surface, random, face);
        default:
            return walk(surface, random, face);
    }
}

std::vector<SurfacePolyline> randomCurves(const Surface& surface, Random& random) {
    std::vector<SurfacePolyline> curves;
    const int count = random.integer(1, 8);
    const int home = random.integer(0, surface.faceCount() - 1);
    for (int i = 0; i < count; ++i) {
        curves.push_back(
            i % 4 == 3   ? randomCurve(surface, random)
            : i % 4 == 2 ? loopRoundVertex(surface, random, home)
                         : walk(surface, random, home)
        );
    }
    return curves;
}

}  // namespace bspline_curve::test_support
