// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <vector>

namespace bspline_curve::test_support {

/// An interpolating cubic spline by its second derivatives at the knots (the moments): no
/// B-splines, no energies.
class CubicInterpolation {
public:
    /// Second derivatives vanish at both ends.
    static CubicInterpolation natural(std::vector<double> knots, std::vector<Vec3> points);
    /// Period 1: the last interval leads from the last point back to the first.
    static CubicInterpolation periodic(std::vector<double> knots, std::vector<Vec3> points);

    [[nodiscard]] Vec3 at(double t) const;

private:
    std::vector<double> knots_;
    std::vector<Vec3> points_, moments_;
};

}  // namespace bspline_curve::test_support
