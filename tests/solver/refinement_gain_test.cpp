// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_fixture.h"
#include "solver/sampled_scene.h"
#include "spline/spline_system.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- Bulges ----

TEST(RefinementGain, IsNothingOnAPlane) {
    SolverOptions options;
    const Scene scene(
        jitteredPlate(12, 12, 0.2, 3),
        options,
        [](double t) { return Vec3(0.1 + 0.8 * t, 0.5 + 0.3 * std::sin(5.0 * t), 0.0); },
        9
    );
    const SampledIntegrals energy = scene.energy();
    const FootedSpline spline = scene.footed(energy, scene.controls());
    const double total =
        energy.total(energy.terms(spline, spline.frames, kSceneWeights), kSceneWeights);
    for (int span = 0; span < scene.space().spanCount(); ++span) {
        EXPECT_LT(energy.refinementGain(spline, kSceneWeights, span), 1e-12 * total);
    }
}

// The least energy with a knot vector, and what bulges of all spans promise there.
struct Relaxed {
    double total = 0.0, gain = 0.0;
    ControlPoints controls;
};

Relaxed relaxed(
    const ProblemFixture& fixture, const SplineSpace& space, ControlPoints controls, double alpha
) {
    const CurveProblem& problem = fixture.problem();
    const EnergyWeights weights{.alpha = alpha};
    const FibreProjector finder(*problem.extended);
    const SampledIntegrals energy(problem, space, problem.averageEdgeLength);
    const TriangleTree tree(problem.extended->vertices, problem.extended->faces);
    SplineSystem system(space, interpolationRows(space, problem.picks));
    FootedSpline spline = withNearestFeet(energy, space, tree, std::move(controls));
    Eigen::VectorXd gradient;
    std::vector<SpanBlocks> hessian;
    double decrement = 1.0;
    constexpr double kPickWeight = 1e6;
    for (int step = 0; step < 30 && decrement > 1e-7; ++step) {
        energy.follow(finder, spline);
        energy.differentiate(spline, weights, 1.0, gradient, hessian);
        EXPECT_TRUE(system.factorise(hessian, kPickWeight));
        const Eigen::VectorXd move = system.constrainedStep(
            gradient, system.constraints().residual(spline.controls), kPickWeight
        );
        decrement = -0.5 * gradient.dot(move);
        Eigen::Map<Eigen::VectorXd>(spline.controls.data(), spline.controls.size()) += move;
    }
    energy.follow(finder, spline);
    Relaxed result;
    result.total = energy.total(energy.terms(spline, spline.frames, weights), weights);
    for (int span = 0; span < space.spanCount(); ++span) {
        result.gain += energy.refinementGain(spline, weights, span);
    }
    result.controls = std::move(spline.controls);
    return result;
}

// ---- Refined splines ----

TEST(FeetOfARefinedSpline, AreThoseOfItsPositions) {
    for (const bool closed : {false, true}) {
        SCOPED_TRACE(closed ? "closed" : "open");
        SolverOptions options;
        options.closed = closed;
        const Scene scene(noisySphere(), options, roundTheSphere(1.02, closed), 14);
        const SampledIntegrals before = scene.energy();
        const FootedSpline coarse = scene.footed(before, scene.controls());
        const SplineSpace finer(
            3, closed, breaksWithMiddles(scene.space(), {0, 3, scene.space().spanCount() - 1})
        );
        const SampledIntegrals energy(scene.problem(), finer, scene.edge());
        FootedSpline spline{
            refine(scene.space(), scene.controls(), finer),
            std::vector<FootPoint>(energy.sampleCount()),
            std::vector<FootFrame>(energy.sampleCount()),
            {},
            {}
        };
        const FibreProjector finder(scene.extended());
        energy.followRefined(finder, before, coarse, spline);
        FootedSpline again = spline;
        energy.follow(finder, again);
        for (int i = 0; i < energy.sampleCount(); ++i) {
            const FootPoint& foot = spline.feet[i];
            EXPECT_EQ(foot.face, again.feet[i].face);
            EXPECT_LT((spline.positions[i] - again.positions[i]).norm(), 1e-14);
            EXPECT_LT(
                (spline.seconds[i] - again.seconds[i]).norm(), 1e-9 * again.seconds[i].norm()
            );
            EXPECT_NEAR(foot.height, again.feet[i].height, 1e-8);
            EXPECT_LT((spline.frames[i].height - again.frames[i].height).norm(), 1e-6);
        }
    }
}

// How much the least energy falls where all spans are halved.
struct Halving {
    double promised = 0.0, fall = 0.0;
};

Halving halveAllSpans(const std::vector<Vec3>& picks, int degree, double alpha) {
    SolverOptions options;
    options.degree = degree;
    const ProblemFixture fixture(icosphere(4), picks, options);
    const SplineCurve first = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const Relaxed coarse = relaxed(fixture, first.space, first.controls, alpha);
    std::vector<int> all(first.space.spanCount());
    std::iota(all.begin(), all.end(), 0);
    const SplineSpace finer(degree, false, breaksWithMiddles(first.space, all));
    const Relaxed fine =
        relaxed(fixture, finer, refine(first.space, coarse.controls, finer), alpha);
    return {coarse.gain, coarse.total - fine.total};
}

const std::vector<std::vector<Vec3>> kWays = {
    {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}},
    {{1, 0, 0}, {0.6, 0.8, 0}, {0, 0.6, 0.8}, {-0.8, 0, 0.6}},
};

// Of cubics a fifth to a third of it: bulges stay within their spans.
TEST(RefinementGain, ForetellsWhatHalvingAllSpansGainsOnASphere) {
    for (const std::vector<Vec3>& picks : kWays) {
        const auto expectForetold = [&](int degree, double alpha, double most) {
            SCOPED_TRACE(testing::Message() << degree << ' ' << picks.size() << ' ' << alpha);
            const Halving halving = halveAllSpans(picks, degree, alpha);
            EXPECT_GT(halving.fall, 0.0);
            EXPECT_LT(halving.promised, most * halving.fall);
            EXPECT_GT(halving.promised, halving.fall / 6.0);
        };
        expectForetold(2, 100.0, 1.5);
        expectForetold(3, 100.0, 1.0);
        expectForetold(3, 3000.0, 1.0);
    }
}

// b'' is orthogonal to the second derivatives of cubics, but not of quartics: bending counts too.
TEST(RefinementGain, PromisesNoMoreThanHalvingAllSpansOfQuarticsGains) {
    for (const std::vector<Vec3>& picks : kWays) {
        for (const double alpha : {100.0, 3000.0}) {
            SCOPED_TRACE(std::to_string(picks.size()) + " picks, alpha " + std::to_string(alpha));
            const Halving halving = halveAllSpans(picks, 4, alpha);
            EXPECT_LT(halving.promised, 3.0 * halving.fall);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
