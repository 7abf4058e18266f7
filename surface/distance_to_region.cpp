// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/distance_to_region.h"

#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace bspline_curve {
namespace {

// A vertex that the front has reached.
struct Reached {
    const Vec3& position;
    double distance;
};

// The distance of c where a straight front comes over the edge from a to b; infinite where its ray
// to c misses that edge.
double behindEdge(const Reached& a, const Reached& b, const Vec3& c) {
    const Vec3 edge = b.position - a.position;
    const double length = edge.norm();
    const double along = edge.dot(c - a.position) / length;
    const double above = edge.cross(c - a.position).norm() / length;
    const double slope = (b.distance - a.distance) / length;
    const double rise = std::sqrt(std::max(0.0, 1.0 - slope * slope));
    const double foot = along * rise - above * slope;  // where the ray crosses the edge, times rise
    return foot >= 0.0 && foot <= length * rise && rise > 0.0
               ? a.distance + slope * along + rise * above
               : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> distancesToRegion(const Surface& surface, const Region& region, double reach) {
    std::vector<double> distances(surface.vertices().size(), reach);
    std::vector<char> isFinal(surface.vertices().size(), 0);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto offer = [&](int v, double distance) {
        if (distance < distances[v]) {
            distances[v] = distance;
            queue.emplace(distance, v);
        }
    };
    const auto reached = [&](int v) { return Reached{surface.vertices()[v], distances[v]}; };
    // From a vertex along an edge, and through the face behind it where its other vertex is known.
    const auto pass = [&](int from, int target, int other) {
        if (isFinal[target] != 0) {
            return;
        }
        const Vec3& position = surface.vertices()[target];
        const Reached here = reached(from);
        offer(target, here.distance + (position - here.position).norm());
        if (isFinal[other] != 0) {
            offer(target, behindEdge(here, reached(other), position));
        }
    };

    for (const int f : region) {
        for (const int v : surface.faces()[f]) {
            offer(v, 0.0);
        }
    }
    while (!queue.empty()) {
        const int v = queue.top().second;
        queue.pop();
        if (std::exchange(isFinal[v], 1) != 0) {
            continue;
        }
        for (const int f : surface.facesAround(v)) {
            const Triangle& face = surface.faces()[f];
            const int k = cornerOf(face, v);
            const int a = face[(k + 1) % 3];
            const int b = face[(k + 2) % 3];
            pass(v, a, b);
            pass(v, b, a);
        }
    }
    return distances;
}

}  // namespace bspline_curve
