// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "offset/surface_fan.h"
#include "pattern/surface_chart.h"

namespace bspline_curve {

/// The exponential map round a point: a point of the plane at distance r from the origin comes to
/// lie at the end of the straightest geodesic of length r into its direction. At a vertex that the
/// surface surrounds, angles are scaled to those of its faces.
class PointChart : public SurfaceChart {
public:
    /// The plane's origin comes to lie at `centre`, its y axis towards `up`, a direction in space.
    /// Throws InputError (BadOption) where that is the normal's there or leads off the surface.
    /// The surface must outlive this.
    PointChart(const Surface& surface, const SurfacePoint& centre, const Vec3& up);

    /// The same with an up that is found: the axis y of space, or z where y is within 20 degrees of
    /// the surface's normal.
    [[nodiscard]] static Vec3 defaultUp(const Surface& surface, const SurfacePoint& centre);

    [[nodiscard]] CarriedPoint at(const Eigen::Vector2d& point) const override;

private:
    const Surface& surface_;
    SurfacePoint centre_;
    SurfaceFan fan_;
    double up_ = 0.0;  // angle in the fan
};

}  // namespace bspline_curve
