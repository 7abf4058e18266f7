// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solution.h"

#include <stdexcept>

namespace bspline_curve {

std::vector<int> facesPassed(const Solution& solution, const CurveProblem& problem) {
    if (!solution.trace) {
        throw std::logic_error("the faces passed were asked of a curve without a trace");
    }
    return solution.trace->faces(tracedShellOf(problem, solution.near.get()));
}

}  // namespace bspline_curve
