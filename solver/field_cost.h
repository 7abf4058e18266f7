// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

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
        case FieldCost::Natural:  // of values themselves
            break;
    }
    return {x, 1.0, 0.0};
}

/// What c(I) of (5) is over the vertices of a surface.
struct FieldCosts {
    double least = 0.0;
    double meanExcess = 0.0;  ///< over the least; 0 exactly where all cost the same
};

/// c(I) at each vertex.
[[nodiscard]] inline std::vector<double> vertexCostsOf(
    std::span<const double> field, FieldCost kind
) {
    std::vector<double> costs;
    costs.reserve(field.size());
    for (const double value : field) {
        costs.push_back(fieldCost(kind, value).value);
    }
    return costs;
}

/// 0 where there is no field.
[[nodiscard]] inline FieldCosts summaryOf(std::span<const double> vertexCosts) {
    FieldCosts costs;
    if (!vertexCosts.empty()) {
        costs.least = std::ranges::min(vertexCosts);
    }
    for (const double cost : vertexCosts) {
        costs.meanExcess += (cost - costs.least) / static_cast<double>(vertexCosts.size());
    }
    return costs;
}

/// Share of what the field costs over its least cost that counts where changes are measured against
/// the energy: most of it stays whatever the curve does. 1e-6 took a tenth more iterations for the
/// same curves, 1 left curves beside their valleys.
inline constexpr double kFieldShare = 0.2;

/// E_int of a usual curve without a field: it is about the square of the angle, in radians, by
/// which the curve turns, and 5 to 400 on scans. Paths and first weights measure fields against it.
inline constexpr double kUsualBending = 200.0;

}  // namespace bspline_curve
