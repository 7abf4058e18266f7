// SPDX-License-Identifier: GPL-3.0-or-later
// Curves relaxed by foot points against those integrated cell by cell, and which are which.
#include "solver/sampled_solver.h"

#include "design/curve_checks.h"
#include "problem_fixture.h"
#include "projection/fibre_projector.h"
#include "support/meshes.h"
#include "support/places.h"
#include "surface/triangle_tree.h"
#include "utility/worker_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

CurveCase sphere(bool closed = false) {
    return {closed ? "ClosedOnASphere" : "Sphere", icosphere(4), kSpherePicks, {.closed = closed}};
}

CurveCase noisySphereCase(bool closed = false, int degree = 3) {
    return {
        "NoisySphere" + std::string(closed ? "Closed" : "") + std::to_string(degree),
        withNoise(icosphere(4), 0.005, 17),
        kSpherePicks,
        {.degree = degree, .closed = closed}
    };
}

CurveCase plateWithBoundary() {
    return {
        "Plate",
        jitteredPlate(20, 20, 0.25, 5),
        {{0.02, 0.1, 0}, {0.4, 0.97, 0}, {0.7, 0.03, 0}, {0.98, 0.6, 0}}
    };
}

ProblemFixture makeFixture(const CurveCase& scene, SolverOptions options = {}) {
    options.closed = scene.options.closed;
    options.degree = scene.options.degree;
    return {scene.mesh, onSurface(scene.mesh, scene.picks), options};
}

ProblemFixture byCells(const CurveCase& scene, SolverOptions options = {}) {
    options.quadrature = Quadrature::Cells;
    return makeFixture(scene, options);
}

std::optional<Solution> relaxed(const ProblemFixture& fixture) {
    return solveSampled(fixture.problem(), fixture.initialPath());
}

void expectSame(const Solution& a, const Solution& b) {
    EXPECT_EQ(a.curve.space.breaks(), b.curve.space.breaks());
    EXPECT_EQ(a.curve.controls, b.curve.controls);
    EXPECT_EQ(a.report.status, b.report.status);
    EXPECT_EQ(a.report.newtonIterations, b.report.newtonIterations);
    EXPECT_EQ(a.report.maxDistance, b.report.maxDistance);
}

// Length, E_int without tension and the mean of the field, in the shell's frame, by many samples.
struct Measures {
    double length = 0.0, bending = 0.0, field = 0.0;
};

double fieldAt(const CurveProblem& problem, const FootPoint& foot) {
    double value = 0.0;
    for (int k = 0; k < 3 && !problem.field.empty(); ++k) {
        const int v = problem.extended->faces[foot.face][k];
        value += foot.barycentric()[k] * problem.field[v];
    }
    return value;
}

Measures measured(const ProblemFixture& fixture, const SplineCurve& curve) {
    const CurveProblem& problem = fixture.problem();
    const TriangleTree tree(problem.extended->vertices, problem.extended->faces);
    const FibreProjector finder(*problem.extended);
    Measures sum;
    constexpr int kSteps = 40;
    for (int span = 0; span < curve.space.spanCount(); ++span) {
        const PolynomialCurve piece = curve.space.polynomial(curve.controls, span);
        const double length = curve.space.spanLength(span);
        for (int i = 0; i < kSteps; ++i) {
            const double tau = (i + 0.5) / kSteps;
            const SurfacePoint nearest = tree.closestPoint(piece.at(tau)).point;
            FootPoint foot{nearest.face, nearest.barycentric[1], nearest.barycentric[2], 0.0};
            FootFrame frame;
            finder.move(piece.at(tau), foot, frame);
            const Vec3 bend = piece.secondDerivativeAt(tau) / (length * length);
            const double normal = frame.direction.dot(bend);
            const double share = 1.0 - problem.options.normalBendingWeight;
            sum.field += length / kSteps * fieldAt(problem, foot);
            sum.length += piece.derivativeAt(tau).norm() / kSteps;
            sum.bending += length / kSteps * (bend.squaredNorm() - share * normal * normal);
        }
    }
    sum.bending /= problem.chordLength * problem.chordLength;
    return sum;
}

// ---- Curves that are relaxed ----

class SampledCurves : public testing::TestWithParam<CurveCase> {};

TEST_P(SampledCurves, GivesTheCurvesOfTheCells) {
    const ProblemFixture fixture = makeFixture(GetParam());
    const std::optional<Solution> quick = relaxed(fixture);
    ASSERT_TRUE(quick.has_value());
    expectSame(*quick, solved(fixture));
    const Solution cells = solved(byCells(GetParam()));
    for (const SolveReport& report : {quick->report, cells.report}) {
        EXPECT_TRUE(report.usable);
        EXPECT_LT(report.maxDistance, fixture.problem().options.distanceTolerance);
        EXPECT_LT(report.maxPickGap, 1e-9);
    }
    const Measures one = measured(fixture, quick->curve);
    const Measures other = measured(fixture, cells.curve);
    const double tolerance =
        fixture.problem().options.distanceTolerance * fixture.problem().averageEdgeLength;
    EXPECT_NEAR(one.length, other.length, 2.5 * tolerance);
    EXPECT_LT(one.bending, 1.2 * other.bending);
    EXPECT_LT(quick->report.newtonIterations, cells.report.newtonIterations);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    SampledCurves,
    testing::Values(
        sphere(),
        sphere(true),
        noisySphereCase(),
        noisySphereCase(true),
        noisySphereCase(false, 2),
        noisySphereCase(true, 2),
        noisySphereCase(false, 4),
        noisySphereCase(true, 4),
        CurveCase{"Torus", torus(64, 24), kTorusPicks},
        plateWithBoundary(),
        CurveCase{
            "Box",
            box(10, {1.0, 0.8, 0.6}),
            {{0.9, 0.1, 0.6}, {0.5, 0.5, 0.6}, {0.2, 0.8, 0.4}, {0.7, 0.8, 0.2}}
        }
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

void setWaves(ProblemFixture& fixture) {
    std::vector<double> field;
    for (const Vec3& v : fixture.surface().vertices()) {
        field.push_back(1.0 + std::sin(3.0 * v.x()) * v.y());
    }
    fixture.setField(field);
}

TEST(SampledCurvesUnderAField, CostsNoMoreThanByCells) {
    SolverOptions options;
    options.fieldWeight = 200.0;
    ProblemFixture fixture = makeFixture(noisySphereCase(), options);
    setWaves(fixture);
    const std::optional<Solution> quick = relaxed(fixture);
    ASSERT_TRUE(quick.has_value());
    EXPECT_TRUE(quick->report.usable);
    ProblemFixture exact = byCells(noisySphereCase(), options);
    setWaves(exact);
    const Measures one = measured(fixture, quick->curve);
    const Measures other = measured(exact, solved(exact).curve);
    EXPECT_NEAR(quick->report.fieldCost, one.field, 1e-3);
    EXPECT_LT(one.bending + 200.0 * one.field, 1.01 * (other.bending + 200.0 * other.field));
    // It is another curve than without the field.
    const std::optional<Solution> without = relaxed(makeFixture(noisySphereCase()));
    ASSERT_TRUE(without.has_value());
    EXPECT_LT(one.field, measured(fixture, without->curve).field - 0.03);
}

// On a plate no direction changes, so that a step is judged by the energy that is reported.
TEST(SampledSteps, NeverRaiseTheEnergy) {
    for (const bool withField : {false, true}) {
        SolverOptions options;
        options.fieldWeight = 50.0;
        ProblemFixture fixture = makeFixture(plateWithBoundary(), options);
        if (withField) {
            setWaves(fixture);
        }
        const std::optional<Solution> quick = relaxed(fixture);
        ASSERT_TRUE(quick.has_value());
        const std::vector<IterationReport>& iterations = quick->report.iterations;
        EXPECT_EQ(static_cast<int>(iterations.size()), quick->report.newtonIterations);
        int falls = 0;
        for (std::size_t i = 0; i < iterations.size(); ++i) {
            EXPECT_GT(iterations[i].decrement, -1e-14)
                << "step " << i;  // 0 but for rounding at last
            if (i > 0 && iterations[i].round == iterations[i - 1].round) {
                EXPECT_LE(iterations[i].total, iterations[i - 1].total) << "step " << i;
                ++falls;
            }
        }
        EXPECT_GT(falls, 0);
    }
}

// Where a step fails at some bumps the rest of the curve goes all its way. Steps that are only
// shortened are so 10 times here.
TEST(SampledSteps, AreSeldomShortened) {
    int shortened = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        for (const bool closed : {false, true}) {
            const CurveCase bumpy{
                "Bumpy", withNoise(icosphere(4), 0.03, seed), kSpherePicks, {.closed = closed}
            };
            const std::optional<Solution> solution = relaxed(makeFixture(bumpy));
            ASSERT_TRUE(solution.has_value()) << "seed " << seed;
            shortened += static_cast<int>(
                std::ranges::count_if(solution->report.iterations, [](const IterationReport& step) {
                    return step.step < 1.0;
                })
            );
        }
    }
    EXPECT_LE(shortened, 3);
}

// Single curves take three steps or eight; what counts is that no resolution takes more of them.
TEST(SampledSteps, AreAsManyOnASubdividedMesh) {
    int onCoarse = 0;
    int onFine = 0;
    for (CurveCase scene : {sphere(), noisySphereCase(), plateWithBoundary()}) {
        SCOPED_TRACE(scene.name);
        const std::optional<Solution> coarse = relaxed(makeFixture(scene));
        // The picks of the first mesh: the surface is the same.
        scene.picks = onSurface(scene.mesh, scene.picks);
        scene.mesh = midpointSubdivide(scene.mesh);
        SolverOptions options;
        options.distanceTolerance *= 2.0;  // the same length: edges are half as long
        const std::optional<Solution> fine = relaxed(makeFixture(scene, options));
        ASSERT_TRUE(coarse && fine);
        onCoarse += coarse->report.newtonIterations;
        onFine += fine->report.newtonIterations;
    }
    EXPECT_LE(onFine, 2 * onCoarse) << onCoarse << " and " << onFine;
    EXPECT_LE(onCoarse, 2 * onFine) << onCoarse << " and " << onFine;
}

// The curve stays in the middle of a lens, however large its weight of the distance becomes: for
// seven rounds until that is the largest.
TEST(SampledSteps, EndSoonWhereTheCurveStaysFarAway) {
    constexpr double kThickness = 0.05;
    CurveCase lens{
        "Lens",
        icosphere(4),
        {{0.5, 0.0, kThickness}, {0.6, 0.1, -kThickness}, {-0.5, 0.3, kThickness}}
    };
    for (Vec3& vertex : lens.mesh.vertices) {
        vertex.z() *= kThickness;
    }
    ProblemFixture fixture = makeFixture(lens);
    int rounds = 0;
    fixture.problem().progress = [&](double, const char*) {
        ++rounds;
        return true;
    };
    EXPECT_FALSE(relaxed(fixture).has_value());
    EXPECT_LE(rounds, 5);
}

TEST(SampledSteps, StopWhereTheCallbackSaysSo) {
    SolverOptions options;
    options.distanceTolerance *= 0.1;  // so that it takes some rounds
    ProblemFixture fixture = makeFixture(noisySphereCase(true), options);
    int calls = 0;
    double last = 0.0;
    fixture.problem().progress = [&](double fraction, const char*) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
        ++calls;
        return true;
    };
    EXPECT_TRUE(solveSampled(fixture.problem(), fixture.initialPath()).has_value());
    ASSERT_GT(calls, 1);
    for (int allowed = 0; allowed < calls; ++allowed) {
        int left = allowed;
        fixture.problem().progress = [&](double, const char*) { return left-- > 0; };
        EXPECT_THROW(
            static_cast<void>(solveSampled(fixture.problem(), fixture.initialPath())), Cancelled
        );
    }
}

TEST(SampledSteps, BeginNoRoundAfterTheWorkThatIsGranted) {
    SolverOptions options;
    options.distanceTolerance *= 0.1;  // so that it takes some rounds
    const ProblemFixture fixture = makeFixture(noisySphereCase(true), options);
    const auto relaxedWithin = [&](double mostWork) {
        return relaxAtSamples(fixture.problem(), fixture.initialPath(), {}, mostWork);
    };
    const Solution whole = relaxedWithin(1e9);
    const auto work = static_cast<double>(whole.work);
    ASSERT_TRUE(whole.report.usable);
    ASSERT_GT(whole.report.rounds.size(), 2U);
    expectSame(relaxedWithin(3.0 * work), whole);
    const Solution stopped = relaxedWithin(0.3 * work);
    EXPECT_FALSE(stopped.report.usable);
    EXPECT_LT(stopped.report.rounds.size(), whole.report.rounds.size());
    EXPECT_LT(static_cast<double>(stopped.work), 0.5 * work);
}

// Quadratic splines need more knots for the same curve, but no shell.
TEST(SampledCurves, CostLittleMoreOfDegreeTwo) {
    for (const bool closed : {false, true}) {
        const auto solutionOf = [&](int degree) {
            return relaxed(makeFixture(noisySphereCase(closed, degree))).value();
        };
        const Solution cubic = solutionOf(3);
        const Solution quadratic = solutionOf(2);
        EXPECT_LT(quadratic.report.newtonIterations, 2 * cubic.report.newtonIterations);
        EXPECT_LT(quadratic.work, 3 * cubic.work);
        EXPECT_LT(quadratic.report.knotsLast, 3 * cubic.report.knotsLast);
    }
}

TEST(StopRule, EndsHalvingWhereItMakesTwiceAsManyKnots) {
    StopRule rule(false);
    EXPECT_FALSE(rule.isHalvingInVain(30));
    EXPECT_FALSE(rule.isHalvingInVain(40));
    EXPECT_FALSE(rule.isHalvingInVain(60));
    EXPECT_TRUE(rule.isHalvingInVain(61));
}

// ---- Curves that are not ----

void expectByCells(ProblemFixture fixture) {
    EXPECT_FALSE(relaxed(fixture).has_value());
    const Solution one = solved(fixture);
    fixture.problem().options.quadrature = Quadrature::Cells;
    expectSame(one, solved(fixture));
}

TEST(SamplesAreNotFor, TightCurves) {
    SolverOptions options;
    options.tension = 0.8;
    expectByCells(makeFixture(sphere(), options));
}

TEST(SamplesAreNotFor, StrongFields) {
    SolverOptions options;
    options.fieldWeight = 1e5;
    ProblemFixture fixture = makeFixture(noisySphereCase(), options);
    setWaves(fixture);
    expectByCells(std::move(fixture));
}

TEST(SamplesAreNotFor, ThePapersSettings) {
    const CurveCase scene{"SmallSphere", icosphere(3), kSpherePicks};
    for (const SolverOptions& options :
         {SolverOptions{.interpolation = Interpolation::Penalty},
          SolverOptions{.initialCurve = InitialCurve::ControlPolygon},
          SolverOptions{.barrierWidth = BarrierWidth::Tight},
          SolverOptions{.distanceWeight = DistanceWeight::Adaptive},
          SolverOptions{.knotRule = KnotRule::FeatureFunction}}) {
        expectByCells(makeFixture(scene, options));
    }
    for (const Quadrature quadrature : {Quadrature::Cells, Quadrature::Samples}) {
        EXPECT_FALSE(relaxed(makeFixture(scene, {.quadrature = quadrature})).has_value());
    }
}

TEST(SamplesAreNotFor, CurvesThatWhatTheyAvoidPushes) {
    const CurveCase scene{
        "Plate", jitteredPlate(20, 20, 0.25, 5), {{0.1, 0.48, 0}, {0.9, 0.48, 0}}
    };
    for (const double centre : {0.5, 0.65}) {  // in the way, and beside it
        ProblemFixture fixture = makeFixture(scene);
        fixture.avoid(facesWhere(fixture.surface(), ball({0.5, centre, 0}, 0.1)), 0.1);
        expectByCells(std::move(fixture));
    }
}

TEST(SamplingOfCurves, IsTheSameOnTwoThreads) {
    WorkerThread side;
    for (const CurveCase& scene :
         {noisySphereCase(true), plateWithBoundary(), noisySphereCase(false, 4)}) {
        ProblemFixture fixture = makeFixture(scene);
        fixture.problem().shell = nullptr;
        const std::optional<Solution> alone = relaxed(fixture);
        fixture.problem().side = &side;
        const std::optional<Solution> both = relaxed(fixture);
        ASSERT_TRUE(alone && both);
        expectSame(*alone, *both);
    }
}

TEST(SamplingOfCurves, IsTheSameBesideWhatIsFarAway) {
    const CurveCase scene{
        "Plate", jitteredPlate(20, 20, 0.25, 5), {{0.1, 0.48, 0}, {0.9, 0.48, 0}}
    };
    ProblemFixture fixture = makeFixture(scene);
    const std::optional<Solution> without = relaxed(fixture);
    fixture.avoid(facesWhere(fixture.surface(), ball({0.5, 0.9, 0}, 0.08)), 0.1);
    const std::optional<Solution> with = relaxed(fixture);
    ASSERT_TRUE(without && with);
    expectSame(*without, *with);
}

TEST(SamplesAreNotFor, CurvesWhoseProgressFalls) {
    ProblemFixture fixture = makeFixture(noisySphereCase(true));
    fixture.avoid(facesWhere(fixture.surface(), ball({0.3, 0.8, 0.5}, 0.3)), 0.2);
    EXPECT_FALSE(relaxed(fixture).has_value());
    double last = 0.0;
    fixture.problem().progress = [&](double fraction, const char*) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    };
    static_cast<void>(solved(fixture));
}

}  // namespace
}  // namespace bspline_curve
