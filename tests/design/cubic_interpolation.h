// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <vector>

namespace bspline_curve::test_support {

/// An interpolating cubic spline by its second derivatives at the knots (the moments): no
/// B-splines, no energies.
class CubicInterpolation {
public:
    /// Natural (second derivatives vanish at both ends), or periodic with period 1: the last
    /// interval leads from the last point back to the first.
    CubicInterpolation(std::vector<double> knots, std::vector<Vec3> points, bool isPeriodic);

    [[nodiscard]] Vec3 at(double t) const;

private:
    std::vector<double> knots_;
    std::vector<Vec3> points_, moments_;
};

}  // namespace bspline_curve::test_support
