// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/faired_shadow.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// What a FairedShadow consists of.
struct FairedParts {
    std::vector<EdgeCrossing> crossings;
    std::vector<FairedPiece> pieces;  ///< from t = 0 to 1
};

/// Fairs the shadow of a spline, carried by fibres or cells. A kink is what the direction changes
/// by at a crossing, towards the side of the curve as the interpolated normals of the vertices have
/// it. Crossings move along their edges by the least squares of kinks and of the spline's own
/// bending, and by little, a banded linear system; what is left of a kink becomes bending of the
/// pieces beside it. Crossings at vertices and on boundaries stay, and those farther from the
/// spline than the tolerance. O(n).
[[nodiscard]] std::optional<FairedParts> fairedParts(
    const CurveProblem& problem, const ProjectedCurve& shadow
);

}  // namespace bspline_curve
