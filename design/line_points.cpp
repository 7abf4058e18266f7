// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/line_points.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace bspline_curve {
namespace {

/// The weights of edges differ from the mean one by no more than this factor: of faces that nearly
/// touch by their middles none is to stand for all.
constexpr double kMostWeight = 16.0;

// The vertex that a point lies on, or -1.
int vertexAt(const Surface& surface, const SurfacePoint& point) {
    for (int k = 0; k < 3; ++k) {
        if (std::max(point.barycentric[(k + 1) % 3], point.barycentric[(k + 2) % 3]) <=
            kSnapBarycentric) {
            return surface.faces()[point.face][k];
        }
    }
    return -1;
}

// The two faces beside the edge from one point to the other.
std::optional<std::array<int, 2>> facesBeside(
    const Surface& surface, const SurfacePoint& a, const SurfacePoint& b
) {
    const int from = vertexAt(surface, a);
    const int to = vertexAt(surface, b);
    if (from < 0 || to < 0 || from == to) {
        return std::nullopt;
    }
    const int face = commonFace(surface, a, b);
    if (face < 0) {
        return std::nullopt;
    }
    const Triangle& corners = surface.faces()[face];
    const int opposite = 3 - cornerOf(corners, from) - cornerOf(corners, to);
    const int other = surface.faceNeighbours()[face][opposite];
    return other < 0 ? std::nullopt : std::optional(std::array{face, other});
}

}  // namespace

double findLinePoints(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const PickConstraint> vertices,
    const PieceLengths& lengths,
    MeasuredLine& line
) {
    const double length = line.path.length();
    const std::size_t pieceCount = vertices.size() - (line.closed ? 0 : 1);
    const auto middleOf = [&](int face) {
        return extended.position({face, Vec3::Constant(1.0 / 3.0)});
    };

    struct EdgePoint {
        std::size_t index;
        double squaredGap;  // between the middles of the faces
    };

    std::vector<EdgePoint> alongEdges;
    double meanSquare = 0.0;
    double lengthAlongEdges = 0.0;
    for (std::size_t i = 0; i < pieceCount; ++i) {
        const bool isLast = i + 1 == vertices.size();
        const double from = vertices[i].parameter;
        const double to = isLast ? 1.0 : vertices[i + 1].parameter;
        const double piece = (to - from) * length;
        const auto beside =
            facesBeside(surface, vertices[i].point, vertices[isLast ? 0 : i + 1].point);
        if (beside) {
            const Vec3 left = middleOf((*beside)[0]);
            const Vec3 right = middleOf((*beside)[1]);
            alongEdges.push_back({line.points.size(), (right - left).squaredNorm()});
            meanSquare += alongEdges.back().squaredGap;
            lengthAlongEdges += piece;
            line.points.push_back({0.5 * (from + to), 0.5 * (left + right), 1.0});
            continue;
        }
        const int count = std::max(1, static_cast<int>(std::ceil(piece / lengths.longest)));
        const double weight = std::min(1.0, piece / lengths.whole);
        for (int k = 0; k < count; ++k) {
            const double parameter = std::lerp(from, to, (k + 0.5) / count);
            line.points.push_back({parameter, line.path.positionAt(parameter), weight});
        }
    }
    meanSquare /= static_cast<double>(std::max<std::size_t>(1, alongEdges.size()));
    for (const auto& [index, squaredGap] : alongEdges) {
        line.points[index].weight = squaredGap * kMostWeight > meanSquare
                                        ? std::max(meanSquare / squaredGap, 1.0 / kMostWeight)
                                        : kMostWeight;
    }
    return lengthAlongEdges / length;
}

}  // namespace bspline_curve
