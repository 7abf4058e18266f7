// SPDX-License-Identifier: GPL-3.0-or-later
// What a curve must not depend on: where the mesh lies, how large it is, how it is numbered, how it
// is triangulated, from which end the picks are given.
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "support/meshes.h"
#include "support/random.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

struct Scene {
    std::string name;
    TriangleMesh mesh;
    std::vector<Vec3> picks;
    SolverOptions options;
};

// Points of faces, so that they are on the surface whatever happens to it later.
std::vector<Vec3> onFaces(const TriangleMesh& mesh, const std::vector<Vec3>& wishes) {
    std::vector<Vec3> picks;
    for (const Vec3& wish : wishes) {
        double nearest = 1e300;
        Vec3 pick = wish;
        for (const Triangle& face : mesh.faces) {
            Vec3 point = Vec3::Zero();
            const std::array<double, 3> weights = {0.21, 0.33, 0.46};
            for (std::size_t k = 0; k < 3; ++k) {
                point += weights[k] * mesh.vertices[face[k]];
            }
            if ((point - wish).squaredNorm() < nearest) {
                nearest = (point - wish).squaredNorm();
                pick = point;
            }
        }
        picks.push_back(pick);
    }
    return picks;
}

Scene scene(const std::string& name) {
    Scene result;
    result.name = name;
    std::vector<Vec3> wishes = {{1, 0.1, 0.2}, {0.2, 1, 0.1}, {-0.7, 0.3, 0.7}, {-0.3, -0.9, 0.2}};
    if (name.starts_with("NoisySphere")) {
        result.mesh = withNoise(icosphere(3), 0.02, 17);
        result.options.closed = name == "NoisySphereClosed";
    } else if (name == "Sphere") {
        result.mesh = icosphere(3);
    } else if (name == "Torus") {
        result.mesh = torus(48, 20);
        wishes = {{1.3, 0.1, 0.1}, {0.1, 1.0, 0.3}, {-0.9, 0.5, -0.25}, {-0.8, -0.8, 0.2}};
    } else if (name == "Box") {
        result.mesh = box(10, {1.0, 0.8, 0.6});
        wishes = {{0.9, 0.1, 0.6}, {0.5, 0.5, 0.6}, {0.2, 0.8, 0.4}, {0.7, 0.8, 0.2}};
    } else {
        result.mesh = jitteredPlate(15, 15, 0.25, 5);
        wishes = {{0.1, 0.2, 0}, {0.4, 0.7, 0}, {0.7, 0.3, 0}, {0.9, 0.6, 0}};
    }
    result.picks = onFaces(result.mesh, wishes);
    return result;
}

std::vector<Vec3> moved(
    std::vector<Vec3> points, const Eigen::Isometry3d& motion, double scale = 1.0
) {
    for (Vec3& p : points) {
        p = motion * Vec3(scale * p);
    }
    return points;
}

class Invariance : public testing::TestWithParam<std::string> {
protected:
    // Expects that moved and scaled input gives the moved and scaled curve.
    void expectSimilar(const Eigen::Isometry3d& motion, double scale) const {
        const CurveDesigner designer(transformed(scene_.mesh, motion, scale));
        const Curve curve = designer.design(moved(scene_.picks, motion, scale), scene_.options);
        const Curve reference = CurveDesigner(scene_.mesh).design(scene_.picks, scene_.options);
        EXPECT_TRUE(curve.report.usable);
        EXPECT_EQ(curve.report.status, reference.report.status);
        ASSERT_EQ(curve.spline.knots.size(), reference.spline.knots.size());
        for (std::size_t i = 0; i < curve.spline.knots.size(); ++i) {
            EXPECT_NEAR(curve.spline.knots[i], reference.spline.knots[i], 1e-6) << "knot " << i;
        }
        SplineData expected = reference.spline;
        expected.controlPoints = moved(expected.controlPoints, motion, scale);
        EXPECT_LT(largestGap(curve.spline, expected) / surfaceOf(designer).diagonal(), 1e-6);
        SurfacePolyline line = reference.polyline;
        line.points = moved(line.points, motion, scale);
        EXPECT_LT(largestDistance(curve.polyline, line) / surfaceOf(designer).diagonal(), 1e-6);
    }

    // Distance of the two curves in epsilon, the distance tolerance on the mesh of the scene.
    [[nodiscard]] double inEpsilon(double distance) const {
        const Surface surface(scene_.mesh);
        return distance / (scene_.options.distanceTolerance * surface.averageEdgeLength());
    }

    Scene scene_ = scene(GetParam());
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
    far.translation() = 1e5 * Surface(scene_.mesh).diagonal() * Vec3(0.6, -0.3, 0.7).normalized();
    expectSimilar(far, 1.0);
}

TEST_P(Invariance, ReversedPicksReverseTheCurve) {
    const CurveDesigner designer(scene_.mesh);
    const Curve forth = designer.design(scene_.picks, scene_.options);
    std::vector<Vec3> picks = scene_.picks;
    std::reverse(picks.begin() + (scene_.options.closed ? 1 : 0), picks.end());
    const Curve back = designer.design(picks, scene_.options);
    EXPECT_TRUE(back.report.usable);
    EXPECT_LT(inEpsilon(largestDistance(forth.polyline, back.polyline)), 0.1)
        << forth.report.knotsLast << " and " << back.report.knotsLast << " knots";
    EXPECT_LT(inEpsilon(largestGap(forth.spline, back.spline, true)), 1.0);
}

TEST_P(InvarianceUnderRemeshing, MidpointSubdivisionMovesTheCurveByLessThanEpsilon) {
    const Curve coarse = CurveDesigner(scene_.mesh).design(scene_.picks, scene_.options);
    const CurveDesigner fineDesigner(midpointSubdivide(scene_.mesh));
    SolverOptions same = scene_.options;
    same.distanceTolerance *= 2.0;  // the same length: edges are half as long
    const Curve fine = fineDesigner.design(scene_.picks, same);
    EXPECT_TRUE(fine.report.usable);
    EXPECT_LT(inEpsilon(largestDistance(coarse.polyline, fine.polyline)), 1.0)
        << coarse.report.knotsLast << " and " << fine.report.knotsLast << " knots";
}

TEST_P(InvarianceUnderRemeshing, RenumberingMovesTheCurveByLessThanTwoEpsilon) {
    const Curve reference = CurveDesigner(scene_.mesh).design(scene_.picks, scene_.options);
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Curve curve =
            CurveDesigner(renumbered(scene_.mesh, seed)).design(scene_.picks, scene_.options);
        EXPECT_TRUE(curve.report.usable);
        EXPECT_LT(inEpsilon(largestDistance(reference.polyline, curve.polyline)), 2.0)
            << reference.report.knotsLast << " and " << curve.report.knotsLast << " knots";
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Invariance,
    testing::Values("NoisySphere", "NoisySphereClosed", "Sphere", "Torus", "Box", "Plate"),
    [](const auto& testInfo) { return testInfo.param; }
);

INSTANTIATE_TEST_SUITE_P(
    All,
    InvarianceFarAway,
    testing::Values("NoisySphere", "NoisySphereClosed", "Torus", "Box", "Plate"),
    [](const auto& testInfo) { return testInfo.param; }
);

INSTANTIATE_TEST_SUITE_P(
    All,
    InvarianceUnderRemeshing,
    testing::Values("NoisySphere", "NoisySphereClosed", "Sphere", "Torus", "Plate"),
    [](const auto& testInfo) { return testInfo.param; }
);

TEST(Determinism, TwoRunsGiveTheSameBits) {
    const Scene s = scene("NoisySphere");
    const CurveDesigner designer(s.mesh);
    const Curve first = designer.design(s.picks, s.options);
    const Curve again = designer.design(s.picks, s.options);
    const Curve fresh = CurveDesigner(s.mesh).design(s.picks, s.options);
    for (const Curve& other : {again, fresh}) {
        EXPECT_EQ(other.spline.knots, first.spline.knots);
        EXPECT_EQ(other.spline.controlPoints, first.spline.controlPoints);
        EXPECT_EQ(other.polyline.points, first.polyline.points);
        EXPECT_EQ(other.polyline.parameters, first.polyline.parameters);
        EXPECT_EQ(other.polyline.picks, first.polyline.picks);
        EXPECT_EQ(other.report.newtonIterations, first.report.newtonIterations);
    }
}

}  // namespace
}  // namespace bspline_curve
