// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/overruns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

std::vector<PickConstraint> picksOn(const Way& way) {
    std::vector<PickConstraint> picks;
    for (const double t : {0.0, 0.5, 1.0}) {
        picks.push_back({.point = {}, .position = way(t), .parameter = t});
    }
    return picks;
}

AtEnds<double> ownOverruns(const Way& way) {
    const std::vector<PickConstraint> picks = picksOn(way);
    return overrunsOf(way, picks, arrivalsOf(way, picks));
}

TEST(Overruns, AreNoneOfStraightWays) {
    const Way straight = [](double t) -> Vec3 { return {t, 2.0 * t, 0.0}; };
    EXPECT_EQ(ownOverruns(straight), (AtEnds<double>{0.0, 0.0}));
}

TEST(Overruns, AreNoneOfHalfACircle) {
    const Way arc = [](double t) -> Vec3 {
        return {std::cos(std::numbers::pi * t), std::sin(std::numbers::pi * t), 0.0};
    };
    const AtEnds<double> overruns = ownOverruns(arc);
    EXPECT_LT(std::max(overruns[0], overruns[1]), 1e-12);
}

// From 0 in the middle to 1.5625, and back to 1.
Vec3 turningBack(double t) {
    const double s = 2.0 * t - 1.0;
    return {s + 4.0 * s * (1.0 - s), 0.0, 0.0};
}

TEST(Overruns, TellHowFarAWayRunsPastItsPicks) {
    const Way back = [](double t) { return turningBack(t); };
    const Way reversed = [](double t) { return turningBack(1.0 - t); };
    const AtEnds<Vec3> along = {Vec3(-1, 0, 0), Vec3(1, 0, 0)};
    const AtEnds<double> overruns = overrunsOf(back, picksOn(back), along);
    EXPECT_EQ(overruns[0], 0.0);
    // What is farther than half of the chord does not count.
    EXPECT_GT(overruns[1], 0.45);
    EXPECT_LT(overruns[1], 0.5);
    EXPECT_EQ(overrunsOf(reversed, picksOn(reversed), {along[1], along[0]})[0], overruns[1]);
    // Seen in its own direction, it was past its end before.
    EXPECT_GT(ownOverruns(back)[1], 0.4);
}

}  // namespace
}  // namespace bspline_curve
