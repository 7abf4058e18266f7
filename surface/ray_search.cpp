// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_tree.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace bspline_curve {

struct TriangleTree::RaySearch {
    const TriangleTree& tree;
    const Vec3& origin;
    const Vec3& direction;
    Vec3 inverse;
    int x = 0, y = 1, z = 2;  // z: where the ray goes most; the other two in an order of their own
    Vec3 shear;
    Hit best;

    RaySearch(const TriangleTree& searched, const Vec3& from, const Vec3& along)
        : tree(searched), origin(from), direction(along), inverse(along.cwiseInverse()) {
        direction.cwiseAbs().maxCoeff(&z);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        shear = Vec3(direction[x], direction[y], 1.0) / direction[z];
        best.distance = std::numeric_limits<double>::infinity();
    }

    // The distance at which the ray enters a box; infinite where it misses it. Boxes are taken a
    // little too large, so that rounding loses no triangle.
    [[nodiscard]] double entryOf(const Box& box) const {
        constexpr double kRounding = 1.0 + 8.0 * std::numeric_limits<double>::epsilon();
        double first = 0.0;
        double last = best.distance;
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0.0) {
                if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) {
                    return std::numeric_limits<double>::infinity();
                }
                continue;
            }
            double in = (box.low[axis] - origin[axis]) * inverse[axis];
            double out = (box.high[axis] - origin[axis]) * inverse[axis];
            if (in > out) {
                std::swap(in, out);
            }
            first = std::max(first, in);
            last = std::min(last, out * kRounding);
        }
        return first <= last * kRounding ? first : std::numeric_limits<double>::infinity();
    }

    void meet(int triangle) {
        std::array<double, 3> px;
        std::array<double, 3> py;
        std::array<double, 3> pz;
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = tree.vertices_[tree.triangles_[triangle][k]] - origin;
            px[k] = corner[x] - shear[0] * corner[z];
            py[k] = corner[y] - shear[1] * corner[z];
            pz[k] = shear[2] * corner[z];
        }
        // The neighbour across an edge finds the same value with the other sign.
        const Vec3 weights(
            px[2] * py[1] - py[2] * px[1],
            px[0] * py[2] - py[0] * px[2],
            px[1] * py[0] - py[1] * px[0]
        );
        const double sum = weights.sum();
        if ((weights.minCoeff() < 0.0 && weights.maxCoeff() > 0.0) || sum == 0.0) {
            return;
        }
        const Vec3 barycentric = weights / sum;
        const double distance = barycentric.dot(Vec3(pz[0], pz[1], pz[2]));
        if (distance < 0.0 || distance > best.distance ||
            (distance == best.distance && triangle > best.point.face)) {
            return;
        }
        best.point = {triangle, barycentric};
        best.distance = distance;
    }

    void run() {
        struct Pending {
            int node;
            double entry;
        };

        std::array<Pending, kStackSize> stack;
        std::size_t stackSize = 0;
        const auto push = [&](const Pending& pending) {
            if (std::isfinite(pending.entry)) {
                stack[stackSize++] = pending;
            }
        };
        push({0, entryOf(tree.node(0).box)});
        while (stackSize > 0) {
            const Pending current = stack[--stackSize];
            if (current.entry > best.distance) {
                continue;
            }
            const Node& here = tree.node(current.node);
            if (here.isLeaf()) {
                for (int i = here.first; i < here.first + here.count; ++i) {
                    meet(tree.order_[i]);
                }
                continue;
            }
            Pending nearer{current.node + 1, entryOf(tree.node(current.node + 1).box)};
            Pending farther{here.first, entryOf(tree.node(here.first).box)};
            if (farther.entry < nearer.entry) {
                std::swap(nearer, farther);
            }
            push(farther);
            push(nearer);
        }
    }
};

TriangleTree::Hit TriangleTree::firstHit(const Vec3& origin, const Vec3& direction) const {
    if (nodes_.empty() || direction.isZero(0.0)) {
        return {};
    }
    RaySearch search(*this, origin, direction);
    search.run();
    Hit hit = search.best;
    if (hit.point.face < 0) {
        return {};
    }
    const Triangle& corners = triangles_[hit.point.face];
    for (int k = 0; k < 3; ++k) {
        hit.position += hit.point.barycentric[k] * vertices_[corners[k]];
    }
    return hit;
}

}  // namespace bspline_curve
