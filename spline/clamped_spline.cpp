// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/spline.h"
#include "spline/spline_sections.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

namespace bspline_curve {

SplineData clamped(const SplineData& spline) {
    if (!spline.closed) {
        return spline;
    }
    const auto degree = static_cast<std::size_t>(spline.degree);
    assert(spline.controlPoints.size() > degree);
    assert(spline.knots.size() == spline.controlPoints.size() + degree + 1);
    const double first = spline.knots[degree];
    const double last = spline.knots[spline.controlPoints.size()];
    // A corner at 0 repeats its knots, which are those of the end here.
    const auto above = std::ranges::upper_bound(spline.knots, first) - spline.knots.begin();
    const std::size_t repeated = static_cast<std::size_t>(above) - 1 - degree;
    const std::size_t count = spline.controlPoints.size() - repeated;
    SplineData result = spline;
    result.knots.erase(
        result.knots.begin(), result.knots.begin() + static_cast<std::ptrdiff_t>(repeated)
    );
    result.controlPoints.resize(count);
    std::fill_n(result.knots.begin(), degree + 1, first);
    std::fill_n(result.knots.rbegin(), degree + 1, last);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t span = std::max(i + repeated, degree);
        while (spline.knots[span] == spline.knots[span + 1]) {
            ++span;
        }
        result.controlPoints[i] =
            blossom(spline, span, std::span(result.knots).subspan(i + 1, degree));
    }
    return result;
}

}  // namespace bspline_curve
