// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/taut_path.h"

#include "solver/foot_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr int kSegments = 8;
// Heights are measured in this share of the distance of the ends, and cost so much, one after the
// other: first so that the path may slide, at last so that it lies on the surface to 1e-6 of that.
constexpr double kUnitShare = 0.01;
constexpr std::array<double, 2> kWeights = {10.0, 1e3};
constexpr int kMaxSteps = 6;
constexpr double kDecrement = 1e-10;
// No path floats as high as this, or is longer than the one that it comes from by more.
constexpr double kHighest = 0.02;
constexpr double kLongest = 1.02;

// Points of a path by their share of its length.
struct MeasuredPath {
    std::vector<Vec3> positions;
    std::vector<double> lengths;

    MeasuredPath(const ShellBase& base, std::span<const SurfacePoint> path) {
        for (const SurfacePoint& point : path) {
            positions.push_back(base.position(point));
            const Vec3& before = positions[positions.size() < 2 ? 0 : positions.size() - 2];
            lengths.push_back(
                (lengths.empty() ? 0.0 : lengths.back()) + (positions.back() - before).norm()
            );
        }
    }

    [[nodiscard]] double length() const { return lengths.back(); }

    // The last point before a share of the length, but for the last of all.
    [[nodiscard]] std::size_t indexAt(double share) const {
        const auto above = std::ranges::upper_bound(lengths, share * length());
        const auto index = static_cast<std::size_t>(above - lengths.begin());
        return std::clamp<std::size_t>(index, 1, lengths.size() - 1) - 1;
    }

    [[nodiscard]] Vec3 positionAt(double share) const {
        const std::size_t i = indexAt(share);
        const double gap = lengths[i + 1] - lengths[i];
        const double s = gap > 0.0 ? (share * length() - lengths[i]) / gap : 0.0;
        return (1.0 - s) * positions[i] + s * positions[i + 1];
    }
};

SplineCurve polygonAlong(const MeasuredPath& path) {
    std::vector<double> breaks;
    ControlPoints controls(kSegments + 1, 3);
    for (int i = 0; i <= kSegments; ++i) {
        breaks.push_back(static_cast<double>(i) / kSegments);
        controls.row(i) = path.positionAt(breaks.back()).transpose();
    }
    return {SplineSpace(1, false, std::move(breaks)), std::move(controls)};
}

bool comesToRest(FootNewton& newton, const FootFinder& finder) {
    bool isAtRest = false;
    for (const double weight : kWeights) {
        isAtRest = false;
        for (int i = 0; i < kMaxSteps && !isAtRest; ++i) {
            const std::optional<FootNewton::Step> step = newton.step(finder, weight);
            if (!step) {
                return false;
            }
            isAtRest = step->decrement <= kDecrement * step->scale || step->length == 0.0;
        }
    }
    return true;
}

}  // namespace

std::optional<std::vector<SurfacePoint>> pullTaut(
    CurveProblem problem, std::span<const SurfacePoint> path
) {
    const ShellBase& base = *problem.base;
    const MeasuredPath measured(base, path);
    problem.chordLength = (measured.positions.back() - measured.positions.front()).norm();
    if (!(problem.chordLength > 0.0)) {
        return std::nullopt;
    }
    problem.options.tension = 1.0;
    problem.options.bending = Bending::Ambient;
    problem.picks = {
        {path.front(), measured.positions.front(), 0.0},
        {path.back(), measured.positions.back(), 1.0}
    };
    const FootFinder finder(base);
    FootNewton newton(problem, polygonAlong(measured), kUnitShare * problem.chordLength);
    for (int sample = 0; sample < newton.energy().sampleCount(); ++sample) {
        const SurfacePoint& near = path[measured.indexAt(newton.energy().parameter(sample))];
        newton.now().feet[at(sample)] = {near.face, near.barycentric[1], near.barycentric[2], 0.0};
    }
    newton.follow(finder);
    if (!comesToRest(newton, finder) ||
        newton.energy().largestHeight(newton.now()) > kHighest * problem.chordLength) {
        return std::nullopt;
    }
    std::vector<SurfacePoint> taut{path.front()};
    for (const FootPoint& foot : newton.now().feet) {
        if (foot.face >= base.surfaceFaceCount) {
            return std::nullopt;
        }
        const Vec3 barycentric = foot.barycentric().cwiseMax(0.0);
        taut.push_back({foot.face, barycentric / barycentric.sum()});
    }
    taut.push_back(path.back());
    const bool hasField = !problem.field.empty();
    if (!hasField && MeasuredPath(base, taut).length() > kLongest * measured.length()) {
        return std::nullopt;
    }
    return taut;
}

}  // namespace bspline_curve
