// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/distances_to_lines.h"

#include "offset/distance_beams.h"
#include "surface/strict_line.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// A bound that rounding does not break.
constexpr double kSpare = 1.0 + 1e-6;

/// No vertex that a way leads to is farther: the longest of the shortest ways along edges.
double longestAlongEdges(const Surface& surface, std::span<const SurfacePolyline> lines) {
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    std::vector<double> lengths(surface.vertexCount(), kFar);
    const auto reach = [&](int vertex, double length) {
        if (length < lengths[vertex]) {
            lengths[vertex] = length;
            queue.emplace(length, vertex);
        }
    };
    for (const SurfacePolyline& line : lines) {
        for (const SurfacePoint& point : line.surfacePoints) {
            for (const int vertex : surface.faces()[point.face]) {
                reach(vertex, (surface.position(point) - surface.vertices()[vertex]).norm());
            }
        }
    }
    double longest = 0.0;
    while (!queue.empty()) {
        const auto [length, vertex] = queue.top();
        queue.pop();
        if (length > lengths[vertex]) {
            continue;
        }
        longest = length;
        for (const int face : surface.facesAround(vertex)) {
            for (const int next : surface.faces()[face]) {
                reach(
                    next, length + (surface.vertices()[next] - surface.vertices()[vertex]).norm()
                );
            }
        }
    }
    return longest * kSpare;
}

}  // namespace

std::vector<double> distancesToLines(
    const Surface& surface,
    std::span<const SurfacePolyline> lines,
    double reach,
    const Progress& progress
) {
    std::vector<SurfacePolyline> strict;
    for (const SurfacePolyline& line : lines) {
        strict.push_back(strictLine(surface, line, "line " + std::to_string(strict.size())));
    }
    // No beam is asked for anything but vertices, so that none is kept.
    const DistanceRange range{
        .from = kFar, .to = std::min(reach, longestAlongEdges(surface, strict))
    };
    const DistanceBeams beams(surface, strict, range, progress);
    std::vector<double> distances;
    for (const SidedDistance& vertex : beams.atVertices()) {
        distances.push_back(vertex.distance <= range.to ? vertex.distance : kFar);
    }
    // A vertex that mending doubled is as near as its nearest copy.
    const Provenance& provenance = surface.provenance();
    for (int v = 0; v < surface.vertexCount(); ++v) {
        double& of = distances[provenance.inputVertex(v)];
        of = std::min(of, distances[v]);
    }
    return provenance.valuesOfInput(std::move(distances));
}

}  // namespace bspline_curve
