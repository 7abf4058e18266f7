// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solution.h"

#include <stdexcept>

namespace bspline_curve {

std::vector<int> facesPassed(const Solution& solution) {
    if (!solution.trace) {
        throw std::logic_error("the faces passed were asked of a curve without a trace");
    }
    return facesPassed(*solution.trace);
}

}  // namespace bspline_curve
