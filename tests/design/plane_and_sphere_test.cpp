// SPDX-License-Identifier: GPL-3.0-or-later
// Curves whose answer is known: interpolating splines and straight lines on a plane, great circles
// on a sphere.
#include "cubic_interpolation.h"
#include "curve_checks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

const std::vector<Vec3> kOpenPicks = {
    {0.1, 0.25, 0}, {0.33, 0.7, 0}, {0.6, 0.35, 0}, {0.72, 0.66, 0}, {0.9, 0.5, 0}
};
const std::vector<Vec3> kClosedPicks = {
    {0.3, 0.25, 0}, {0.71, 0.32, 0}, {0.8, 0.66, 0}, {0.52, 0.6, 0}, {0.2, 0.7, 0}
};

void expectNear(const Curve& curve, const std::function<Vec3(double)>& expected) {
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        EXPECT_LT((pointOfSpline(curve.spline, t) - expected(t)).norm(), 1e-6) << "t = " << t;
    }
}

class Plates : public testing::TestWithParam<std::tuple<ShellKind, std::string>> {
protected:
    [[nodiscard]] static TriangleMesh mesh() {
        const std::string& name = std::get<1>(GetParam());
        return name == "Coarse" ? plate(5, 7)
               : name == "Fine" ? plate(40, 40)
                                : jitteredPlate(20, 20, 0.25, 5);
    }

    /// Expects that the curve of the paper's energy is the cubic spline that interpolates the
    /// picks.
    void expectCubic(const std::vector<Vec3>& picks, bool closed) const {
        const SolverOptions options{.closed = closed, .fairness = Fairness::Parametric};
        const Curve curve = goodCurve(designer_, picks, options);
        const CubicInterpolation expected(curve.spline.pickParameters, picks, closed);
        expectNear(curve, [&](double t) { return expected.at(t); });
    }

    /// Expects that a tense curve strays from the segments between picks by 1 % of their distance
    /// at most.
    void expectSegments(const std::vector<Vec3>& picks, bool closed) const;

    CurveDesigner designer_ = designerIn(std::get<0>(GetParam()), mesh());
};

TEST_P(Plates, OpenCurvesWithoutTensionAreNaturalCubicSplines) {
    expectCubic(kOpenPicks, false);
}

TEST_P(Plates, ClosedCurvesWithoutTensionArePeriodicCubicSplines) {
    expectCubic(kClosedPicks, true);
}

TEST_P(Plates, ThreePicksAreEnoughForAPeriodicCubicSpline) {
    expectCubic({{0.3, 0.3, 0}, {0.75, 0.4, 0}, {0.45, 0.72, 0}}, true);
}

TEST_P(Plates, TwoPicksGiveTheirSegmentWithoutMoreKnots) {
    const Curve curve = goodCurve(designer_, {{0.1, 0.25, 0}, {0.9, 0.61, 0}});
    expectNear(curve, [](double t) { return Vec3(0.1 + 0.8 * t, 0.25 + 0.36 * t, 0); });
    EXPECT_LE(curve.report.knotsLast, 16);
}

void Plates::expectSegments(const std::vector<Vec3>& picks, bool closed) const {
    const Curve curve = goodCurve(designer_, picks, {.closed = closed, .tension = 1.0});
    const SurfacePolyline& line = curve.polyline;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < picks.size(); ++i) {
        const Vec3& a = picks[i];
        const Vec3& b = picks[(i + 1) % picks.size()];
        const int end =
            i + 1 < picks.size() ? line.picks[i + 1] : static_cast<int>(line.points.size());
        for (int j = line.picks[i]; j < end; ++j) {
            EXPECT_LT(distanceToSegment(line.points[j], a, b), 0.01 * (b - a).norm())
                << curve.report.knotsLast << " knots";
        }
    }
}

TEST_P(Plates, OpenCurvesWithFullTensionAreSegments) {
    expectSegments(kOpenPicks, false);
}

TEST_P(Plates, ClosedCurvesWithFullTensionAreSegments) {
    expectSegments(kClosedPicks, true);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Plates,
    testing::Combine(kEitherShell, testing::Values("Coarse", "Fine", "Jittered")),
    [](const auto& instance) {
        return std::get<1>(instance.param) + nameOf(std::get<0>(instance.param));
    }
);

// Angle between a point and the great circle through two others.
double angleToGreatCircle(const Vec3& p, const Vec3& a, const Vec3& b) {
    return std::abs(std::asin(p.normalized().dot(a.cross(b).normalized())));
}

class Spheres : public EitherShell {};

// A spline rounds the corner at a pick, as on the plane: the same 1 % of the pick distance. Between
// picks, polyhedron and sphere differ by far less (sagitta: 1e-3 at 4 subdivisions).
TEST_P(Spheres, CurvesWithFullTensionAreGreatCircles) {
    const std::vector<Vec3> picks = {
        Vec3(1, 0.1, 0.05).normalized(),
        Vec3(0.1, 1, 0.3).normalized(),
        Vec3(-0.5, 0.3, 1).normalized(),
        Vec3(-0.4, -1, 0.6).normalized()
    };
    for (const int subdivisions : {4, 5}) {
        SCOPED_TRACE(std::to_string(subdivisions) + " subdivisions");
        const CurveDesigner sphere = designerOn(icosphere(subdivisions));
        const Curve curve = sphere.design(picks, {.tension = 1.0});
        EXPECT_TRUE(curve.report.usable);
        expectStrict(sphere.surface(), curve.polyline);
        for (std::size_t i = 0; i + 1 < picks.size(); ++i) {
            const double distance = std::acos(picks[i].dot(picks[i + 1]));
            for (int j = curve.polyline.picks[i]; j < curve.polyline.picks[i + 1]; ++j) {
                const Vec3& p = curve.polyline.points[j];
                EXPECT_LT(angleToGreatCircle(p, picks[i], picks[i + 1]), 0.01 * distance)
                    << curve.report.knotsLast << " knots";
            }
        }
    }
}

// By symmetry a smooth curve through points of one great circle is that circle.
TEST_P(Spheres, ClosedCurvesThroughAGreatCircleAreThatCircle) {
    Random random(3);
    const CurveDesigner sphere = designerOn(icosphere(4));
    const Eigen::Quaterniond turn(random.isometry(0.0).rotation());
    std::vector<Vec3> picks;
    for (const double angle : {0.1, 1.3, 2.9, 4.0, 5.2}) {
        picks.emplace_back(turn * Vec3(std::cos(angle), std::sin(angle), 0.0));
    }
    const Curve curve = sphere.design(picks, {.closed = true});
    EXPECT_TRUE(curve.report.usable);
    expectStrict(sphere.surface(), curve.polyline);
    const Vec3 axis = turn * Vec3::UnitZ();
    const double tolerance = 0.1 * sphere.surface().averageEdgeLength();
    for (const Vec3& p : curve.polyline.points) {
        EXPECT_LT(std::abs(p.dot(axis)), tolerance);
    }
    EXPECT_NEAR(length(curve.polyline), 2.0 * std::numbers::pi, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shells, Spheres, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
