// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shell_reach.h"

#include "bspline_curve/shell.h"
#include "shell/shell_cell.h"

#include <algorithm>

namespace bspline_curve {

double relativeReach(const CurveProblem& problem) {
    if (problem.shell->isFullResolution()) {
        return 1.0;
    }
    double reach = 0.0;
    for (const PickConstraint& pick : problem.picks) {
        // On the surface the relative height has the gradient (grad w - grad w_S) / (1 - w_S^2).
        const ShellCell cell(*problem.shell, pick.point);
        const double height = cell.surfaceHeight.at(pick.position);
        reach +=
            (1.0 - height * height) / (cell.height.gradient - cell.surfaceHeight.gradient).norm();
    }
    reach /= static_cast<double>(problem.picks.size());
    return std::max(1.0, reach / (ShellOptions{}.thickness * problem.averageEdgeLength));
}

}  // namespace bspline_curve
