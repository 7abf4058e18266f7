// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "design/prepared_surface.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// What a curve passes from one pick to the next.
struct CurveLeg {
    SurfacePoint from, to;
    double length;  ///< of the curve there; infinite: there is none
};

/// The legs of a curve.
[[nodiscard]] std::vector<CurveLeg> curveLegsOf(const SurfacePolyline& line);

/// A curve is said to make a detour where its way from a pick to the next is longer than the
/// shortest path by this factor. Curves that bend little are longer by up to half on their own.
inline constexpr double kNotedDetour = 1.5;

/// The worst detour of a polyline that is given by its picks; nothing where it makes none.
/// A shortest path is sought for each leg that is that much longer than its chord.
[[nodiscard]] std::optional<Detour> worstDetour(
    const PreparedSurface& prepared, const SurfacePolyline& line
);

}  // namespace bspline_curve
