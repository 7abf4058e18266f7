// SPDX-License-Identifier: GPL-3.0-or-later
// Curves under fields that are made from the surface: they find its features.
#include "curve_checks.h"
#include "field/make_field.h"
#include "support/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kPi = std::numbers::pi;

/// A curve along a field of a kind, with the kind's natural cost.
Curve curveAlong(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const FieldOptions& field,
    SolverOptions options = {}
) {
    const ScalarField values = makeField(designer.surface(), field);
    options.fieldCost = naturalCost(field.kind);
    return goodCurve(designer, picks, options, {.field = values});
}

// ---- Torus ----

constexpr double kTube = 0.6;  // of a torus about a circle of radius 1

Vec3 onTorus(double around, double tube) {
    const double radius = 1.0 + kTube * std::cos(tube);
    return {radius * std::cos(around), radius * std::sin(around), kTube * std::sin(tube)};
}

/// How far round the tube from the outer circle, in [0, pi].
double fromOuterCircle(const Vec3& p) {
    return std::abs(std::atan2(p.z(), p.head<2>().norm() - 1.0));
}

class TorusField : public EitherShell {
protected:
    [[nodiscard]] Curve along(
        const CurveDesigner& designer, FieldOptions field, const SolverOptions& options = {}
    ) const {
        return curveAlong(designer, picks_, field, options);
    }

    // Away from the picks, between which the curve may come down to a circle.
    [[nodiscard]] double meanFromOuter(const Curve& curve) const {
        return meanWhere(curve.polyline, fromOuterCircle, [this](const Vec3& p) {
            return std::ranges::all_of(picks_, [&](const Vec3& pick) {
                return (p - pick).norm() > 0.8;
            });
        });
    }

    TriangleMesh mesh_ = torus(96, 48, 1.0, kTube);
    // Vertices half way up, where both circles are as near.
    std::vector<Vec3> picks_ = {onTorus(0.0, 0.5 * kPi), onTorus(0.75 * kPi, 0.5 * kPi)};
};

// Without a field the curve cuts the corner: 2.34. Valleys are deepest on the inner circle, since
// the tube is thicker than the hole.
TEST_P(TorusField, ValleyDrawsTheCurveToTheInnerCircle) {
    const CurveDesigner designer = designerOn(mesh_);
    EXPECT_LT(meanFromOuter(designer.design(picks_)), 2.5);
    EXPECT_GT(meanFromOuter(along(designer, {.kind = FieldKind::Valley})), kPi - 0.15);
}

// The field is the same all over the outer half, and drops behind the picks.
TEST_P(TorusField, RidgeHoldsTheCurveOnTheOuterHalf) {
    const CurveDesigner designer = designerOn(mesh_);
    EXPECT_GT(meanFromOuter(designer.design(picks_)), 2.2);
    EXPECT_LT(meanFromOuter(along(designer, {.kind = FieldKind::Ridge})), 0.5 * kPi + 0.05);
}

// (25) is 1 / r everywhere: what is left are the errors of the fit.
TEST_P(TorusField, MaximalCurvatureHasNoSay) {
    const CurveDesigner designer = designerOn(mesh_);
    const double free = meanFromOuter(designer.design(picks_));
    const Curve curve = along(designer, {.kind = FieldKind::MaximalCurvature});
    EXPECT_NEAR(meanFromOuter(curve), free, 0.1);
}

// Turned inside out the largest curvature is that along the circles.
TEST_P(TorusField, MaximalCurvatureOfTheInsideTellsTheCirclesApart) {
    const CurveDesigner designer = designerOn(insideOut(mesh_));
    const FieldOptions inner{.kind = FieldKind::MaximalCurvature};
    const FieldOptions outer{.kind = FieldKind::MaximalCurvature, .inverted = true};
    EXPECT_GT(meanFromOuter(along(designer, inner)), kPi - 0.15);
    // The way round the outside is longer by half, so it takes more weight.
    EXPECT_LT(meanFromOuter(along(designer, outer)), 0.6);
    EXPECT_LT(meanFromOuter(along(designer, outer, {.fieldWeight = 1e4})), 0.25);
}

INSTANTIATE_TEST_SUITE_P(Shells, TorusField, kEitherShell, nameOfShell);

// ---- A groove along a helix, engraved in a cylinder ----

// The groove has the profile -kDepth exp(-(s / kWidth)^2), s the distance along the unrolled
// cylinder.
constexpr double kDepth = 0.1, kWidth = 0.12;

struct Helix {
    double pitch = 2.5;
    int segments = 128;  // of the mesh, an unrolled grid of nearly square cells

    static constexpr double kStart = 0.5, kTurns = 1.5;

    [[nodiscard]] double edge() const { return 2.0 * kPi / segments; }

    [[nodiscard]] double distance(const Vec3& p) const {
        const double turns = std::atan2(p.y(), p.x()) / (2.0 * kPi);
        const double above = (p.z() - kStart) / pitch - turns;
        const double slope = std::atan2(pitch, 2.0 * kPi);
        return std::abs(above - std::round(above)) * pitch * std::cos(slope);
    }

    [[nodiscard]] TriangleMesh engraved() const {
        const double height = 2.0 * kStart + kTurns * pitch;
        const auto rings = static_cast<int>(std::lround(height / edge()));
        TriangleMesh mesh = openCylinder(segments, rings, 1.0, height);
        for (Vec3& v : mesh.vertices) {
            v.head<2>() *= 1.0 - kDepth * std::exp(-std::pow(distance(v) / kWidth, 2.0));
        }
        return mesh;
    }

    /// The vertices next to points of the helix.
    [[nodiscard]] std::vector<Vec3> picks(
        const TriangleMesh& mesh, const std::vector<double>& turns
    ) const {
        std::vector<Vec3> points;
        for (const double turn : turns) {
            const double angle = 2.0 * kPi * turn;
            points.emplace_back(std::cos(angle), std::sin(angle), kStart + pitch * turn);
        }
        return verticesNear(mesh.vertices, points);
    }

    [[nodiscard]] double meanDistance(const Curve& curve) const {
        return meanWhere(curve.polyline, [this](const Vec3& p) { return distance(p); });
    }
};

const FieldOptions kValley{.kind = FieldKind::Valley};

// The way along the groove is twice as long as the one across: the first curve must lie in the
// groove, since no small change of the one across leads there.
TEST(HelixField, CurvesFollowTheGrooveByTheirFirstPath) {
    const Helix helix;
    const TriangleMesh mesh = helix.engraved();
    const CurveDesigner designer(mesh);
    for (const double turns : {1.0, 1.5}) {
        SCOPED_TRACE(std::to_string(turns) + " turns");
        const std::vector<Vec3> picks = helix.picks(mesh, {0.0, turns});
        const Curve along = curveAlong(designer, picks, kValley);
        const Curve unaided = curveAlong(designer, picks, kValley, {.fieldGuidesPath = false});
        EXPECT_LT(helix.meanDistance(along), 0.1 * kWidth);
        EXPECT_GT(helix.meanDistance(designer.design(picks)), 3.0 * kWidth);
        EXPECT_GT(helix.meanDistance(unaided), kWidth);
        EXPECT_LT(along.report.fieldCost, 0.5 * unaided.report.fieldCost);
    }
}

TEST(HelixField, CurvesFollowTheGrooveOfANoisyMesh) {
    const Helix helix;
    for (const std::uint64_t seed : {3U, 4U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const TriangleMesh mesh = withNoise(helix.engraved(), 0.05 * helix.edge(), seed);
        const CurveDesigner designer(mesh);
        const Curve curve = curveAlong(designer, helix.picks(mesh, {0.0, 1.0}), kValley);
        // Half an edge: curvature sees the noise of two rings.
        EXPECT_LT(helix.meanDistance(curve), 0.5 * helix.edge());
    }
}

// Rounding alone differs; 1e-11 measured.
TEST(FieldUnits, TheSameWeightMeansTheSameInEveryUnit) {
    const Helix helix;
    const TriangleMesh mesh = withNoise(helix.engraved(), 0.002, 3);
    const std::vector<Vec3> picks = helix.picks(mesh, {0.0, 0.6, 1.2});
    const Curve reference = curveAlong(CurveDesigner(mesh), picks, kValley);
    const double diagonal = Surface(mesh).diagonal();
    for (const double scale : {1e-3, 1e3}) {
        SCOPED_TRACE("scale " + std::to_string(scale));
        const CurveDesigner scaled(transformed(mesh, Eigen::Isometry3d::Identity(), scale));
        std::vector<Vec3> scaledPicks = picks;
        for (Vec3& pick : scaledPicks) {
            pick *= scale;
        }
        Curve curve = curveAlong(scaled, scaledPicks, kValley);
        for (Vec3& control : curve.spline.controlPoints) {
            control /= scale;
        }
        EXPECT_LT(largestGap(curve.spline, reference.spline), 1e-6 * diagonal);
        EXPECT_NEAR(curve.report.fieldCost, reference.report.fieldCost, 1e-6);
    }
}

// ---- Obstacles, after Fig. 16 ----

class HillsBetweenPicks : public EitherShell {
protected:
    struct Disc {
        Vec3 centre;
        double radius;
    };

    static constexpr double kEdge = 0.02;

    /// Whether p is in one of the discs, `margin` inside.
    static bool isInside(const Vec3& p, double margin) {
        return std::ranges::any_of(kDiscs, [&](const Disc& disc) {
            return (p - disc.centre).norm() < disc.radius - margin;
        });
    }

    // Share of the length; an edge inside, since the region is ragged.
    static double shareInside(const Curve& curve) {
        return meanWhere(curve.polyline, [](const Vec3& p) {
            return isInside(p, kEdge) ? 1.0 : 0.0;
        });
    }

    inline static const std::vector<Disc> kDiscs = {{{0.3, 0.35, 0}, 0.1}, {{0.55, 0.62, 0}, 0.08}};
    CurveDesigner designer_ = designerOn(jitteredPlate(50, 50, 0.2, 3));
    std::vector<Vec3> picks_ = {{0.1, 0.2, 0}, {0.5, 0.45, 0}, {0.6, 0.8, 0}, {0.9, 0.9, 0}};
};

TEST_P(HillsBetweenPicks, TurnTheCurveAside) {
    const Region faces =
        facesWhere(designer_.surface(), [](const Vec3& p) { return isInside(p, 0.0); });
    const ScalarField field =
        makeField(designer_.surface(), {.kind = FieldKind::Obstacle}, {.region = faces});
    const double straight = shareInside(designer_.design(picks_));
    const Curve aside = goodCurve(designer_, picks_, {}, {.field = field});
    const Curve avoiding = goodCurve(designer_, picks_, {}, {.avoid = faces});
    EXPECT_GT(straight, 0.1);
    EXPECT_LT(shareInside(aside), 0.25 * straight);
    EXPECT_LT(aside.report.fieldCost, 1e-3);  // of hills of 1.1
    EXPECT_EQ(shareInside(avoiding), 0.0);
    EXPECT_GT(avoiding.report.clearance, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Shells, HillsBetweenPicks, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
