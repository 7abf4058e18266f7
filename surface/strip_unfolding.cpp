// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_unfolding.h"

#include "surface/plane_vectors.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bspline_curve {
namespace {

using Vec2 = Eigen::Vector2d;

// The apex of a triangle over the base from a to b (2D), on its left, from the 3D triangle.
Vec2 unfoldApex(const Vec2& a, const Vec2& b, const Vec3& a3, const Vec3& b3, const Vec3& c3) {
    const Vec3 base = b3 - a3;
    const double squared = base.squaredNorm();
    const double along = base.dot(c3 - a3) / squared;
    const double above = base.cross(c3 - a3).norm() / squared;
    const Vec2 e = b - a;
    return a + along * e + above * Vec2(-e.y(), e.x());
}

Vec2 place(const Vec3& barycentric, const std::array<Vec2, 3>& corners) {
    return barycentric[0] * corners[0] + barycentric[1] * corners[1] + barycentric[2] * corners[2];
}

// Portals of the strip in the plane, and the two end points.
struct Unfolding {
    std::vector<Vec2> left, right;
    Vec2 start, goal;
};

// Unfolds a strip, and lists the vertices of its portals in the path.
Unfolding unfold(
    const Surface& surface,
    const std::vector<int>& strip,
    const SurfacePoint& start,
    const SurfacePoint& goal,
    StripPath& path
) {
    const auto position = [&](int vertex) -> const Vec3& { return surface.vertices()[vertex]; };
    Unfolding result;
    // The first face lies in the plane with corner 0 at the origin and corner 1 on the x axis.
    const auto& [a, b, c] = surface.faces()[strip.front()];
    std::array<Vec2, 3> corners;
    corners[0] = Vec2::Zero();
    corners[1] = Vec2((position(b) - position(a)).norm(), 0.0);
    corners[2] = unfoldApex(corners[0], corners[1], position(a), position(b), position(c));
    result.start = place(start.barycentric, corners);
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
        const Triangle& here = surface.faces()[strip[i]];
        const Triangle& there = surface.faces()[strip[i + 1]];
        std::size_t k = 0;
        while (surface.faceNeighbours()[strip[i]][k] != strip[i + 1]) {
            ++k;
        }
        // Leaving a counter-clockwise face over the edge from corner k+1 to k+2, that edge runs
        // from right to left.
        const std::size_t r = (k + 1) % 3;
        const std::size_t l = (k + 2) % 3;
        result.left.push_back(corners[l]);
        result.right.push_back(corners[r]);
        path.lefts.push_back(here[l]);
        path.rights.push_back(here[r]);
        std::array<Vec2, 3> next;
        const int cl = cornerOf(there, here[l]);
        const int cr = cornerOf(there, here[r]);
        const int apex = 3 - cl - cr;
        next[cl] = corners[l];
        next[cr] = corners[r];
        next[apex] = unfoldApex(
            corners[l], corners[r], position(here[l]), position(here[r]), position(there[apex])
        );
        corners = next;
    }
    result.goal = place(goal.barycentric, corners);
    return result;
}

struct FunnelCorner {
    Vec2 position;
    std::size_t portal;
    bool onLeft;
};

// A portal that makes a smaller angle with the path (its sine) lies along it: the crossing is lost
// in rounding, and any point of the portal is on the path up to the square of the angle.
constexpr double kAlong = 1e-7;

// Where the path from `from` to `to` crosses the portal from left to right: 0 at its left end, 1 at
// its right. On a portal along the path: as near to the last crossing as can be, so that the path
// does not turn back.
double crossingOf(
    const Vec2& left, const Vec2& right, const Vec2& from, const Vec2& to, const Vec2& last
) {
    const Vec2 edge = right - left;
    const double denominator = cross(edge, to - from);
    const double s = std::abs(denominator) > kAlong * edge.norm() * (to - from).norm()
                         ? cross(from - left, to - from) / denominator
                         : edge.dot(last - left) / edge.squaredNorm();
    return std::min(1.0, std::max(0.0, s));
}

// The corners of the shortest path, in order, without its ends. No portal may touch the start or
// the goal.
class Funnel {
public:
    explicit Funnel(const Unfolding& unfolding) : u_(unfolding), apex_(unfolding.start) {}

    std::vector<FunnelCorner> pullTight() {
        const std::size_t count = u_.left.size();
        for (std::size_t i = 0; i < count; ++i) {
            // The right side narrows to the left; where it would pass the left side, that side's
            // end is a corner.
            if (!right_ || cross(*right_ - apex_, u_.right[i] - apex_) >= 0.0) {
                if (left_ && cross(*left_ - apex_, u_.right[i] - apex_) >= 0.0) {
                    i = turnAt(*left_, leftPortal_, true);
                    continue;
                }
                right_ = u_.right[i];
                rightPortal_ = i;
            }
            if (!left_ || cross(*left_ - apex_, u_.left[i] - apex_) <= 0.0) {
                if (right_ && cross(*right_ - apex_, u_.left[i] - apex_) <= 0.0) {
                    i = turnAt(*right_, rightPortal_, false);
                    continue;
                }
                left_ = u_.left[i];
                leftPortal_ = i;
            }
            // Narrowed to the last portal: does the goal lie in the funnel?
            while (i + 1 == count) {
                if (left_ && cross(*left_ - apex_, u_.goal - apex_) >= 0.0) {
                    i = turnAt(*left_, leftPortal_, true);
                } else if (right_ && cross(*right_ - apex_, u_.goal - apex_) <= 0.0) {
                    i = turnAt(*right_, rightPortal_, false);
                } else {
                    return corners_;
                }
            }
        }
        return corners_;
    }

private:
    // Restarts the funnel at a corner; returns the last portal that touches it.
    // The corner is a copy: it may be the very side that is reset here.
    // NOLINTNEXTLINE(performance-unnecessary-value-param)
    std::size_t turnAt(Vec2 corner, std::size_t portal, bool onLeft) {
        corners_.push_back({corner, portal, onLeft});
        apex_ = corner;
        left_.reset();
        right_.reset();
        const std::vector<Vec2>& side = onLeft ? u_.left : u_.right;
        while (portal + 1 < side.size() && side[portal + 1] == corner) {
            ++portal;
        }
        return portal;
    }

    const Unfolding& u_;
    Vec2 apex_;
    std::optional<Vec2> left_, right_;
    std::size_t leftPortal_ = 0, rightPortal_ = 0;
    std::vector<FunnelCorner> corners_;
};

}  // namespace

StripPath shortestPathInStrip(
    const Surface& surface,
    const std::vector<int>& strip,
    const SurfacePoint& start,
    const SurfacePoint& goal
) {
    StripPath path;
    const Unfolding u = unfold(surface, strip, start, goal, path);
    const std::vector<FunnelCorner> corners = Funnel(u).pullTight();

    const std::size_t count = u.left.size();
    path.crossings.assign(count, 0.5);
    Vec2 from = u.start;
    Vec2 last = u.start;
    std::size_t portal = 0;
    for (std::size_t c = 0; c <= corners.size(); ++c) {
        const Vec2 to = c < corners.size() ? corners[c].position : u.goal;
        const std::size_t end = c < corners.size() ? corners[c].portal : count;
        for (; portal < end; ++portal) {
            const double s = crossingOf(u.left[portal], u.right[portal], from, to, last);
            path.crossings[portal] = s;
            last = (1.0 - s) * u.left[portal] + s * u.right[portal];
        }
        if (c == corners.size()) {
            break;
        }
        path.crossings[portal++] = corners[c].onLeft ? 0.0 : 1.0;
        const Vec2 next = c + 1 < corners.size() ? corners[c + 1].position : u.goal;
        const double turn = std::atan2(cross(to - from, next - to), (to - from).dot(next - to));
        const std::vector<int>& side = corners[c].onLeft ? path.lefts : path.rights;
        path.corners.push_back({corners[c].portal, side[corners[c].portal], std::abs(turn)});
        from = to;
        last = to;
    }
    return path;
}

}  // namespace bspline_curve
