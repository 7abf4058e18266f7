// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/faces_below.h"

#include <algorithm>
#include <iterator>

namespace bspline_curve {
namespace {

// A stretch between two feet is halved this often: to 1/1000, shorter than faces where feet follow
// each other at all.
constexpr int kMostHalvings = 10;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

class FaceCollector {
public:
    FaceCollector(const ShellBase& base, const SplineSpace& space, const ControlPoints& controls)
        : base_(base), finder_(base), space_(space), controls_(controls) {}

    void start(const FootAt& from) { faces_.push_back(from.foot.face); }

    // Appends the faces after that of `from`, up to that of `to`.
    void goOn(const FootAt& from, const FootAt& to, int depth = 0) {
        if (from.foot.face == to.foot.face) {
            return;
        }
        if (depth == kMostHalvings || areNeighbours(from.foot.face, to.foot.face)) {
            faces_.push_back(to.foot.face);
            return;
        }
        FootAt middle{0.5 * (from.parameter + to.parameter), from.foot};
        FootFrame frame;
        finder_.move(positionAt(middle.parameter), middle.foot, frame);
        goOn(from, middle, depth + 1);
        goOn(middle, to, depth + 1);
    }

    [[nodiscard]] std::vector<int> faces() && { return std::move(faces_); }

private:
    [[nodiscard]] bool areNeighbours(int a, int b) const {
        return std::ranges::count(base_.faceNeighbours[at(a)], b) > 0;
    }

    [[nodiscard]] Vec3 positionAt(double t) {
        while (span_ + 1 < space_.spanCount() && space_.breaks()[at(span_ + 1)] <= t) {
            setSpan(span_ + 1);
        }
        while (span_ < 0 || space_.breaks()[at(span_)] > t) {
            setSpan(span_ < 0 ? 0 : span_ - 1);
        }
        return curve_.at((t - space_.breaks()[at(span_)]) / space_.spanLength(span_));
    }

    void setSpan(int span) {
        span_ = span;
        curve_ = space_.polynomial(controls_, span);
    }

    const ShellBase& base_;
    FootFinder finder_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    int span_ = -1;
    PolynomialCurve curve_;
    std::vector<int> faces_;
};

FootAt footOf(const PickConstraint& pick, double parameter) {
    return {
        parameter, {pick.point.face, pick.point.barycentric[1], pick.point.barycentric[2], 0.0}
    };
}

}  // namespace

std::vector<int> facesBelow(
    const ShellBase& base,
    const SplineSpace& space,
    const ControlPoints& controls,
    std::span<const FootAt> feet
) {
    FaceCollector collector(base, space, controls);
    collector.start(feet.front());
    for (std::size_t i = 1; i < feet.size(); ++i) {
        collector.goOn(feet[i - 1], feet[i]);
    }
    return std::move(collector).faces();
}

std::vector<int> facesBelow(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const std::vector<FootAt>& feet
) {
    std::vector<FootAt> picks;
    for (const PickConstraint& pick : problem.picks) {
        picks.push_back(footOf(pick, pick.parameter));
    }
    if (problem.options.closed) {
        picks.push_back(footOf(problem.picks.front(), 1.0));
    }
    std::vector<FootAt> all;
    all.reserve(picks.size() + feet.size());
    std::ranges::merge(
        picks, feet, std::back_inserter(all), {}, &FootAt::parameter, &FootAt::parameter
    );
    return facesBelow(*problem.base, space, controls, all);
}

}  // namespace bspline_curve
