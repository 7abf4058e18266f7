// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spline_space.h"
#include "solver/traced_shell.h"

#include <vector>

namespace bspline_curve {

/// The shadow Q = M_S(P) of a spline on the surface, exactly: the spline cut at the shell's cells,
/// each piece carried to its face.
class ShadowCurve {
public:
    /// `space` and `controls` must outlive this, and so must what `traced` refers to.
    ShadowCurve(const TracedShell& traced, const SplineSpace& space, const ControlPoints& controls);

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

    TracedShell traced_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    bool isWhole_ = false;
    std::vector<Piece> pieces_;
    std::vector<Crossing> crossings_;
};

}  // namespace bspline_curve
