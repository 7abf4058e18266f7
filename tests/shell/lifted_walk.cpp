// SPDX-License-Identifier: GPL-3.0-or-later
#include "lifted_walk.h"

#include "shell/shell_base.h"

namespace bspline_curve::test_support {

bool walkUp(
    const Shell& shell,
    const ShellBase& base,
    const SurfacePoint& point,
    double w,
    TraceState& state
) {
    state = {ShellCell(shell, point)};
    const Vec3 from = base.position(point);
    if (walkStraight(shell, from, shell.lift(point, w), state)) {
        return true;
    }
    state = {ShellCell(shell, point)};
    constexpr int kSteps = 40;
    const double start = state.cell.height.at(from);
    Vec3 here = from;
    for (int i = 1; i <= kSteps; ++i) {
        const Vec3 next = shell.lift(point, start + (w - start) * i / kSteps);
        if (!walkStraight(shell, here, next, state)) {
            return false;
        }
        here = next;
    }
    return true;
}

}  // namespace bspline_curve::test_support
