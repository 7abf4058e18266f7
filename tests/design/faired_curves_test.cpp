// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of least curvature (Fairness::Curvature), judged from the outside.
#include "design/curve_checks.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Whatever closed curve of the plane turns once has so much at least, and only the circle that.
constexpr double kOfCircle = 4.0 * std::numbers::pi * std::numbers::pi;

/// The length times the integral of the squared curvature along the surface of a spline, by points
/// at even steps of its parameter; `normalAt`: of the surface.
template <class NormalAt>
double bendingOf(const SplineData& spline, const NormalAt& normalAt) {
    constexpr int kPoints = 400;
    std::vector<Vec3> points;
    for (int i = 0; i <= kPoints; ++i) {
        points.push_back(pointOfSpline(spline, static_cast<double>(i) / kPoints));
    }
    double length = 0.0;
    double bending = 0.0;
    for (int i = 1; i <= kPoints; ++i) {
        const Vec3 in = points[i] - points[i - 1];
        length += in.norm();
        if (i < kPoints) {
            const Vec3 out = points[i + 1] - points[i];
            const double turn = std::atan2(normalAt(points[i]).dot(in.cross(out)), in.dot(out));
            bending += turn * turn / (0.5 * (in.norm() + out.norm()));
        }
    }
    return length * bending;
}

double bendingOnPlate(const Curve& curve) {
    return bendingOf(curve.spline, [](const Vec3&) { return Vec3(Vec3::UnitZ()); });
}

double bendingOnSphere(const Curve& curve) {
    return bendingOf(curve.spline, [](const Vec3& p) { return p.normalized(); });
}

Curve parametric(
    const CurveDesigner& designer, const std::vector<Vec3>& picks, SolverOptions options = {}
) {
    options.fairness = Fairness::Parametric;
    return goodCurve(designer, picks, options);
}

Vec3 onCircle(double angle) {
    return {0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle), 0.0};
}

TEST(FairedCurves, AreCirclesWherePicksLieOnOne) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    std::vector<Vec3> picks;
    for (const double angle : {0.0, 0.4, 1.7, 3.0, 5.1}) {  // unevenly
        picks.push_back(onCircle(angle));
    }
    const Curve curve = goodCurve(designer, picks, {.closed = true});
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = pointOfSpline(curve.spline, i / 200.0) - Vec3(0.5, 0.5, 0.0);
        EXPECT_NEAR(point.norm(), 0.3, 3e-3) << i;
    }
    EXPECT_NEAR(bendingOnPlate(curve), kOfCircle, 0.02 * kOfCircle);
    EXPECT_GT(bendingOnPlate(parametric(designer, picks, {.closed = true})), 1.03 * kOfCircle);
}

TEST(FairedCurves, AreGreatCirclesWherePicksLieOnOne) {
    const CurveDesigner designer(icosphere(5));
    const Vec3 a = Vec3(1.0, 0.2, 0.1).normalized();
    const Vec3 normal = a.cross(Vec3(0.1, 1.0, 0.4)).normalized();
    std::vector<Vec3> picks;
    for (const double angle : {0.0, 0.2, 1.3, 2.0}) {
        const Vec3 point = std::cos(angle) * a + std::sin(angle) * normal.cross(a);
        picks.push_back(designer.surface().position(designer.tree().closestPoint(point).point));
    }
    const Curve curve = goodCurve(designer, picks);
    for (const Vec3& point : curve.polyline.points) {
        EXPECT_LT(std::abs(normal.dot(point)), 1e-3);
    }
    EXPECT_LT(bendingOnSphere(curve), 0.05);
}

struct PicksOnPlate {
    std::vector<Vec3> picks;
    double mostShare;  // of the bending of the parametric curve
};

/// `mostLength`: of the length of the parametric curve.
void expectToBendLess(const std::vector<PicksOnPlate>& sets, double mostLength) {
    const CurveDesigner plate(jitteredPlate(40, 40, 0.2, 3));
    for (const auto& [picks, mostShare] : sets) {
        SCOPED_TRACE(mostShare);
        const Curve curve = goodCurve(plate, picks);
        const Curve before = parametric(plate, picks);
        EXPECT_LT(bendingOnPlate(curve), mostShare * bendingOnPlate(before));
        EXPECT_LT(length(curve.polyline), mostLength * length(before.polyline));
    }
}

// Two picks close to each other make no hook, a U-turn no cusp.
TEST(FairedCurves, BendLessThanParametricOnes) {
    const std::vector<PicksOnPlate> sets = {
        {{{0.1, 0.2, 0}, {0.5, 0.5, 0}, {0.53, 0.5, 0}, {0.9, 0.2, 0}}, 1.0},
        {{{0.2, 0.1, 0}, {0.2, 0.8, 0}, {0.3, 0.83, 0}, {0.32, 0.2, 0}}, 0.8},
        {{{0.1, 0.5, 0}, {0.2, 0.52, 0}, {0.7, 0.3, 0}, {0.72, 0.6, 0}, {0.9, 0.5, 0}}, 0.65},
    };
    expectToBendLess(sets, 1.3);
}

// The energy does not see the parameter: a curve through more picks of its own is the same one.
TEST(FairedCurves, StayWhereMorePicksLieOnThem) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = {{0.1, 0.3, 0}, {0.4, 0.7, 0}, {0.6, 0.35, 0}, {0.9, 0.6, 0}};
    const Curve curve = goodCurve(designer, picks);
    const std::vector<double>& parameters = curve.spline.pickParameters;
    const double between = 0.5 * (parameters[1] + parameters[2]);
    for (const double step : {0.0, 0.02}) {
        std::vector<Vec3> more = picks;
        more.insert(more.begin() + 2, pointOfSpline(curve.spline, between));
        if (step > 0.0) {
            more.insert(more.begin() + 3, pointOfSpline(curve.spline, between + step));
        }
        const Curve again = goodCurve(designer, more);
        EXPECT_LT(largestDistance(curve.polyline, again.polyline), 2e-3) << step;
    }
}

TEST(FairedCurves, AreSimilarOnLargerMeshes) {
    const std::vector<Vec3> picks = {{0.1, 0.3, 0}, {0.4, 0.7, 0}, {0.6, 0.35, 0}, {0.9, 0.6, 0}};
    TriangleMesh mesh = jitteredPlate(30, 30, 0.2, 3);
    const Curve curve = goodCurve(CurveDesigner(mesh), picks);
    std::vector<Vec3> larger;
    for (const Vec3& pick : picks) {
        larger.emplace_back(1000.0 * pick);
    }
    for (Vec3& vertex : mesh.vertices) {
        vertex *= 1000.0;
    }
    Curve again = goodCurve(CurveDesigner(mesh), larger);
    for (Vec3& point : again.polyline.points) {
        point /= 1000.0;
    }
    EXPECT_LT(largestDistance(curve.polyline, again.polyline), 1e-6);
}

// Tension shortens.
TEST(FairedCurves, BecomeShorterWithTension) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = {{0.2, 0.1, 0}, {0.2, 0.8, 0}, {0.4, 0.83, 0}, {0.5, 0.2, 0}};
    double before = 1e9;
    for (const double tension : {0.0, 0.2, 0.4}) {
        const double now = length(goodCurve(designer, picks, {.tension = tension}).polyline);
        EXPECT_LT(now, before) << tension;
        before = now;
    }
}

// The curve of least bending would leave the plate; the one that is drawn does not.
TEST(FairedCurves, StayOnASurfaceThatEnds) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    goodCurve(designer, {{0.1, 0.5, 0}, {0.45, 0.99, 0}, {0.55, 0.99, 0}, {0.9, 0.5, 0}});
    goodCurve(
        designer,
        {{0.05, 0.05, 0}, {0.95, 0.05, 0}, {0.95, 0.95, 0}, {0.05, 0.95, 0}},
        {.closed = true}
    );
}

// Where picks turn back curves go round in an arc, beside the boundary as well, and on it.
TEST(FairedCurves, UnfoldWherePicksTurnBack) {
    const std::vector<PicksOnPlate> sets = {
        {{{0.3, 0.1, 0}, {0.32, 0.97, 0}, {0.5, 0.1, 0}}, 0.2},
        {{{0.3, 0.9, 0}, {0.5, 1.0, 0}, {0.45, 0.9, 0}}, 0.25},
        {{{0.2, 0.5, 0}, {0.5, 0.52, 0}, {0.45, 0.48, 0}, {0.8, 0.55, 0}}, 0.35},
    };
    expectToBendLess(sets, 1.6);
}

// Where a weak field begins to pull, no other curve takes over.
TEST(FairedCurves, GiveWayToAFieldLittleByLittle) {
    const TriangleMesh mesh = icosphere(4);
    const CurveDesigner designer(mesh);
    const std::vector<double> field =
        sampled(mesh, [](const Vec3& v) { return 0.5 + 0.5 * v.z(); });
    const std::vector<Vec3> picks = verticesNear(mesh.vertices, kSpherePicks);
    const Curve without = goodCurve(designer, picks);
    double before = 0.0;
    for (const double weight : {1e-6, 1e-2, 1.0}) {
        const Curve with = goodCurve(designer, picks, {.fieldWeight = weight}, {.field = field});
        const double moved = largestDistance(without.polyline, with.polyline);
        EXPECT_LT(moved, before + 0.03) << weight;
        before = moved;
    }
}

}  // namespace
}  // namespace bspline_curve
