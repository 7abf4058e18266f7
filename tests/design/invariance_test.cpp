// SPDX-License-Identifier: GPL-3.0-or-later
// What a curve must not depend on: where the mesh lies, how large it is, how it is numbered, how it
// is triangulated, from which end the picks are given.
#include "curve_checks.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {
namespace {

using namespace test_support;

// Points of faces, so that they are on the surface whatever happens to it later.
std::vector<Vec3> onFaces(const TriangleMesh& mesh, std::vector<Vec3> wishes) {
    std::vector<Vec3> points;
    for (const auto& [a, b, c] : mesh.faces) {
        const std::vector<Vec3>& v = mesh.vertices;
        points.emplace_back(0.21 * v[a] + 0.33 * v[b] + 0.46 * v[c]);
    }
    return verticesNear(points, std::move(wishes));
}

CurveCase scene(const std::string& name, TriangleMesh mesh, const std::vector<Vec3>& picks) {
    std::vector<Vec3> onMesh = onFaces(mesh, picks);
    return {name, std::move(mesh), std::move(onMesh), {.closed = name.ends_with("Closed")}};
}

CurveCase noisySphere(const std::string& name = "NoisySphere") {
    return scene(name, withNoise(icosphere(3), 0.02, 17), kSpherePicks);
}

CurveCase sphere() {
    return scene("Sphere", icosphere(3), kSpherePicks);
}

CurveCase block() {
    return scene(
        "Box",
        box(10, {1.0, 0.8, 0.6}),
        {{0.9, 0.1, 0.6}, {0.5, 0.5, 0.6}, {0.2, 0.8, 0.4}, {0.7, 0.8, 0.2}}
    );
}

/// Without symmetries that rounding breaks one way or the other, and others.
std::vector<CurveCase> irregularScenes(std::vector<CurveCase> others) {
    others.push_back(noisySphere());
    others.push_back(noisySphere("NoisySphereClosed"));
    others.push_back(scene("Torus", torus(48, 20), kTorusPicks));
    others.push_back(scene(
        "Plate",
        jitteredPlate(15, 15, 0.25, 5),
        {{0.1, 0.2, 0}, {0.4, 0.7, 0}, {0.7, 0.3, 0}, {0.9, 0.6, 0}}
    ));
    return others;
}

std::vector<Vec3> moved(
    std::vector<Vec3> points, const Eigen::Isometry3d& motion, double scale = 1.0
) {
    for (Vec3& p : points) {
        p = motion * Vec3(scale * p);
    }
    return points;
}

// Fairing ends before it has converged to rounding, and coordinates far from the origin have less
// digits.
constexpr double kSame = 1e-5;
constexpr double kSameFarAway = 1e-4;

class Invariance : public testing::TestWithParam<CurveCase> {
protected:
    // Expects that moved and scaled input gives the moved and scaled curve.
    void expectSimilar(const Eigen::Isometry3d& motion, double scale, double same = kSame) const {
        const CurveDesigner designer(transformed(scene_.mesh, motion, scale));
        const Curve curve = designer.design(moved(scene_.picks, motion, scale), scene_.options);
        EXPECT_TRUE(curve.report.usable);
        EXPECT_EQ(curve.report.status, reference_.report.status);
        ASSERT_EQ(curve.spline.knots.size(), reference_.spline.knots.size());
        for (std::size_t i = 0; i < curve.spline.knots.size(); ++i) {
            EXPECT_NEAR(curve.spline.knots[i], reference_.spline.knots[i], same) << "knot " << i;
        }
        SplineData expected = reference_.spline;
        expected.controlPoints = moved(expected.controlPoints, motion, scale);
        EXPECT_LT(largestGap(curve.spline, expected) / designer.surface().diagonal(), same);
        SurfacePolyline line = reference_.polyline;
        line.points = moved(line.points, motion, scale);
        EXPECT_LT(largestDistance(curve.polyline, line) / designer.surface().diagonal(), same);
    }

    // Distance of the two curves in epsilon, the distance tolerance on the mesh of the scene.
    [[nodiscard]] double inEpsilon(double distance) const {
        const double edge = designer_.surface().averageEdgeLength();
        return distance / (scene_.options.distanceTolerance * edge);
    }

    CurveCase scene_ = GetParam();
    CurveDesigner designer_{scene_.mesh};
    Curve reference_ = designer_.design(scene_.picks, scene_.options);
};

class InvarianceFarAway : public Invariance {};

class InvarianceUnderRemeshing : public Invariance {};

TEST_P(Invariance, MotionsMoveTheCurve) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        expectSimilar(random.isometry(2.0), 1.0);
    }
}

TEST_P(Invariance, ScalingScalesTheCurve) {
    for (const double scale : {1e-3, 1e6}) {
        SCOPED_TRACE("scale " + std::to_string(scale));
        expectSimilar(Eigen::Isometry3d::Identity(), scale);
    }
}

TEST_P(InvarianceFarAway, CurvesFarFromTheOriginAreTheSame) {
    Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
    far.translation() = 1e5 * designer_.surface().diagonal() * Vec3(0.6, -0.3, 0.7).normalized();
    expectSimilar(far, 1.0, kSameFarAway);
}

TEST_P(Invariance, ReversedPicksReverseTheCurve) {
    std::vector<Vec3> picks = scene_.picks;
    std::reverse(picks.begin() + (scene_.options.closed ? 1 : 0), picks.end());
    const Curve back = designer_.design(picks, scene_.options);
    EXPECT_TRUE(back.report.usable);
    EXPECT_LT(inEpsilon(largestDistance(reference_.polyline, back.polyline)), 0.1)
        << reference_.report.knotsLast << " and " << back.report.knotsLast << " knots";
    EXPECT_LT(inEpsilon(largestGap(reference_.spline, back.spline, true)), 1.0);
}

TEST_P(InvarianceUnderRemeshing, MidpointSubdivisionHardlyMovesTheCurve) {
    const CurveDesigner fineDesigner(midpointSubdivide(scene_.mesh));
    SolverOptions same = scene_.options;
    same.distanceTolerance *= 2.0;  // the same length: edges are half as long
    const auto expectNear = [&](const Curve& coarse, double mostEpsilon) {
        const Curve fine = fineDesigner.design(scene_.picks, same);
        EXPECT_TRUE(fine.report.usable);
        EXPECT_LT(inEpsilon(largestDistance(coarse.polyline, fine.polyline)), mostEpsilon)
            << coarse.report.knotsLast << " and " << fine.report.knotsLast << " knots";
    };
    // Curvature is seen by the normals around vertices, and the new vertices have their own.
    expectNear(reference_, 5.0);
    same.fairness = Fairness::Parametric;
    SolverOptions parametric = scene_.options;
    parametric.fairness = Fairness::Parametric;
    expectNear(designer_.design(scene_.picks, parametric), 1.0);
}

TEST_P(InvarianceUnderRemeshing, RenumberingMovesTheCurveByLessThanTwoEpsilon) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Curve curve =
            CurveDesigner(renumbered(scene_.mesh, seed)).design(scene_.picks, scene_.options);
        EXPECT_TRUE(curve.report.usable);
        EXPECT_LT(inEpsilon(largestDistance(reference_.polyline, curve.polyline)), 2.0)
            << reference_.report.knotsLast << " and " << curve.report.knotsLast << " knots";
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Invariance,
    testing::ValuesIn(irregularScenes({sphere(), block()})),
    testing::PrintToStringParamName()
);
INSTANTIATE_TEST_SUITE_P(
    All,
    InvarianceFarAway,
    testing::ValuesIn(irregularScenes({block()})),
    testing::PrintToStringParamName()
);
INSTANTIATE_TEST_SUITE_P(
    All,
    InvarianceUnderRemeshing,
    testing::ValuesIn(irregularScenes({sphere()})),
    testing::PrintToStringParamName()
);

TEST(Determinism, TwoRunsGiveTheSameBits) {
    const CurveCase s = noisySphere();
    const CurveDesigner designer(s.mesh);
    const Curve first = designer.design(s.picks, s.options);
    const Curve again = designer.design(s.picks, s.options);
    const Curve fresh = CurveDesigner(s.mesh).design(s.picks, s.options);
    for (const Curve& other : {again, fresh}) {
        expectSameBits(other, first);
        EXPECT_EQ(other.report.newtonIterations, first.report.newtonIterations);
    }
}

}  // namespace
}  // namespace bspline_curve
