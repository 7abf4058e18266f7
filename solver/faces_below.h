// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/foot_point.h"
#include "solver/spline_space.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// A foot point at a parameter of a curve.
struct FootAt {
    double parameter;
    FootPoint foot;
};

/// The faces of the base that lie below a piece of a curve: those of its foot points (one at least,
/// ascending by parameter), and those between, found at finer and finer parameters until neighbours
/// follow each other. Where the feet jump, the faces in the gap are left out. Faces may come
/// several times. About 0.2 us for each face.
[[nodiscard]] std::vector<int> facesBelow(
    const ShellBase& base,
    const SplineSpace& space,
    const ControlPoints& controls,
    std::span<const FootAt> feet
);

/// The same of a whole curve, those of the picks among them.
[[nodiscard]] std::vector<int> facesBelow(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const std::vector<FootAt>& feet
);

}  // namespace bspline_curve
