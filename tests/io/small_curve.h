// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

namespace bspline_curve::io_tests {

/// Three points across two faces, with numbers that need all their digits.
inline Curve smallCurve(bool closed) {
    Curve curve;
    curve.polyline.closed = closed;
    curve.polyline.surfacePoints = {
        {0, {0.1, 0.2, 0.7}}, {0, {0.5, 0.0, 0.5}}, {1, {1.0 / 3, 1.0 / 3, 1.0 / 3}}
    };
    curve.polyline.points = {{0.1, 1.0 / 3, -2e-9}, {1, 2, 3}, {4, 5, 0.1234567890123456}};
    curve.polyline.parameters = {0.0, 0.3, 1.0};
    curve.polyline.picks = {0, 2};
    curve.spline.degree = 3;
    curve.spline.closed = closed;
    curve.spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    curve.spline.controlPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.1, 0}};
    if (closed) {
        curve.spline.knots = {-0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75};
        curve.spline.controlPoints = {
            {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0.1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}
        };
    }
    curve.spline.pickParameters = {0.0, 1.0};
    curve.report.usable = true;
    curve.report.status = SolveStatus::Converged;
    return curve;
}

}  // namespace bspline_curve::io_tests
