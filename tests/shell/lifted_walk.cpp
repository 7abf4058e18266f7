// SPDX-License-Identifier: GPL-3.0-or-later
#include "lifted_walk.h"

#include "shell/extended_surface.h"

namespace bspline_curve::test_support {
namespace {

// Of the way along a fibre between two heights: straight, else in two halves, so that where the
// shell's top or bottom is not convex steps become as short as the fibre's straight pieces.
constexpr int kMostHalvings = 16;

}  // namespace

bool walkUp(
    const Shell& shell,
    const ExtendedSurface& extended,
    const SurfacePoint& point,
    double w,
    TraceState& state
) {
    state = {ShellCell(shell, point)};
    Vec3 here = extended.position(point);
    const double start = state.cell.height.at(here);
    const int steps = 1 << kMostHalvings;
    int done = 0;
    int step = steps;
    while (done < steps) {
        const Vec3 next = shell.lift(point, start + (w - start) * (done + step) / steps);
        TraceState after = state;
        if (walkStraight(shell, here, next, after)) {
            state = after;
            here = next;
            done += step;
            continue;
        }
        if (step == 1) {
            return false;
        }
        step /= 2;
    }
    return true;
}

}  // namespace bspline_curve::test_support
