// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "pattern/surface_chart.h"

#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Carries a plane to the surroundings of a curve: x is the length along the curve, y the distance
/// from it, to its left seen with the surface's normal upwards, along the straightest geodesic at
/// right angles to it. What is at right angles is taken over a length of the curve, so that small
/// bends of its polyline turn nothing.
class CurveChart : public SurfaceChart {
public:
    /// `smoothing`: half that length; 0: the polyline as it is. Throws InputError (NoPath) where
    /// the polyline, which must be strict, has no length. The surface must outlive this.
    CurveChart(const Surface& surface, const SurfacePolyline& line, double smoothing);

    /// On an open curve x must be in [0, length()], on a closed one it may be any.
    [[nodiscard]] CarriedPoint at(const Eigen::Vector2d& point) const override;

    /// Of the polyline.
    [[nodiscard]] double length() const { return starts_.back(); }

    [[nodiscard]] bool closed() const { return closed_; }

private:
    [[nodiscard]] std::size_t segmentAt(double along) const;
    [[nodiscard]] double turnAt(std::size_t vertex) const;
    [[nodiscard]] double turnIntegral(double along) const;
    [[nodiscard]] double meanTurn(double along) const;

    const Surface& surface_;
    bool closed_;
    double smoothing_;
    std::vector<SurfacePoint> points_;  // of a closed curve the first again at the end
    std::vector<double> starts_;        // length before each point
    std::vector<double> turns_;         // direction of each segment: the sum of the turns before it
    std::vector<double> integrals_;     // of the direction, up to each point
    double wholeTurn_ = 0.0;            // of a closed curve, once round
};

}  // namespace bspline_curve
