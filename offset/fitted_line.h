// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/progress.h"
#include "offset/distance_beams.h"
#include "shell/extended_surface.h"

namespace bspline_curve {

/// Fits cubic splines to lines at one distance from a curve, and projects them along the fibres.
class LineFitter {
public:
    /// `beams` must reach beyond the distance. All must outlive this.
    LineFitter(
        const Surface& surface,
        const ExtendedSurface& extended,
        const DistanceBeams& beams,
        double distance
    )
        : surface_(surface), extended_(extended), beams_(beams), distance_(distance) {}

    /// By least squares with few knots; spans are halved where vertices of the projection or
    /// middles of its segments are off the distance by more than `tolerance` times it, or where
    /// the spline leaves the surface. The ends of an open line stay. The line itself where no
    /// spline with twice as many knots as the line has vertices will do. O(n log n) for n vertices.
    /// Throws Cancelled.
    [[nodiscard]] FittedLine fitted(
        const SurfacePolyline& line, double tolerance, const Progress& progress = {}
    ) const;

    /// The line with itself as its spline.
    [[nodiscard]] FittedLine unfitted(const SurfacePolyline& line) const;

private:
    const Surface& surface_;
    const ExtendedSurface& extended_;
    const DistanceBeams& beams_;
    double distance_;
};

}  // namespace bspline_curve
