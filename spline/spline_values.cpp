// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/spline.h"
#include "spline/spline_sections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

namespace {

/// The derivative of a spline of degree > 0 as one of a degree less. Control points between knots
/// that are one have no span, and are zero.
SplineData hodograph(const SplineData& spline) {
    SplineData result;
    result.degree = spline.degree - 1;
    result.closed = spline.closed;
    result.knots.assign(spline.knots.begin() + 1, spline.knots.end() - 1);
    for (std::size_t i = 0; i + 1 < spline.controlPoints.size(); ++i) {
        const double length = spline.knots[i + spline.degree + 1] - spline.knots[i + 1];
        const Vec3 difference = spline.controlPoints[i + 1] - spline.controlPoints[i];
        result.controlPoints.emplace_back(
            length > 0.0 ? Vec3(spline.degree / length * difference) : Vec3(Vec3::Zero())
        );
    }
    return result;
}

/// The first derivative, where the spline has a degree.
Vec3 slopeOf(const SplineData& spline, double t) {
    const std::size_t span = spanHolding(spline, t);
    const double low = spline.knots[span];
    const double high = spline.knots[span + 1];
    std::vector<double> arguments(static_cast<std::size_t>(spline.degree), t);
    arguments.back() = high;
    const Vec3 atHigh = blossom(spline, span, arguments);
    arguments.back() = low;
    return spline.degree / (high - low) * (atHigh - blossom(spline, span, arguments));
}

}  // namespace

Vec3 positionOf(const SplineData& spline, double t) {
    const std::vector<double> arguments(static_cast<std::size_t>(spline.degree), t);
    return blossom(spline, spanHolding(spline, t), arguments);
}

Vec3 derivativeOf(const SplineData& spline, double t, int order) {
    if (order > spline.degree) {
        return Vec3::Zero();
    }
    return order == 1 ? slopeOf(spline, t) : derivativeOf(hodograph(spline), t, order - 1);
}

Vec3 curvatureOf(const SplineData& spline, double t) {
    const Vec3 first = derivativeOf(spline, t, 1);
    const double squaredSpeed = first.squaredNorm();
    if (squaredSpeed == 0.0) {
        return Vec3::Zero();
    }
    const Vec3 second = derivativeOf(spline, t, 2);
    return (second - second.dot(first) / squaredSpeed * first) / squaredSpeed;
}

std::vector<BezierPiece> bezierPieces(const SplineData& spline) {
    const auto degree = static_cast<std::size_t>(spline.degree);
    std::vector<BezierPiece> pieces;
    for (std::size_t span = degree; span < spline.controlPoints.size(); ++span) {
        const double from = spline.knots[span];
        const double to = spline.knots[span + 1];
        if (from == to) {
            continue;
        }
        BezierPiece piece{.from = from, .to = to, .controlPoints = {}};
        std::vector<double> arguments(degree, from);
        piece.controlPoints.push_back(blossom(spline, span, arguments));
        for (double& argument : arguments) {
            argument = to;
            piece.controlPoints.push_back(blossom(spline, span, arguments));
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace bspline_curve
