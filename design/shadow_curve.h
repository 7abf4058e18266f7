// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/spline_space.h"

#include <vector>

namespace bspline_curve {

/// The shadow Q = M_S(P) of a spline on the surface, exactly: the spline cut at the shell's cells,
/// each piece carried to its face.
class ShadowCurve {
public:
    /// The spline must lie in the shell; asserts it.
    ShadowCurve(
        const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
    );

    struct Crossing {
        double parameter;
        SurfacePoint point;  ///< on the edge that is crossed
    };

    /// Where the shadow passes from one face into the next, in order.
    [[nodiscard]] const std::vector<Crossing>& crossings() const { return crossings_; }

    /// The shadow at t in [0, 1].
    [[nodiscard]] SurfacePoint at(double t) const;

private:
    struct Piece {
        double end;  ///< parameter
        int span;
        int tet, foot, face;
    };

    [[nodiscard]] SurfacePoint toSurface(int face, const Vec3& shadow) const;

    const CurveProblem& problem_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    std::vector<Piece> pieces_;
    std::vector<Crossing> crossings_;
};

}  // namespace bspline_curve
