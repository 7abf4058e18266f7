// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/hit_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {
namespace {

// So many pixels behind the surface a point is still seen.
constexpr double kDepthSlack = 12.0;

class Nearest {
public:
    Nearest(const Pointer& pointer, const TriangleTree::Hit& seen)
        : pointer_(pointer), seen_(seen) {}

    // Distance of a point to the ray in pixels; infinite where the surface hides it.
    [[nodiscard]] double pixelsTo(const Vec3& point) const {
        if (!isInSight(pointer_, seen_, point)) {
            return std::numeric_limits<double>::infinity();
        }
        const Vec3 way = point - pointer_.start;
        const double along = way.dot(pointer_.direction);
        return (way - along * pointer_.direction).norm() / pointer_.pixelAt(along);
    }

    // The same of the segment's point nearest to the ray.
    [[nodiscard]] double pixelsTo(const Vec3& a, const Vec3& b) const {
        const auto flat = [this](const Vec3& v) -> Vec3 {
            return v - v.dot(pointer_.direction) * pointer_.direction;
        };
        const Vec3 from = flat(a - pointer_.start);
        const Vec3 way = flat(b - a);
        const double squared = way.squaredNorm();
        const double s = squared > 0.0 ? std::clamp(-from.dot(way) / squared, 0.0, 1.0) : 0.0;
        return pixelsTo(a + s * (b - a));
    }

private:
    const Pointer& pointer_;
    const TriangleTree::Hit& seen_;
};

// The pick before a segment of the polyline.
int pickBefore(const SurfacePolyline& line, int segment) {
    const auto above = std::ranges::upper_bound(line.picks, segment);
    const auto count = static_cast<int>(line.picks.size());
    return (static_cast<int>(above - line.picks.begin()) + count - 1) % count;
}

}  // namespace

bool isInSight(const Pointer& pointer, const TriangleTree::Hit& seen, const Vec3& point) {
    const double along = (point - pointer.start).dot(pointer.direction);
    return along > 0.0 &&
           (seen.point.face < 0 || along <= seen.distance + kDepthSlack * pointer.pixelAt(along));
}

SketchHit hitTest(
    const Sketch& sketch,
    const Pointer& pointer,
    const TriangleTree::Hit& seen,
    const HitRadii& radii
) {
    const Nearest nearest(pointer, seen);
    std::vector<int> order;
    if (sketch.active >= 0 && !sketch.activeCurve()->look.isHidden) {
        order.push_back(sketch.active);
    }
    for (int i = 0; i < static_cast<int>(sketch.curves.size()); ++i) {
        if (i != sketch.active && !sketch.curves[i]->look.isHidden) {
            order.push_back(i);
        }
    }
    SketchHit hit;
    double least = radii.pick;
    for (const int c : order) {
        const std::vector<SketchPick>& picks = sketch.curves[c]->picks;
        for (int i = 0; i < static_cast<int>(picks.size()); ++i) {
            const double pixels = nearest.pixelsTo(picks[i].position);
            if (pixels < least) {
                least = pixels;
                hit = {c, i, -1};
            }
        }
    }
    if (hit.curve >= 0) {
        return hit;
    }
    least = radii.curve;
    for (const int c : order) {
        const std::shared_ptr<const Curve>& curve = sketch.curves[c]->settled;
        if (curve == nullptr) {
            continue;
        }
        const SurfacePolyline& line = curve->polyline;
        const auto count = static_cast<int>(line.points.size());
        for (int i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
            const double pixels = nearest.pixelsTo(line.points[i], line.points[(i + 1) % count]);
            if (pixels < least) {
                least = pixels;
                hit = {c, -1, pickBefore(line, i)};
            }
        }
    }
    return hit;
}

}  // namespace bspline_curve
