// SPDX-License-Identifier: GPL-3.0-or-later
// How far shells reach, in shells of full resolution.
#include "solver/shell_reach.h"

#include "bspline_curve/shell.h"
#include "problem_fixture.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// A plate in a shell of a few prisms, whose pillars are `height` of their edges long to either
// side.
CoarseShellCase plateIn(double height, double scale = 1.0) {
    return {"Plate", plate(12, 12, scale, scale), plate(4, 4, scale, scale), height};
}

std::vector<Vec3> picksAt(double scale = 1.0) {
    return {
        scale * Vec3(0.21, 0.33, 0.0), scale * Vec3(0.52, 0.61, 0.0), scale * Vec3(0.8, 0.4, 0)
    };
}

double reachOf(const CoarseShellCase& shell, double scale = 1.0) {
    return relativeReach(ProblemFixture(shell, picksAt(scale), {}).problem());
}

TEST(ShellReach, IsOneAtFullResolution) {
    const ProblemFixture fixture(plate(12, 12), picksAt(), {});
    EXPECT_EQ(relativeReach(fixture.problem()), 1.0);
}

TEST(ShellReach, IsTheRatioOfTheThicknessesOverAPlate) {
    for (const double height : {0.5, 1.0, 2.0}) {
        const CoarseShellCase shell = plateIn(height);
        const double thick = height * Surface(shell.coarse).averageEdgeLength();
        const double thin = ShellOptions{}.thickness * Surface(shell.fine).averageEdgeLength();
        EXPECT_NEAR(reachOf(shell), thick / thin, 1e-9 * thick / thin) << "height " << height;
    }
}

TEST(ShellReach, IsAtLeastOne) {
    EXPECT_EQ(reachOf(plateIn(0.01)), 1.0);
}

TEST(ShellReach, DoesNotDependOnTheScale) {
    const double reach = reachOf(plateIn(1.0));
    for (const double scale : {1e-3, 1e6}) {
        EXPECT_NEAR(reachOf(plateIn(1.0, scale), scale), reach, 1e-9 * reach) << "scale " << scale;
    }
}

}  // namespace
}  // namespace bspline_curve
