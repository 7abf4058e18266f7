// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <Eigen/Core>

#include <cstdint>

namespace bspline_curve {

/// Where a point of a drawing comes to lie.
struct CarriedPoint {
    enum class Status : std::uint8_t {
        OnSurface,
        BeyondBoundary,  ///< the way to it leads over the surface's boundary
        BeyondCurve      ///< it lies before or behind the curve that the drawing runs along
    };

    Status status = Status::OnSurface;
    SurfacePoint point;  ///< OnSurface
};

/// Carries points of a plane to a surface, in the unit of the surface.
class SurfaceChart {
public:
    SurfaceChart() = default;
    SurfaceChart(const SurfaceChart&) = delete;
    SurfaceChart& operator=(const SurfaceChart&) = delete;
    virtual ~SurfaceChart() = default;

    [[nodiscard]] virtual CarriedPoint at(const Eigen::Vector2d& point) const = 0;
};

}  // namespace bspline_curve
