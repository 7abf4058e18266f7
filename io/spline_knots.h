// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace bspline_curve {

/// A knot, and how often it stands in a knot vector.
struct RepeatedKnot {
    double knot = 0.0;
    int multiplicity = 0;
};

/// Equal neighbours of a knot vector as one.
[[nodiscard]] inline std::vector<RepeatedKnot> repeatedKnots(const std::vector<double>& knots) {
    std::vector<RepeatedKnot> repeated;
    for (const double knot : knots) {
        if (repeated.empty() || repeated.back().knot != knot) {
            repeated.push_back({.knot = knot, .multiplicity = 0});
        }
        ++repeated.back().multiplicity;
    }
    return repeated;
}

}  // namespace bspline_curve
