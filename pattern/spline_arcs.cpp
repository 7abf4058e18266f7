// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/spline_arcs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>

namespace bspline_curve {

namespace {

using Homogeneous = Eigen::Vector4d;  // x, y, z times weight; weight

std::vector<Homogeneous> homogeneous(
    const std::vector<Vec3>& points, const std::vector<double>& weights
) {
    std::vector<Homogeneous> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double weight = weights.empty() ? 1.0 : weights[i];
        result.emplace_back(
            weight * points[i].x(), weight * points[i].y(), weight * points[i].z(), weight
        );
    }
    return result;
}

void check(const SpaceSpline& spline) {
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

/// Tangents of a cubic spline through points, per unit of its parameter, which steps by `steps`:
/// Thomas's algorithm on the conditions that second derivatives are continuous.
std::vector<Vec3> tangentsThrough(
    const std::vector<Vec3>& points,
    const std::vector<double>& steps,
    const Vec3& startDirection,
    const Vec3& endDirection
) {
    const std::size_t last = points.size() - 1;
    std::vector<double> diagonal(last + 1, 1.0);
    std::vector<double> above(last + 1, 0.0);
    std::vector<double> below(last + 1, 0.0);
    std::vector<Vec3> tangents(last + 1);
    const auto slope = [&](std::size_t i) { return Vec3((points[i + 1] - points[i]) / steps[i]); };
    for (std::size_t i = 1; i < last; ++i) {
        below[i] = steps[i];
        diagonal[i] = 2.0 * (steps[i - 1] + steps[i]);
        above[i] = steps[i - 1];
        tangents[i] = 3.0 * (steps[i] * slope(i - 1) + steps[i - 1] * slope(i));
    }
    if (startDirection.isZero()) {
        above.front() = 0.5;
        tangents.front() = 1.5 * slope(0);
    } else {
        tangents.front() = startDirection.normalized();
    }
    if (endDirection.isZero()) {
        below.back() = 0.5;
        tangents.back() = 1.5 * slope(last - 1);
    } else {
        tangents.back() = endDirection.normalized();
    }
    for (std::size_t i = 1; i <= last; ++i) {
        const double factor = below[i] / diagonal[i - 1];
        diagonal[i] -= factor * above[i - 1];
        tangents[i] -= factor * tangents[i - 1];
    }
    tangents[last] /= diagonal[last];
    for (std::size_t i = last; i-- > 0;) {
        tangents[i] = (tangents[i] - above[i] * tangents[i + 1]) / diagonal[i];
    }
    return tangents;
}

}  // namespace

Vec3 SpaceArc::at(double t) const {
    // De Casteljau's algorithm.
    std::vector<Homogeneous> level = homogeneous(points, weights);
    for (std::size_t count = level.size() - 1; count > 0; --count) {
        for (std::size_t i = 0; i < count; ++i) {
            level[i] = (1.0 - t) * level[i] + t * level[i + 1];
        }
    }
    return level[0].head<3>() / level[0].w();
}

std::vector<SpaceArc> arcsOf(const SpaceSpline& spline) {
    check(spline);
    const auto degree = static_cast<std::size_t>(spline.degree);
    const std::vector<Homogeneous> points = homogeneous(spline.points, spline.weights);
    std::vector<SpaceArc> arcs;
    for (std::size_t span = degree; span < spline.points.size(); ++span) {
        const double low = spline.knots[span];
        const double high = spline.knots[span + 1];
        if (!(high > low)) {
            continue;
        }
        SpaceArc arc;
        for (std::size_t j = 0; j <= degree; ++j) {
            std::vector<double> arguments(degree, low);
            std::fill_n(arguments.begin(), j, high);
            const Homogeneous point = blossom(points, spline.knots, span, arguments);
            arc.points.emplace_back(point.head<3>() / point.w());
            if (!spline.weights.empty()) {
                arc.weights.push_back(point.w());
            }
        }
        if (!arcs.empty()) {
            arc.points.front() = arcs.back().points.back();
        }
        arcs.push_back(std::move(arc));
    }
    return arcs;
}

std::vector<SpaceArc> arcsThrough(
    std::vector<Vec3> points, const Vec3& startDirection, const Vec3& endDirection, bool closed
) {
    // What an end does to the tangents shrinks by 2 - sqrt(3) with each point: by 1e-16 over these.
    constexpr std::size_t kFarFromEnds = 28;
    const auto repeated = std::ranges::unique(points);
    points.erase(repeated.begin(), repeated.end());
    if (closed && points.size() > 1 && points.front() == points.back()) {
        points.pop_back();
    }
    const std::size_t count = points.size();
    if (count < 2) {
        return {};
    }
    const std::size_t before = closed ? kFarFromEnds : 0;
    const std::size_t arcCount = closed ? count : count - 1;
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < arcCount + 1 + 2 * before; ++i) {
        all.push_back(points[(i + count * before - before) % count]);
    }
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        steps.push_back((all[i + 1] - all[i]).norm());
    }
    const Vec3 none = Vec3::Zero();
    const std::vector<Vec3> tangents =
        tangentsThrough(all, steps, closed ? none : startDirection, closed ? none : endDirection);
    std::vector<SpaceArc> arcs;
    for (std::size_t i = before; i < before + arcCount; ++i) {
        const Vec3 out = steps[i] / 3.0 * tangents[i];
        const Vec3 in = steps[i] / 3.0 * tangents[i + 1];
        arcs.push_back(
            {.points = {all[i], all[i] + out, all[i + 1] - in, all[i + 1]}, .weights = {}}
        );
    }
    return arcs;
}

std::vector<Vec3> flattened(const std::vector<SpaceArc>& arcs, double distance) {
    constexpr double kMostSteps = 1000.0;
    std::vector<Vec3> points{arcs.front().points.front()};
    for (const SpaceArc& arc : arcs) {
        // A chord over 1/n of a curve of degree d is within d (d - 1) / 8 / n^2 of the largest
        // second difference of its control points (exact without weights).
        const auto degree = static_cast<double>(arc.points.size() - 1);
        double bend = 0.0;
        for (std::size_t i = 2; i < arc.points.size(); ++i) {
            bend = std::max(
                bend, (arc.points[i - 2] - 2.0 * arc.points[i - 1] + arc.points[i]).norm()
            );
        }
        const double steps = std::sqrt(0.125 * degree * (degree - 1.0) * bend / distance);
        const int count = static_cast<int>(std::ceil(std::clamp(steps, 1.0, kMostSteps)));
        for (int i = 1; i < count; ++i) {
            points.push_back(arc.at(static_cast<double>(i) / count));
        }
        points.push_back(arc.points.back());
    }
    return points;
}

}  // namespace bspline_curve
