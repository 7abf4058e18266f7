// SPDX-License-Identifier: GPL-3.0-or-later
// First splines by least squares.
#include "problem_fixture.h"
#include "shell/prism_graph.h"
#include "solver/initial_curve.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

ProblemFixture acrossAPlate() {
    return {plate(40, 20, 2.0, 1.0), {{0.1, 0.5, 0.0}, {0.5, 0.6, 0.0}, {1.9, 0.5, 0.0}}, {}};
}

TEST(FirstCurves, StayInTheShell) {
    const ProblemFixture fixture = acrossAPlate();
    const std::optional<SplineCurve> first =
        fitInitialPath(fixture.problem(), fixture.initialPath());
    ASSERT_TRUE(first.has_value());
    const SplineCurve& curve = *first;
    for (const PickConstraint& pick : fixture.problem().picks) {
        const Vec3 there = curve.space.evaluate(curve.controls, pick.parameter);
        EXPECT_LT((there - pick.position).norm(), 1e-12);
    }
}

// Spans over a stretch without prisms can be halved as often as one likes.
TEST(FirstCurves, AreNoneWhereTheShellIsInterrupted) {
    ProblemFixture fixture = acrossAPlate();
    CurveProblem& problem = fixture.problem();
    const Shell& whole = *problem.shell;
    std::vector<Prism> prisms;
    const double middle = problem.extended->frame.toUnit({1.0, 0.5, 0.0}).x();
    const double beside = problem.extended->frame.toUnit({1.2, 0.5, 0.0}).x();
    for (std::size_t f = 0; f < whole.prisms().size(); ++f) {
        prisms.push_back(prismOver(problem.extended->faces[f]));
        const Vec3 centre =
            problem.extended->position({static_cast<int>(f), Vec3::Constant(1.0 / 3.0)});
        if (centre.x() > middle && centre.x() < beside) {
            prisms[f].orientation = 0;
        }
    }
    connectPrisms(prisms, problem.extended->faceNeighbours);
    InitialPath initialPath = fixture.initialPath();  // as paths do not enter faces without prisms
    std::erase_if(initialPath.points, [&](const InitialPath::Point& point) {
        return prisms[point.point.face].orientation == 0;
    });
    const Shell interrupted(whole.pillars(), std::move(prisms), problem.extended->surfaceFaceCount);
    problem.shell = &interrupted;
    EXPECT_FALSE(fitInitialPath(problem, initialPath).has_value());
}

}  // namespace
}  // namespace bspline_curve
