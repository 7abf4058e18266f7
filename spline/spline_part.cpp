// SPDX-License-Identifier: GPL-3.0-or-later
// Splines turned round and cut.
#include "bspline_curve/spline.h"
#include "spline/spline_sections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// Parameters that differ by less are one.
constexpr double kSameParameter = 1e-12;

SplineData turned(const SplineData& spline, double last) {
    SplineData result = spline;
    std::ranges::reverse(result.controlPoints);
    std::ranges::reverse(result.knots);
    for (double& knot : result.knots) {
        knot = last - knot;
    }
    return result;
}

/// Two turns of a closed spline, over [0, 2].
SplineData unrolled(const SplineData& spline) {
    SplineData rolled;
    rolled.degree = spline.degree;
    const auto degree = static_cast<std::size_t>(spline.degree);
    const std::size_t period = spline.controlPoints.size() - degree;
    for (std::size_t i = 0; i < 2 * period + 2 * degree + 1; ++i) {
        const std::size_t round = i / period;
        rolled.knots.push_back(spline.knots[i % period] + static_cast<double>(round));
    }
    for (std::size_t i = 0; i < 2 * period + degree; ++i) {
        rolled.controlPoints.push_back(spline.controlPoints[i % period]);
    }
    return rolled;
}

/// The knot that a parameter is, but for rounding; else itself.
double onKnot(const SplineData& spline, double t) {
    const auto near =
        std::ranges::min_element(spline.knots, {}, [t](double knot) { return std::abs(knot - t); });
    return std::abs(*near - t) <= kSameParameter ? *near : t;
}

}  // namespace

SplineData reversedSpline(const SplineData& spline) {
    const std::vector<SplineSection> sections =
        spline.closed ? sectionsOf(spline) : std::vector<SplineSection>{};
    SplineData result;
    if (sections.empty()) {
        result = turned(spline, 1.0);
    } else {
        // Knots of a corner at 0 have their own places, which those of sections are brought to.
        const double first = sections.front().from;
        const double last = first < 0.0 ? 0.0 : 1.0;
        std::vector<SplineSection> others;
        for (const SplineSection& section : sections) {
            others.push_back(
                {last - section.to, last - section.from, turned(section.spline, last)}
            );
        }
        std::ranges::reverse(others);
        result = joinedSpline(others, true);
    }
    result.closed = spline.closed;
    result.pickParameters = spline.pickParameters;
    for (double& t : result.pickParameters) {
        t = spline.closed && t == 0.0 ? 0.0 : 1.0 - t;
    }
    std::ranges::sort(result.pickParameters);
    return result;
}

SplineData partOfSpline(const SplineData& spline, double from, double to) {
    const SplineData whole = spline.closed ? unrolled(spline) : spline;
    const double low = onKnot(whole, from);
    const double high = onKnot(whole, to);
    const auto degree = static_cast<std::size_t>(spline.degree);
    SplineData part;
    part.degree = spline.degree;
    std::vector<double>& knots = part.knots;
    knots.assign(degree + 1, low);
    std::ranges::copy_if(whole.knots, std::back_inserter(knots), [&](double knot) {
        return knot > low && knot < high;
    });
    knots.insert(knots.end(), degree + 1, high);
    for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i) {
        // The basis function is not zero on a span that is not empty; one of them is in the middle.
        std::size_t span = i;
        while (knots[span] == knots[span + 1]) {
            ++span;
        }
        const double middle = 0.5 * (knots[span] + knots[span + 1]);
        part.controlPoints.push_back(
            blossom(whole, spanHolding(whole, middle), std::span(knots).subspan(i + 1, degree))
        );
    }
    for (double& knot : knots) {
        knot = knot == high ? 1.0 : (knot - low) / (high - low);
    }
    return part;
}

}  // namespace bspline_curve
