// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/clamped_spline.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

namespace bspline_curve {

namespace {

/// The blossom of the polynomial on the span [knots[span], knots[span + 1]] at `degree` arguments:
/// de Boor's algorithm with another argument in each step.
Vec3 blossom(const SplineData& spline, std::size_t span, std::span<const double> arguments) {
    const std::size_t degree = arguments.size();
    std::vector<Vec3> points(
        spline.controlPoints.begin() + static_cast<std::ptrdiff_t>(span - degree),
        spline.controlPoints.begin() + static_cast<std::ptrdiff_t>(span + 1)
    );
    for (std::size_t step = 1; step <= degree; ++step) {
        for (std::size_t j = degree; j >= step; --j) {
            const double low = spline.knots[span - degree + j];
            const double high = spline.knots[span + 1 + j - step];
            const double share = (arguments[step - 1] - low) / (high - low);
            points[j] = (1.0 - share) * points[j - 1] + share * points[j];
        }
    }
    return points[degree];
}

}  // namespace

SplineData clamped(const SplineData& spline) {
    if (!spline.closed) {
        return spline;
    }
    const auto degree = static_cast<std::size_t>(spline.degree);
    const std::size_t count = spline.controlPoints.size();
    assert(count > degree && spline.knots.size() == count + degree + 1);
    SplineData result = spline;
    const double first = spline.knots[degree];
    const double last = spline.knots[count];
    std::fill_n(result.knots.begin(), degree + 1, first);
    std::fill_n(result.knots.rbegin(), degree + 1, last);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t span = std::clamp(i, degree, count - 1);
        result.controlPoints[i] =
            blossom(spline, span, std::span(result.knots).subspan(i + 1, degree));
    }
    return result;
}

}  // namespace bspline_curve
