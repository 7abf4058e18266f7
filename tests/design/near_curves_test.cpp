// SPDX-License-Identifier: GPL-3.0-or-later
// Curves within a tolerance of their picks, judged from the outside.
#include "bspline_curve/error.h"
#include "design/curve_checks.h"
#include "design/near_picks.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Picks along a wave of the unit plate, off by up to `noise` aside.
std::vector<Vec3> shakyWave(double noise) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> aside(-noise, noise);
    std::vector<Vec3> picks;
    for (int i = 0; i <= 18; ++i) {
        const double x = 0.05 + 0.05 * i;
        picks.emplace_back(x, 0.5 + 0.15 * std::sin(5.0 * x) + aside(random), 0.0);
    }
    return picks;
}

std::vector<Vec3> shakyCircle(double noise) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> aside(-noise, noise);
    std::vector<Vec3> picks;
    for (int i = 0; i < 24; ++i) {
        const double angle = std::numbers::pi / 12.0 * i;
        const double radius = 0.3 + aside(random);
        picks.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0);
    }
    return picks;
}

/// The sum of the angles by which a polyline of the plate turns, by 200 points of its spline.
double turningOf(const SplineData& spline) {
    constexpr int kPoints = 200;
    double turning = 0.0;
    Vec3 before = Vec3::Zero();
    for (int i = 1; i <= kPoints; ++i) {
        const Vec3 way = pointOfSpline(spline, static_cast<double>(i) / kPoints) -
                         pointOfSpline(spline, static_cast<double>(i - 1) / kPoints);
        if (i > 1) {
            turning += std::abs(std::atan2(before.cross(way).z(), before.dot(way)));
        }
        before = way;
    }
    return turning;
}

Curve curveNear(
    const CurveDesigner& designer, const std::vector<Vec3>& picks, const SolverOptions& options
) {
    Curve curve = designer.design(picks, options);
    EXPECT_TRUE(curve.report.usable);
    expectStrict(designer.surface(), curve.polyline);
    return curve;
}

void expectNear(const Curve& curve, const std::vector<Vec3>& picks, double tolerance) {
    ASSERT_EQ(curve.report.pickDistances.size(), picks.size());
    ASSERT_EQ(curve.polyline.picks.size(), picks.size());
    EXPECT_TRUE(std::ranges::is_sorted(curve.spline.pickParameters));
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const double distance = distanceToPolyline(picks[i], curve.polyline);
        EXPECT_LE(distance, tolerance) << i;
        EXPECT_NEAR(distance, curve.report.pickDistances[i], 1e-9) << i;
    }
}

TEST(NearCurves, AreSmoothWherePicksAreShaky) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    constexpr double kTolerance = 0.02;
    const std::vector<Vec3> picks = shakyWave(0.012);
    const Curve through = goodCurve(designer, picks);
    const Curve near = curveNear(designer, picks, {.pickTolerance = {.value = kTolerance}});
    expectNear(near, picks, kTolerance);
    // The wave itself turns by 2.2; through the picks the curve turns at each.
    EXPECT_GT(turningOf(through.spline), 6.0);
    EXPECT_LT(turningOf(near.spline), 2.2);
    EXPECT_LT(near.spline.controlPoints.size(), through.spline.controlPoints.size());
}

TEST(NearCurves, MayBeClosed) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    constexpr double kTolerance = 0.02;
    const std::vector<Vec3> picks = shakyCircle(0.015);
    const Curve near =
        curveNear(designer, picks, {.closed = true, .pickTolerance = {.value = kTolerance}});
    expectNear(near, picks, kTolerance);
    EXPECT_LT(turningOf(near.spline), 2.0 * std::numbers::pi + 0.05);
}

TEST(NearCurves, TakeTolerancesInEdges) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const double edge = designer.surface().averageEdgeLength();
    const std::vector<Vec3> picks = shakyWave(0.012);
    const Curve inEdges =
        curveNear(designer, picks, {.pickTolerance = {.value = 0.5, .isInEdges = true}});
    const Curve asLength = curveNear(designer, picks, {.pickTolerance = {.value = 0.5 * edge}});
    EXPECT_EQ(inEdges.polyline.points, asLength.polyline.points);
}

// On a tube with a slit. With full tension the curve lies along edges, where halving
// spans promises what no knot brings: they must come to an end.
TEST(NearCurves, WithFullTensionHaveNotKnotsWithoutNumber) {
    constexpr int kRows = 30;
    TriangleMesh tube;
    for (int i = 0; i < kRows * kRows; ++i) {
        const double angle = 5.5 * (i / kRows) / (kRows - 1);
        tube.vertices.emplace_back(
            std::cos(angle), std::sin(angle), 3.0 * (i % kRows) / (kRows - 1)
        );
        if (i / kRows > 0 && i % kRows > 0) {
            const int corner = i - kRows - 1;
            tube.faces.push_back({corner, i - 1, i});
            tube.faces.push_back({corner, i, corner + 1});
        }
    }
    const std::vector<Vec3> picks{
        {-0.927077376601291, 0.36316891471908874, 2.6281616401551497},
        {-0.9870367479035247, 0.14223243303948918, 2.6092314853290537},
        {0.16849473, -0.98221734, 0.7376622}
    };
    const Curve curve = curveNear(
        CurveDesigner(tube),
        picks,
        {.tension = 1.0, .pickTolerance = {.value = 2.0, .isInEdges = true}}
    );
    EXPECT_EQ(curve.report.status, SolveStatus::Converged);
    EXPECT_LT(curve.report.knotsLast, 500);
}

TEST(NearCurves, PassThePicksWithoutATolerance) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = shakyWave(0.012);
    const std::vector<MeshLength> none(picks.size());
    CurveInputs inputs;
    inputs.pickTolerances = none;
    const Curve through = goodCurve(designer, picks);
    const Curve same = designer.design(picks, {}, {}, inputs);
    EXPECT_EQ(through.polyline.points, same.polyline.points);
    EXPECT_TRUE(same.report.pickDistances.empty());
}

TEST(NearCurves, PassPicksWhoseOwnToleranceIsZero) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = shakyWave(0.012);
    std::vector<MeshLength> tolerances(picks.size(), MeshLength{.value = 0.03});
    tolerances[7].value = 0.0;
    CurveInputs inputs;
    inputs.pickTolerances = tolerances;
    const Curve curve = designer.design(picks, {}, {}, inputs);
    ASSERT_TRUE(curve.report.usable);
    expectNear(curve, picks, 0.03);
    EXPECT_LT(distanceToPolyline(picks[7], curve.polyline), 1e-9);
}

TEST(NearCurves, AreNearerToPicksOfMoreWeight) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = shakyWave(0.012);
    double before = 1.0;
    for (const double weight : {1e3, 1e4, 1e5}) {
        std::vector<double> weights(picks.size(), weight);
        weights.front() = 0.0;  // which the curve passes, as its tolerance is 0
        CurveInputs inputs;
        inputs.pickWeights = weights;
        const Curve curve = designer.design(picks, {}, {}, inputs);
        ASSERT_TRUE(curve.report.usable);
        expectNear(curve, picks, 0.1);
        EXPECT_LT(distanceToPolyline(picks[0], curve.polyline), 1e-9);
        double squares = 0.0;
        for (const double distance : curve.report.pickDistances) {
            squares += distance * distance;
        }
        EXPECT_LT(squares, before);
        before = squares;
    }
    // One that draws harder than all others is met as nearly as splines follow their paths.
    std::vector<double> weights(picks.size(), 1e3);
    CurveInputs inputs;
    inputs.pickWeights = weights;
    const double without = designer.design(picks, {}, {}, inputs).report.pickDistances[7];
    weights[7] = 1e9;
    const double with = designer.design(picks, {}, {}, inputs).report.pickDistances[7];
    EXPECT_LT(with, 0.1 * designer.surface().averageEdgeLength());
    EXPECT_LT(with, without);
}

// A curve with weights is the one of least bending plus weighted distances: others cost more.
TEST(NearCurves, WithWeightsCostLessThanOthers) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = shakyWave(0.012);
    constexpr double kWeight = 2e4;
    const auto costOf = [&](const Curve& curve) {
        constexpr int kPoints = 400;
        double bending = 0.0;
        double length = 0.0;
        std::vector<Vec3> points;
        for (int i = 0; i <= kPoints; ++i) {
            points.push_back(pointOfSpline(curve.spline, static_cast<double>(i) / kPoints));
        }
        for (int i = 0; i < kPoints; ++i) {
            const Vec3 way = points[i + 1] - points[i];
            length += way.norm();
            if (i > 0) {
                const Vec3 in = points[i] - points[i - 1];
                const double turn = std::atan2(in.cross(way).norm(), in.dot(way));
                bending += turn * turn / (0.5 * (in.norm() + way.norm()));
            }
        }
        double cost = length * bending;
        for (const Vec3& pick : picks) {
            cost += kWeight * std::pow(distanceToPolyline(pick, curve.polyline), 2.0) / 2.0;
        }
        return cost;
    };
    const std::vector<double> weights(picks.size(), kWeight);
    CurveInputs inputs;
    inputs.pickWeights = weights;
    const double least = costOf(designer.design(picks, {}, {}, inputs));
    for (const double tolerance : {0.003, 0.006, 0.01, 0.015, 0.02}) {
        EXPECT_LT(least, costOf(designer.design(picks, {.pickTolerance = {.value = tolerance}})))
            << tolerance;
    }
    const std::vector<double> others(picks.size(), 4.0 * kWeight);
    inputs.pickWeights = others;
    EXPECT_LT(least, costOf(designer.design(picks, {}, {}, inputs)));
}

TEST(NearCurves, SlideIntoTheValleyOfAField) {
    const TriangleMesh mesh = jitteredPlate(40, 40, 0.2, 3);
    std::vector<double> field;
    for (const Vec3& vertex : mesh.vertices) {
        field.push_back(std::min(1.0, 4.0 * std::abs(vertex.y() - 0.5)));
    }
    const CurveDesigner designer(mesh);
    const std::vector<Vec3> picks = {
        {0.1, 0.5, 0.0}, {0.35, 0.54, 0.0}, {0.6, 0.46, 0.0}, {0.9, 0.5, 0.0}
    };
    CurveInputs inputs;
    inputs.field = ScalarField(field);
    const Curve through = designer.design(picks, {}, {}, inputs);
    const Curve near = designer.design(picks, {.pickTolerance = {.value = 0.06}}, {}, inputs);
    ASSERT_TRUE(near.report.usable);
    expectNear(near, picks, 0.06);
    const auto farthest = [](const Curve& curve) {
        double most = 0.0;
        for (const Vec3& point : curve.polyline.points) {
            most = std::max(most, std::abs(point.y() - 0.5));
        }
        return most;
    };
    EXPECT_GT(farthest(through), 0.039);
    EXPECT_LT(farthest(near), 0.01);
}

TEST(NearCurves, KeepOutOfFacesToAvoid) {
    const TriangleMesh mesh = jitteredPlate(40, 40, 0.2, 3);
    std::vector<int> avoid;
    for (int f = 0; f < std::ssize(mesh.faces); ++f) {
        const Triangle& face = mesh.faces[f];
        const Vec3 centre =
            (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
        if ((centre - Vec3(0.5, 0.5, 0.0)).norm() < 0.1) {
            avoid.push_back(f);
        }
    }
    const CurveDesigner designer(mesh);
    CurveInputs inputs;
    inputs.avoid = avoid;
    const std::vector<Vec3> picks = {
        {0.1, 0.5, 0.0}, {0.4, 0.67, 0.0}, {0.6, 0.64, 0.0}, {0.9, 0.5, 0.0}
    };
    const Curve near = designer.design(picks, {.pickTolerance = {.value = 0.03}}, {}, inputs);
    ASSERT_TRUE(near.report.usable);
    EXPECT_GT(near.report.clearance, 0.0);
    expectNear(near, picks, 0.03);
}

TEST(NearCurves, RefuseTolerancesThatAreNone) {
    const CurveDesigner designer(plate(4, 4));
    const std::vector<Vec3> picks = {{0.1, 0.1, 0.0}, {0.9, 0.8, 0.0}};
    EXPECT_THROW(
        static_cast<void>(designer.design(picks, {.pickTolerance = {.value = -1.0}})), InputError
    );
    const std::vector<MeshLength> one(1);
    CurveInputs inputs;
    inputs.pickTolerances = one;
    EXPECT_THROW(static_cast<void>(designer.design(picks, {}, {}, inputs)), InputError);
    const std::vector<double> wrong = {1.0, -1.0};
    for (const std::span<const double> weights : {std::span(wrong), std::span(wrong).first(1)}) {
        CurveInputs weighted;
        weighted.pickWeights = weights;
        EXPECT_THROW(static_cast<void>(designer.design(picks, {}, {}, weighted)), InputError);
    }
}

TEST(MeshLength, IsReadAsItIsWritten) {
    for (const MeshLength& length :
         {MeshLength{0.0, false}, MeshLength{0.1, false}, MeshLength{1.5, true}}) {
        EXPECT_EQ(parseLength(describe(length), "x"), length);
    }
    EXPECT_EQ(parseLength(" 1edge", "x"), (MeshLength{1.0, true}));
    EXPECT_EQ(parseLength("2 edges ", "x"), (MeshLength{2.0, true}));
    for (const char* const text :
         {"", "edges", "-1", "1 edgesedge", "1mm", "nan", "inf", "1e400"}) {
        EXPECT_THROW(static_cast<void>(parseLength(text, "x")), InputError) << text;
    }
}

/// The derivatives of a pick's pull by the squared distance, inside the bound and outside.
TEST(NearPicks, HaveExactDerivatives) {
    std::vector<FairingNode> nodes(2);
    nodes[1].position = Vec3(1.0, 0.0, 0.0);
    nodes[0].normal = nodes[1].normal = Vec3::UnitZ();
    NearPicks near;
    near.add({Vec3(0.4, 0.0, 0.0), {.bound = 0.5, .weight = 3.0}});
    near.follow(nodes, false);
    EXPECT_NEAR(near.picks()[0].share, 0.4, 1e-12);
    constexpr double kStrength = 0.7;
    const auto pullAt = [&](double squared) {
        NearPicks::Pick pick = near.picks()[0];
        pick.position.y() = std::sqrt(squared);
        return near.pullOf(pick, nodes, kStrength);
    };
    for (const double squared : {0.01, 0.2, 0.239, 0.245, 0.3, 1.0}) {
        constexpr double kStep = 1e-6;
        const NearPicks::Pull pull = pullAt(squared);
        const NearPicks::Pull above = pullAt(squared + kStep);
        const NearPicks::Pull below = pullAt(squared - kStep);
        EXPECT_NEAR((above.value - below.value) / (2.0 * kStep), pull.slope, 1e-5 * pull.slope);
        EXPECT_NEAR(
            (above.slope - below.slope) / (2.0 * kStep), pull.curvature, 1e-4 * pull.curvature
        );
    }
}

}  // namespace
}  // namespace bspline_curve
