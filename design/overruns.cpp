// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/overruns.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

constexpr int kSamplesOfLeg = 64;
/// A way arrives along the last part of its leg, a share of its parameters.
constexpr double kArrivalShare = 0.05;
/// What is farther from the end than this share of the chord is not looked at.
constexpr double kNearShare = 0.5;

struct LastLeg {
    const PickConstraint& from;
    const PickConstraint& to;

    [[nodiscard]] double parameter(double share) const {
        return std::lerp(from.parameter, to.parameter, share);
    }
};

AtEnds<LastLeg> legsOf(std::span<const PickConstraint> picks) {
    return {LastLeg{picks[1], picks.front()}, LastLeg{picks[picks.size() - 2], picks.back()}};
}

Vec3 arrivalOf(const Way& way, const LastLeg& leg) {
    return (way(leg.to.parameter) - way(leg.parameter(1.0 - kArrivalShare))).normalized();
}

double overrunOf(const Way& way, const LastLeg& leg, const Vec3& direction) {
    const double chord = (leg.to.position - leg.from.position).norm();
    const Vec3 end = way(leg.to.parameter);
    double least = kNearShare * chord;
    double farthest = 0.0;
    for (int i = 0; i < kSamplesOfLeg; ++i) {
        const Vec3 from = way(leg.parameter(static_cast<double>(i) / kSamplesOfLeg)) - end;
        const double distance = from.norm();
        if (distance < kNearShare * chord) {
            least = std::min(least, distance);
            farthest = std::max({farthest, from.dot(direction), distance - least});
        }
    }
    return farthest / chord;
}

}  // namespace

AtEnds<Vec3> arrivalsOf(const Way& way, std::span<const PickConstraint> picks) {
    const AtEnds<LastLeg> legs = legsOf(picks);
    return {arrivalOf(way, legs[0]), arrivalOf(way, legs[1])};
}

AtEnds<double> overrunsOf(
    const Way& way, std::span<const PickConstraint> picks, const AtEnds<Vec3>& directions
) {
    const AtEnds<LastLeg> legs = legsOf(picks);
    return {overrunOf(way, legs[0], directions[0]), overrunOf(way, legs[1], directions[1])};
}

}  // namespace bspline_curve
