// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/surface_walk.h"

#include <algorithm>
#include <array>

namespace bspline_curve {
namespace {

struct WalkConstants {
    double sameShare = 0.3;  // of the way: points nearer to each other are one
    int shortSteps = 8;      // that are walked in, where one step does not lead over it
};

constexpr WalkConstants kWalk;

}  // namespace

bool areJoined(
    const ExtendedSurface& extended,
    const FibreProjector& finder,
    const SurfaceNode& from,
    const SurfaceNode& to
) {
    const Vec3 way = to.position - from.position;
    return std::ranges::any_of(std::array{1, kWalk.shortSteps}, [&](int steps) {
        FootPoint foot = from.foot;
        FootFrame frame = from.frame;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            finder.move(from.position + share * way, foot, frame);
        }
        const Vec3 end = extended.position({foot.face, foot.barycentric()});
        return (end - to.position).norm() <= kWalk.sameShare * way.norm() &&
               frame.direction.dot(to.frame.direction) > 0.0;
    });
}

}  // namespace bspline_curve
