// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/spline_arcs.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace bspline_curve {

namespace {

using Homogeneous = Eigen::Vector3d;  // x, y times weight; weight

void check(const PlanarSpline& spline) {
    const auto degree = static_cast<std::size_t>(std::max(spline.degree, 0));
    if (spline.degree < 1 || spline.points.size() <= degree) {
        throw std::invalid_argument("a spline needs a degree >= 1 and more points than that");
    }
    if (spline.knots.size() != spline.points.size() + degree + 1) {
        throw std::invalid_argument(
            "a spline needs as many knots as control points, plus its degree + 1"
        );
    }
    if (!std::ranges::is_sorted(spline.knots)) {
        throw std::invalid_argument("the knots of a spline are not ascending");
    }
    if (!spline.weights.empty() && (spline.weights.size() != spline.points.size() ||
                                    std::ranges::min(spline.weights) <= 0.0)) {
        throw std::invalid_argument("a spline needs one weight > 0 for each control point");
    }
}

/// The blossom of a spline on the span that begins at a knot (Ramshaw 1989).
Homogeneous blossom(
    const std::vector<Homogeneous>& points,
    std::span<const double> knots,
    std::size_t span,
    std::span<const double> arguments
) {
    const std::size_t degree = arguments.size();
    const auto first = static_cast<std::ptrdiff_t>(span - degree);
    std::vector<Homogeneous> level(
        points.begin() + first, points.begin() + first + static_cast<std::ptrdiff_t>(degree) + 1
    );
    for (std::size_t round = 1; round <= degree; ++round) {
        for (std::size_t k = degree; k >= round; --k) {
            const double low = knots[span - degree + k];
            const double high = knots[span + k - round + 1];
            const double share = (arguments[round - 1] - low) / (high - low);
            level[k] = (1.0 - share) * level[k - 1] + share * level[k];
        }
    }
    return level[degree];
}

}  // namespace

std::vector<DrawingArc> arcsOf(const PlanarSpline& spline) {
    check(spline);
    const auto degree = static_cast<std::size_t>(spline.degree);
    std::vector<Homogeneous> points;
    for (std::size_t i = 0; i < spline.points.size(); ++i) {
        const double weight = spline.weights.empty() ? 1.0 : spline.weights[i];
        points.emplace_back(weight * spline.points[i].x(), weight * spline.points[i].y(), weight);
    }
    std::vector<DrawingArc> arcs;
    for (std::size_t span = degree; span < spline.points.size(); ++span) {
        const double low = spline.knots[span];
        const double high = spline.knots[span + 1];
        if (!(high > low)) {
            continue;
        }
        DrawingArc arc;
        for (std::size_t j = 0; j <= degree; ++j) {
            std::vector<double> arguments(degree, low);
            std::fill_n(arguments.begin(), j, high);
            const Homogeneous point = blossom(points, spline.knots, span, arguments);
            arc.points.emplace_back(point.head<2>() / point.z());
            if (!spline.weights.empty()) {
                arc.weights.push_back(point.z());
            }
        }
        if (!arcs.empty()) {
            arc.points.front() = arcs.back().points.back();
        }
        arcs.push_back(std::move(arc));
    }
    return arcs;
}

}  // namespace bspline_curve
