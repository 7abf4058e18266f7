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

class Marcher {
public:
    Marcher(const Surface& surface, double reach)
        : surface_(surface),
          distances_(surface.vertices().size(), reach),
          isFinal_(surface.vertices().size(), 0) {}

    std::vector<double> marchFrom(const Region& region) {
        for (const int f : region) {
            for (const int v : surface_.faces()[f]) {
                offer(v, 0.0);
            }
        }
        while (!queue_.empty()) {
            const int v = queue_.top().second;
            queue_.pop();
            if (isFinal_[v] != 0) {
                continue;
            }
            isFinal_[v] = 1;
            for (const int f : surface_.facesAround(v)) {
                pass(surface_.faces()[f], v);
            }
        }
        return std::move(distances_);
    }

private:
    using Entry = std::pair<double, int>;

    [[nodiscard]] Reached reached(int v) const { return {surface_.vertices()[v], distances_[v]}; }

    void offer(int v, double distance) {
        if (distance < distances_[v]) {
            distances_[v] = distance;
            queue_.emplace(distance, v);
        }
    }

    // From a vertex along the edges of a face, and through the face where another is known.
    void pass(const Triangle& face, int v) {
        const std::size_t k = (cornerOf(face, v));
        const std::array<int, 2> others = {face[(k + 1) % 3], face[(k + 2) % 3]};
        for (std::size_t i = 0; i < 2; ++i) {
            const int target = others[i];
            const int known = others[1 - i];
            if (isFinal_[target] != 0) {
                continue;
            }
            const Vec3& position = surface_.vertices()[target];
            const Reached here = reached(v);
            offer(target, here.distance + (position - here.position).norm());
            if (isFinal_[known] != 0) {
                offer(target, behindEdge(here, reached(known), position));
            }
        }
    }

    const Surface& surface_;
    std::vector<double> distances_;
    std::vector<char> isFinal_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<double> distancesToRegion(const Surface& surface, const Region& region, double reach) {
    return Marcher(surface, reach).marchFrom(region);
}

}  // namespace bspline_curve
