// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper's own settings compute: samples, differences, Dijkstra's path, control polygons,
// weights.
#include "problem_fixture.h"
#include "shell/shell_boundary.h"
#include "solver/cellwise_energy.h"
#include "solver/internal_energy.h"
#include "solver/paper/control_polygon.h"
#include "solver/paper/edge_path.h"
#include "solver/paper/finite_differences.h"
#include "solver/paper/paper_settings.h"
#include "solver/sample_rule.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

const SplineSpace kSpace(3, false, {0.0, 0.13, 0.25, 0.6, 1.0});

TEST(SampleRule, IntegratesOverTheWholeCurve) {
    for (int points = 1; points <= kMostGaussPoints; ++points) {
        for (const bool ofCurve : {false, true}) {
            SCOPED_TRACE(std::to_string(points) + (ofCurve ? " of the curve" : " of spans"));
            const SampleRule rule{.segments = 7, .points = points, .isOfCurve = ofCurve};
            const int power = 2 * points - 1;
            double integral = 0.0;
            double before = 0.0;
            EXPECT_TRUE(forEachSample(kSpace, rule, [&](int span, double tau, double weight) {
                const double t = kSpace.breaks()[span] + tau * kSpace.spanLength(span);
                EXPECT_GT(t, before);
                before = t;
                integral += weight * std::pow(t, power);
                return true;
            }));
            EXPECT_NEAR(integral, 1.0 / (power + 1), 1e-14);
        }
    }
}

TEST(SampleRule, StopsWhereItsVisitorDoes) {
    int visited = 0;
    EXPECT_FALSE(
        forEachSample(kSpace, {.segments = 5, .isOfCurve = true}, [&](int, double, double) {
            return ++visited < 4;
        })
    );
    EXPECT_EQ(visited, 4);
}

double largestDifference(const CurveProblem& problem, const SplineSpace& space, int segments) {
    const std::vector<SplineSpace::BasisMatrix> products =
        differenceProducts(problem, space, {.segments = segments, .points = 3, .isOfCurve = true});
    double largest = 0.0;
    for (int span = 0; span < space.spanCount(); ++span) {
        const SplineSpace::BasisMatrix exact = ambientProducts(problem, space, span);
        largest = std::max(largest, (products[span] - exact).norm() / exact.norm());
    }
    return largest;
}

// Of cubic pieces second differences are exact; first ones converge with the square of the step,
// where spans end between segments as well.
TEST(Differences, AreThoseOfTheDerivatives) {
    CurveProblem problem;
    problem.chordLength = 0.7;
    EXPECT_LT(largestDifference(problem, kSpace, 100), 1e-9);
    problem.options.tension = 1.0;
    EXPECT_LT(largestDifference(problem, kSpace, 100), 5e-3);
    EXPECT_LT(largestDifference(problem, kSpace, 1000), 5e-5);
    const SplineSpace uneven(3, false, {0.0, 0.1234, 0.2511, 0.6789, 1.0});
    EXPECT_LT(largestDifference(problem, uneven, 1000), 2e-2);
}

// ---- Dijkstra's path ----

TEST(EdgePath, FollowsEdgesAndHasItsMiddle) {
    const ProblemFixture fixture(plate(10, 10), {{0.1, 0.2, 0}, {0.5, 0.2, 0}, {0.9, 0.2, 0}}, {});
    const CurveProblem& problem = fixture.problem();
    const double scale = problem.extended->frame.scale;
    const auto path =
        EdgePath::shortest(problem, problem.picks.front().point, problem.picks.back().point);
    ASSERT_TRUE(path.has_value());
    EXPECT_NEAR(path->length() * scale, 0.8, 1e-12);
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
        const Vec3 there = problem.extended->frame.toUser(
            problem.extended->position(path->at(share * path->length()))
        );
        EXPECT_LT((there - Vec3(0.1 + 0.8 * share, 0.2, 0.0)).norm(), 1e-12);
    }
}

TEST(EdgePath, IsStraightWithinAFace) {
    const ProblemFixture fixture(plate(2, 2), {{0.1, 0.02, 0}, {0.3, 0.1, 0}}, {});
    const CurveProblem& problem = fixture.problem();
    ASSERT_EQ(problem.picks[0].point.face, problem.picks[1].point.face);
    const auto path = EdgePath::shortest(problem, problem.picks[0].point, problem.picks[1].point);
    ASSERT_TRUE(path.has_value());
    EXPECT_NEAR(
        path->length(), (problem.picks[0].position - problem.picks[1].position).norm(), 1e-14
    );
}

// On a sphere of many faces it is no shorter than the geodesic, and not much longer.
TEST(EdgePath, IsAShortWayOnASphere) {
    const ProblemFixture fixture(icosphere(4), {{1, 0.1, 0}, {-0.45, 0.2, 0.87}}, {});
    const CurveProblem& problem = fixture.problem();
    const auto path = EdgePath::shortest(problem, problem.picks[0].point, problem.picks[1].point);
    ASSERT_TRUE(path.has_value());
    const double angle =
        std::acos(Vec3(1, 0.1, 0).normalized().dot(Vec3(-0.45, 0.2, 0.87).normalized()));
    const double length = path->length() * problem.extended->frame.scale;
    EXPECT_GT(length, 0.99 * angle);
    EXPECT_LT(length, 1.2 * angle);
}

// ---- Control polygons ----

SolverOptions paperOn(bool closed) {
    SolverOptions options = paperPreset();
    options.closed = closed;
    return options;
}

ProblemFixture thickSphere(bool closed) {
    const CoarseShellCase mesh{"Sphere", icosphere(3), icosphere(1), 0.3};
    return {
        mesh,
        {Vec3(1, 0.1, 0).normalized(),
         Vec3(0.3, 1, 0.2).normalized(),
         Vec3(-0.45, 0.2, 0.87).normalized(),
         Vec3(-0.3, -0.8, 0.4).normalized()},
        paperOn(closed)
    };
}

// Alg. 2: the picks between the first and the last lie on either side of the surface in turn.
TEST(ControlPolygon, RunsToEitherSideInTurn) {
    const ProblemFixture fixture = thickSphere(false);
    const CurveProblem& problem = fixture.problem();
    const std::optional<SplineCurve> curve = makeControlPolygon(problem);
    ASSERT_TRUE(curve.has_value());
    const Eigen::Index last = curve->controls.rows() - 1;
    EXPECT_LT((curve->controls.row(0).transpose() - problem.picks[0].position).norm(), 1e-14);
    EXPECT_LT((curve->controls.row(last).transpose() - problem.picks[3].position).norm(), 1e-14);
    const double radius = problem.picks[0].position.norm();
    for (Eigen::Index c = 1; c < last; ++c) {
        EXPECT_GT(std::abs(curve->controls.row(c).norm() - radius), 0.02 * radius) << c;
    }
    // The flag begins with f of the second pick, which is above the middle: icosphere(1) has its
    // faces inside the sphere.
    const Vec3 second = problem.shell->lift(problem.picks[1].point, 0.98);
    const Vec3 third = problem.shell->lift(problem.picks[2].point, -0.98);
    const auto has = [&](const Vec3& p) {
        return (curve->controls.rowwise() - p.transpose()).rowwise().norm().minCoeff() < 1e-12;
    };
    EXPECT_TRUE(has(second));
    EXPECT_TRUE(has(third));
}

TEST(ControlPolygon, HasEnoughPointsForEveryDegree) {
    for (const bool closed : {false, true}) {
        for (const int degree : {2, 3, 4}) {
            SolverOptions options = paperOn(closed);
            options.degree = degree;
            std::vector<Vec3> picks = {
                Vec3(1, 0.1, 0).normalized(), Vec3(0.9, 0.3, 0.1).normalized()
            };
            if (closed) {
                picks.emplace_back(Vec3(0.9, 0.2, 0.3).normalized());
            }
            const ProblemFixture fixture(icosphere(3), picks, options);
            const std::optional<SplineCurve> curve = makeControlPolygon(fixture.problem());
            ASSERT_TRUE(curve.has_value());
            EXPECT_GE(curve->controls.rows(), degree + 1);
        }
    }
}

// ---- The whole method ----

TEST(PaperMethod, GivesUsableCurvesWithinItsBounds) {
    for (const bool closed : {false, true}) {
        ProblemFixture fixture = thickSphere(closed);
        const ShellBoundary boundary(*fixture.problem().shell);
        fixture.problem().boundary = &boundary;
        const SolveReport report = solved(fixture).report;
        EXPECT_TRUE(report.usable) << name(report.status);
        const PaperOptions& paper = fixture.problem().options.paper;
        EXPECT_EQ(report.rounds.front().beta, paper.betaFirst);
        for (const RoundReport& round : report.rounds) {
            EXPECT_GE(round.alpha, paper.alphaMin);
            EXPECT_LE(round.alpha, paper.alphaMax);
            EXPECT_LE(round.beta, paper.betaMax);
        }
    }
}

// (18): with the first weights, the distance counts as much as all other terms do.
TEST(PaperWeights, BeginWithTheTermsOfTheFirstCurve) {
    const ProblemFixture fixture = thickSphere(false);
    const CurveProblem& problem = fixture.problem();
    std::optional<SplineCurve> first = makeControlPolygon(problem);
    ASSERT_TRUE(first.has_value());
    CellwiseEnergy energy(problem, std::move(*first), 0.0);
    EnergyWeights weights;
    PaperSettings(problem).adjustFirst(energy, 1.0, weights);
    energy.setWeights(weights);
    const EnergyValue value = energy.differentiate();
    ASSERT_TRUE(value.inside);
    const double others = value.terms.internal + weights.beta * value.terms.fit;
    EXPECT_GT(weights.alpha, problem.options.paper.alphaMin);
    EXPECT_NEAR(weights.alpha * value.terms.distance, others, 1e-9 * others);
}

}  // namespace
}  // namespace bspline_curve
