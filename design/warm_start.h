// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "design/initial_path.h"

#include <optional>

namespace bspline_curve {

/// Where a curve lies once its picks have been dragged a little way.
struct WarmStart {
    PickPath path;
    SplineCurve spline;  ///< nearly passes the picks
};

/// Displaces the polyline of a curve so that it passes the picks, between two of them by what is
/// between their displacements, and the control points of its spline likewise; and changes
/// parameters and breaks so that a piece between picks has as much more of [0, 1] as it became
/// longer: where no pick moves the curve stays the same. Points keep the faces that they had.
/// `picks`: as many as the curve has.
///
/// Nothing where a piece has more than doubled or less than halved: curves from there would be no
/// better, nor there any sooner, than those from scratch.
[[nodiscard]] std::optional<WarmStart> dragCurve(
    const Curve& curve, const ExtendedSurface& extended, const std::vector<SurfacePoint>& picks
);

}  // namespace bspline_curve
