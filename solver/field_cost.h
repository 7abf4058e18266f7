// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/options.h"

#include <cmath>

namespace bspline_curve {

/// c(x) of (5) with its derivatives by x.
struct FieldCostValue {
    double value, slope, curvature;
};

[[nodiscard]] inline FieldCostValue fieldCost(FieldCost kind, double x) {
    switch (kind) {
        case FieldCost::Square:
            return {x * x, 2.0 * x, 2.0};
        case FieldCost::ExpMinus: {
            const double value = std::exp(-x);
            return {value, -value, value};
        }
        case FieldCost::Identity:
            break;
    }
    return {x, 1.0, 0.0};
}

}  // namespace bspline_curve
