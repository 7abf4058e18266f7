// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "design/curve_designer.h"
#include "pattern/carried_drawing.h"
#include "pattern/drawing.h"

#include <vector>

namespace bspline_curve {

/// Points nearer to each other are one (relative to the diagonal); picks must be farther apart.
inline constexpr double kSamePointRelative = 2e-9;

/// A point of a piece of a drawing.
struct PieceSample {
    Eigen::Vector2d planar = Eigen::Vector2d::Zero();
    double along = 0.0;            ///< length of the piece before it, as drawn
    Vec3 position = Vec3::Zero();  ///< on the surface
};

/// A smooth piece of a drawing, by points of it in order; on a closed one the first is not
/// repeated.
struct CarriedPiece {
    std::vector<PieceSample> samples;
    bool closed = false;
    double length = 0.0;  ///< as drawn
};

/// Points of a piece without their places on the surface: dense enough for curves through them to
/// be within the tolerance, and at most about `spacing` apart.
[[nodiscard]] CarriedPiece samplesOf(const SmoothPiece& piece, double spacing, double tolerance);

struct DrawnPiece {
    Curve curve;
    double deviation = 0.0;               ///< largest distance of a sample to the curve
    std::vector<Distortion> distortions;  ///< between consecutive picks; without path and copy
};

/// The curve through samples of a piece, as many as it takes to be within the tolerance of all; but
/// where the drawing is straight, picks are not nearer to each other than edges are long. Throws
/// what CurveDesigner::design() throws.
[[nodiscard]] DrawnPiece drawnPiece(
    const CurveDesigner& designer, const CarriedPiece& piece, double tolerance
);

}  // namespace bspline_curve
