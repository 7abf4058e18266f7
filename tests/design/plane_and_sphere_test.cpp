// SPDX-License-Identifier: GPL-3.0-or-later
// Curves whose answer is known: interpolating splines and straight lines on a plane, great circles
// on a sphere.
#include "cubic_interpolation.h"
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "either_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

namespace bspline_curve {
namespace {

using namespace test_support;

const std::vector<Vec3> kOpenPicks = {
    {0.1, 0.25, 0}, {0.33, 0.7, 0}, {0.6, 0.35, 0}, {0.72, 0.66, 0}, {0.9, 0.5, 0}
};
const std::vector<Vec3> kClosedPicks = {
    {0.3, 0.25, 0}, {0.71, 0.32, 0}, {0.8, 0.66, 0}, {0.52, 0.6, 0}, {0.2, 0.7, 0}
};

double largestDifference(const SplineData& spline, const CubicInterpolation& expected) {
    double largest = 0.0;
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        largest = std::max(largest, (pointOfSpline(spline, t) - expected.at(t)).norm());
    }
    return largest;
}

class Plates : public testing::TestWithParam<std::tuple<ShellKind, std::string>> {
protected:
    [[nodiscard]] static CurveDesigner designer() {
        const auto& [kind, mesh] = GetParam();
        if (mesh == "Coarse") {
            return designerIn(kind, plate(5, 7));
        }
        if (mesh == "Fine") {
            return designerIn(kind, plate(40, 40));
        }
        return designerIn(kind, jitteredPlate(20, 20, 0.25, 5));
    }
};

TEST_P(Plates, OpenCurvesWithoutTensionAreNaturalCubicSplines) {
    const CurveDesigner plates = designer();
    const Curve curve = goodCurve(plates, kOpenPicks);
    const auto expected = CubicInterpolation::natural(curve.spline.pickParameters, kOpenPicks);
    EXPECT_LT(largestDifference(curve.spline, expected), 1e-6);
}

TEST_P(Plates, ClosedCurvesWithoutTensionArePeriodicCubicSplines) {
    const CurveDesigner plates = designer();
    const Curve curve = goodCurve(plates, kClosedPicks, closedOptions());
    const auto expected = CubicInterpolation::periodic(curve.spline.pickParameters, kClosedPicks);
    EXPECT_LT(largestDifference(curve.spline, expected), 1e-6);
}

TEST_P(Plates, ThreePicksAreEnoughForAPeriodicCubicSpline) {
    const CurveDesigner plates = designer();
    const std::vector<Vec3> picks = {{0.3, 0.3, 0}, {0.75, 0.4, 0}, {0.45, 0.72, 0}};
    const Curve curve = goodCurve(plates, picks, closedOptions());
    const auto expected = CubicInterpolation::periodic(curve.spline.pickParameters, picks);
    EXPECT_LT(largestDifference(curve.spline, expected), 1e-6);
}

TEST_P(Plates, TwoPicksGiveTheirSegmentWithoutMoreKnots) {
    const CurveDesigner plates = designer();
    const Curve curve = goodCurve(plates, {{0.1, 0.25, 0}, {0.9, 0.61, 0}});
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        const Vec3 expected = Vec3(0.1, 0.25, 0) + t * Vec3(0.8, 0.36, 0);
        EXPECT_LT((pointOfSpline(curve.spline, t) - expected).norm(), 1e-6) << "t = " << t;
    }
    EXPECT_LE(curve.report.knotsLast, 16);
}

// Share of the pick distance by which a polyline strays from the segments between its picks.
double straying(const Curve& curve, const std::vector<Vec3>& picks) {
    const SurfacePolyline& line = curve.polyline;
    double largest = 0.0;
    const std::size_t intervals = picks.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < intervals; ++i) {
        const Vec3& a = picks[i];
        const Vec3& b = picks[(i + 1) % picks.size()];
        const int end =
            i + 1 < picks.size() ? line.picks[i + 1] : static_cast<int>(line.points.size());
        for (int j = line.picks[i]; j < end; ++j) {
            const Vec3& p = line.points[j];
            largest = std::max(largest, distanceToSegment(p, a, b) / (b - a).norm());
        }
    }
    return largest;
}

TEST_P(Plates, OpenCurvesWithFullTensionAreSegments) {
    const CurveDesigner plates = designer();
    SolverOptions options;
    options.tension = 1.0;
    const Curve curve = goodCurve(plates, kOpenPicks, options);
    EXPECT_LT(straying(curve, kOpenPicks), 0.01) << curve.report.knotsLast << " knots";
}

TEST_P(Plates, ClosedCurvesWithFullTensionAreSegments) {
    const CurveDesigner plates = designer();
    SolverOptions options = closedOptions();
    options.tension = 1.0;
    const Curve curve = goodCurve(plates, kClosedPicks, options);
    EXPECT_LT(straying(curve, kClosedPicks), 0.01) << curve.report.knotsLast << " knots";
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
        const CurveDesigner sphere = designerOn(icosphere(subdivisions));
        SolverOptions options;
        options.tension = 1.0;
        const Curve curve = sphere.design(picks, options);
        EXPECT_TRUE(curve.report.usable);
        expectStrict(surfaceOf(sphere), curve.polyline);
        double largest = 0.0;
        for (std::size_t i = 0; i + 1 < picks.size(); ++i) {
            const double distance = std::acos(picks[i].dot(picks[i + 1]));
            for (int j = curve.polyline.picks[i]; j < curve.polyline.picks[i + 1]; ++j) {
                const Vec3& p = curve.polyline.points[j];
                largest =
                    std::max(largest, angleToGreatCircle(p, picks[i], picks[i + 1]) / distance);
            }
        }
        EXPECT_LT(largest, 0.01) << subdivisions << " subdivisions, " << curve.report.knotsLast
                                 << " knots";
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
    const Curve curve = sphere.design(picks, closedOptions());
    EXPECT_TRUE(curve.report.usable);
    expectStrict(surfaceOf(sphere), curve.polyline);
    const Vec3 axis = turn * Vec3::UnitZ();
    const double tolerance = 0.1 * surfaceOf(sphere).averageEdgeLength();
    for (const Vec3& p : curve.polyline.points) {
        EXPECT_LT(std::abs(p.dot(axis)), tolerance);
    }
    EXPECT_NEAR(length(curve.polyline), 2.0 * std::numbers::pi, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shells, Spheres, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
