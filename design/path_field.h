// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/field_cost.h"

#include <span>

namespace bspline_curve {

/// A field that draws a path: the mean of c(I) along it, times the weight, is added to what it
/// minimises. Empty: none.
struct PathField {
    std::span<const double> values;  ///< I at each vertex of the extended surface
    FieldCost cost = FieldCost::Identity;
    double weight = 0.0;

    [[nodiscard]] bool empty() const { return values.empty(); }
};

}  // namespace bspline_curve
