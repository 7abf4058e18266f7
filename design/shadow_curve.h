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
    /// `faceNames`: what each face of the base is called in the surface, where the base is only a
    /// part of it; all arguments must outlive this.
    ShadowCurve(
        const CurveProblem& problem,
        const SplineSpace& space,
        const ControlPoints& controls,
        const std::vector<int>* faceNames = nullptr
    );

    /// Whether the spline lies in the shell. If not, there is no shadow.
    [[nodiscard]] bool isWhole() const { return isWhole_; }

    struct Crossing {
        double parameter;
        SurfacePoint point;  ///< on the edge that is crossed
    };

    /// Where the shadow passes from one face into the next, in order.
    [[nodiscard]] const std::vector<Crossing>& crossings() const { return crossings_; }

    /// The faces of the base that it passes, in order, ghosts included; one may come several times.
    [[nodiscard]] std::vector<int> faces() const;

    /// The shadow at t in [0, 1].
    [[nodiscard]] SurfacePoint at(double t) const;

private:
    struct Piece {
        double end;  ///< parameter
        int span;
        int tet, foot, face;
    };

    [[nodiscard]] SurfacePoint named(SurfacePoint point) const;
    [[nodiscard]] SurfacePoint toSurface(int face, const Vec3& shadow) const;

    const CurveProblem& problem_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    const std::vector<int>* faceNames_;
    bool isWhole_ = false;
    std::vector<Piece> pieces_;
    std::vector<Crossing> crossings_;
};

}  // namespace bspline_curve
