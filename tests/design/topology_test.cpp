// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that cross themselves, run over sharp edges, round handles, through many or crowded picks:
// always one chain.
#include "curve_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

const std::vector<Vec3> kEight = {{0.2, 0.2, 0}, {0.8, 0.8, 0}, {0.8, 0.2, 0}, {0.2, 0.8, 0}};

class Topology : public EitherShell {};

TEST_P(Topology, CurvesMayCrossThemselves) {
    const CurveDesigner designer = designerOn(plate(20, 20));
    goodCurve(designer, kEight);
    const Curve closed = goodCurve(designer, kEight, {.closed = true});
    EXPECT_NEAR(turnsAboutZ(closed.polyline, Vec3(0.8, 0.5, 0)), -1.0, 1e-9);
    EXPECT_NEAR(turnsAboutZ(closed.polyline, Vec3(0.2, 0.5, 0)), 1.0, 1e-9);
}

TEST_P(Topology, CurvesMayPassTheSameFaceTwice) {
    const CurveDesigner designer = designerOn(plate(3, 3));
    const Curve curve = goodCurve(designer, kEight);
    // Count the visits: runs of segments in one face.
    std::map<int, int> visits;
    int last = -1;
    for (const SurfacePoint& point : curve.polyline.surfacePoints) {
        if (point.barycentric.minCoeff() > 0.0 && point.face != last) {
            ++visits[point.face];
            last = point.face;
        }
    }
    EXPECT_TRUE(std::any_of(visits.begin(), visits.end(), [](const auto& entry) {
        return entry.second >= 2;
    }));
}

TEST_P(Topology, CurvesMayCrossThemselvesAtAPick) {
    const CurveDesigner designer = designerOn(plate(12, 12));
    const std::vector<Vec3> picks = {
        {0.2, 0.3, 0}, {0.5, 0.5, 0}, {0.8, 0.7, 0}, {0.8, 0.3, 0}, {0.5, 0.5, 0}, {0.2, 0.7, 0}
    };
    goodCurve(designer, picks);
}

TEST_P(Topology, CurvesRunOverSharpEdgesAndCorners) {
    const CurveDesigner designer = designerOn(box(8));
    goodCurve(designer, {{0.5, 0.3, 1}, {1, 0.6, 0.5}});
    goodCurve(designer, {{0.5, 0.3, 1}, {0.7, 0.8, 1}, {1, 0.6, 0.3}});
    // Over the corner (1, 1, 1), and round the whole box.
    goodCurve(designer, {{0.9, 0.85, 1}, {1, 0.9, 0.9}, {0.8, 1, 0.85}});
    const Curve round = goodCurve(
        designer, {{0.5, 0, 0.45}, {1, 0.5, 0.55}, {0.5, 1, 0.5}, {0, 0.5, 0.5}}, {.closed = true}
    );
    EXPECT_NEAR(turnsAboutZ(round.polyline, Vec3(0.5, 0.5, 0)), 1.0, 1e-9);
}

TEST_P(Topology, CurvesRunAlongSharpEdges) {
    const CurveDesigner designer = designerOn(box(8));
    goodCurve(designer, {{0.1, 0.98, 1}, {0.5, 1, 0.97}, {0.9, 0.99, 1}});
    goodCurve(designer, {{0.1, 1, 1}, {0.52, 1, 1}, {0.9, 1, 1}});
}

TEST_P(Topology, ClosedCurvesGoRoundAHandleEitherWay) {
    const TriangleMesh mesh = torus(40, 16);
    const CurveDesigner designer = designerOn(mesh);
    std::vector<Vec3> longWay;
    for (const int i : {0, 9, 21, 30}) {
        longWay.push_back(mesh.vertices[40 * (i % 5) + i]);
    }
    const Curve around = goodCurve(designer, longWay, {.closed = true});
    EXPECT_NEAR(turnsAboutZ(around.polyline), 1.0, 1e-9);

    std::vector<Vec3> tube;
    for (const int j : {0, 4, 7, 12}) {
        tube.push_back(mesh.vertices[40 * j + 3 + j % 3]);
    }
    const Curve meridian = goodCurve(designer, tube, {.closed = true});
    EXPECT_NEAR(turnsAboutZ(meridian.polyline), 0.0, 1e-9);
    EXPECT_GT(length(meridian.polyline), 1.8 * std::numbers::pi * 0.3);
}

TEST_P(Topology, ClosedCurvesGoRoundACylinder) {
    const TriangleMesh mesh = openCylinder(24, 12);
    const std::vector<Vec3> picks =
        verticesOf(mesh, {5 * 24, 7 * 24 + 7, 4 * 24 + 13, 6 * 24 + 19});
    const Curve curve = goodCurve(designerOn(mesh), picks, {.closed = true});
    EXPECT_NEAR(turnsAboutZ(curve.polyline), 1.0, 1e-9);
}

TEST_P(Topology, PicksMayLieOnVerticesAndEdges) {
    const TriangleMesh mesh = withNoise(icosphere(3), 0.01, 31);
    const CurveDesigner designer = designerOn(mesh);
    const auto vertex = [&](int face, std::size_t k) {
        const Triangle& corners = mesh.faces[face];
        return mesh.vertices[corners[k]];
    };
    std::vector<Vec3> vertices;
    std::vector<Vec3> edges;
    for (const int face : {10, 300, 620, 900, 1200}) {
        vertices.push_back(vertex(face, 0));
        edges.emplace_back(0.3 * vertex(face, 1) + 0.7 * vertex(face, 2));
    }
    goodCurve(designer, vertices);
    goodCurve(designer, vertices, {.closed = true});
    goodCurve(designer, edges);
    goodCurve(designer, edges, {.closed = true});
}

TEST_P(Topology, CurvesMayRunAlongMeshEdges) {
    const CurveDesigner designer = designerOn(plate(10, 10));
    goodCurve(designer, {{0.1, 0.5, 0}, {0.4, 0.5, 0}, {0.9, 0.5, 0}});
    goodCurve(designer, {{0.15, 0.5, 0}, {0.4, 0.5, 0}, {0.83, 0.5, 0}});
    goodCurve(designer, {{0.1, 0.1, 0}, {0.5, 0.5, 0}, {0.9, 0.9, 0}});
}

TEST_P(Topology, TwoPicksMayLieInOneFace) {
    const CurveDesigner designer = designerOn(plate(4, 4));
    goodCurve(designer, {{0.3, 0.28, 0}, {0.35, 0.27, 0}});
    goodCurve(designer, {{0.3, 0.28, 0}, {0.35, 0.27, 0}, {0.35, 0.31, 0}}, {.closed = true});
    goodCurve(designer, {{0.1, 0.8, 0}, {0.3, 0.28, 0}, {0.35, 0.27, 0}, {0.9, 0.9, 0}});
}

TEST_P(Topology, PicksMayBeVeryClose) {
    const CurveDesigner designer = designerOn(plate(10, 10));
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-6}) {
        SCOPED_TRACE("gap " + std::to_string(gap));
        goodCurve(designer, {{0.1, 0.3, 0}, {0.5, 0.62, 0}, {0.5 + gap, 0.62, 0}, {0.9, 0.4, 0}});
    }
}

TEST_P(Topology, FortyPicksGiveOneChain) {
    Random random(41);
    std::vector<Vec3> wishes;
    const TriangleMesh mesh = icosphere(4);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.7 * i;
        const double z = -0.85 + 1.7 * i / 39.0 + random.uniform(-0.01, 0.01);
        const double r = std::sqrt(1.0 - z * z);
        wishes.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    goodCurve(designerOn(mesh), verticesNear(mesh.vertices, wishes));
}

INSTANTIATE_TEST_SUITE_P(Shells, Topology, kEitherShell, nameOfShell);

class EveryDegree : public testing::TestWithParam<std::tuple<ShellKind, int, bool>> {};

TEST_P(EveryDegree, GivesGoodCurves) {
    const auto [kind, degree, closed] = GetParam();
    const TriangleMesh mesh = withNoise(icosphere(3), 0.01, 37);
    const CurveDesigner designer = designerIn(kind, mesh);
    const std::vector<Vec3> picks = verticesOf(mesh, {5, 100, 222, 400});
    goodCurve(designer, picks, {.degree = degree, .closed = closed});
}

INSTANTIATE_TEST_SUITE_P(
    All, EveryDegree, testing::Combine(kEitherShell, testing::Values(2, 3, 4), testing::Bool())
);

TEST(PaperPreset, GivesUsableCurvesOnASphere) {
    const TriangleMesh mesh = icosphere(3);
    const CurveDesigner designer(mesh);
    for (const bool closed : {false, true}) {
        SolverOptions options = paperPreset();
        options.closed = closed;
        const Curve curve = designer.design(verticesOf(mesh, {5, 100, 400}), options);
        EXPECT_TRUE(curve.report.usable)
            << name(curve.report.status) << ", " << curve.report.maxDistance;
        expectStrict(designer.surface(), curve.polyline);
    }
}

// ---- On the boundary of an open surface ----

class Boundary : public EitherShell {
protected:
    CurveDesigner designer_ = designerOn(plate(12, 12));
};

TEST_P(Boundary, PicksNearItAreFine) {
    goodCurve(designer_, {{0.1, 0.01, 0}, {0.4, 0.02, 0}, {0.9, 0.005, 0}});
}

TEST_P(Boundary, CurvesMayStartAndEndOnIt) {
    goodCurve(designer_, {{0, 0.3, 0}, {0.4, 0.6, 0}, {1, 0.41, 0}});
    goodCurve(designer_, {{0, 0, 0}, {0.4, 0.6, 0}, {1, 1, 0}});
    goodCurve(designer_, {{0, 0.5, 0}, {1, 0.5, 0}});
}

TEST_P(Boundary, CurvesMayTouchItInTheMiddle) {
    goodCurve(designer_, {{0.2, 0.5, 0}, {0.51, 0, 0}, {0.8, 0.5, 0}});
}

TEST_P(Boundary, CurvesMayRunAlongIt) {
    goodCurve(designer_, {{0.1, 0, 0}, {0.47, 0, 0}, {0.93, 0, 0}});
}

TEST_P(Boundary, AllPicksMayLieOnIt) {
    goodCurve(designer_, {{0.3, 0, 0}, {1, 0.4, 0}, {0.6, 1, 0}, {0, 0.6, 0}});
    goodCurve(designer_, {{0.3, 0, 0}, {1, 0.4, 0}, {0.6, 1, 0}, {0, 0.6, 0}}, {.closed = true});
}

// The spline through these picks would swing out of the plate: it must come back.
TEST_P(Boundary, CurvesThatWouldSwingOutStayOnTheSurface) {
    goodCurve(
        designer_, {{0.05, 0.6, 0}, {0.2, 0.02, 0}, {0.5, 0.02, 0}, {0.8, 0.02, 0}, {0.95, 0.6, 0}}
    );
}

TEST_P(Boundary, CurvesFollowTheRimOfACylinder) {
    const TriangleMesh mesh = openCylinder(24, 8);
    const CurveDesigner cylinder = designerOn(mesh);
    const Curve curve = goodCurve(cylinder, verticesOf(mesh, {0, 6, 12, 18}), {.closed = true});
    EXPECT_NEAR(turnsAboutZ(curve.polyline), 1.0, 1e-9);
}

// A plate with a slot from below: the way between the two sides leads round its end.
TEST_P(Boundary, CurvesGoRoundNotches) {
    const CurveDesigner notched = designerOn(withoutFaces(plate(12, 12), [](const Vec3& p) {
        return p.y() < 0.6 && std::abs(p.x() - 0.5) < 0.09;
    }));
    goodCurve(notched, {{0.2, 0.1, 0}, {0.8, 0.1, 0}});
    goodCurve(notched, {{0.2, 0.1, 0}, {0.52, 0.8, 0}, {0.8, 0.1, 0}});
}

INSTANTIATE_TEST_SUITE_P(Shells, Boundary, kEitherShell, nameOfShell);

// ---- Over the rim of a lens thinner than its faces: what slips through it does not find back ----

TriangleMesh lens(double thickness) {
    TriangleMesh mesh = icosphere(4);
    for (Vec3& vertex : mesh.vertices) {
        vertex.z() *= thickness;
    }
    return mesh;
}

/// The vertices of the lens next to some (x, y), above (z > 0) or below.
std::vector<Vec3> picksOn(const TriangleMesh& mesh, std::vector<Vec3> places) {
    for (Vec3& place : places) {
        place = *std::ranges::min_element(mesh.vertices, {}, [&](const Vec3& v) {
            return v.z() * place.z() > 0.0 ? (v - place).head<2>().squaredNorm() : 10.0;
        });
    }
    return places;
}

class Lens : public testing::TestWithParam<double> {
protected:
    void expectCurveOverTheRim(const std::vector<Vec3>& places) const {
        // A curve that asks for knots without end has passed through the lens.
        constexpr std::size_t kManyControlPoints = 300;
        const TriangleMesh mesh = lens(GetParam());
        const CurveDesigner designer = designerIn(ShellKind::Local, mesh);
        const Curve curve = goodCurve(designer, picksOn(mesh, places));
        EXPECT_LT(curve.spline.controlPoints.size(), kManyControlPoints);
    }
};

TEST_P(Lens, IsCrossedOnceAndBack) {
    expectCurveOverTheRim({{0.5, 0.0, 1.0}, {0.6, 0.1, -1.0}, {-0.5, 0.3, 1.0}});
}

TEST_P(Lens, IsCrossedFromNearItsMiddle) {
    expectCurveOverTheRim({{0.1, 0.0, 1.0}, {0.1, 0.2, -1.0}});
}

TEST_P(Lens, IsCrossedAgainAndAgain) {
    expectCurveOverTheRim(
        {{0.7, 0.0, 1.0}, {0.7, 0.2, -1.0}, {0.6, 0.5, 1.0}, {0.3, 0.7, -1.0}, {0.0, 0.6, 1.0}}
    );
}

INSTANTIATE_TEST_SUITE_P(Thicknesses, Lens, testing::Values(0.05, 0.03, 0.025, 0.02));

TEST(LensProgress, OnlyRisesOverSeveralAttempts) {
    const TriangleMesh mesh = lens(0.025);
    const std::vector<Vec3> picks =
        picksOn(mesh, {{0.7, 0.0, 1.0}, {0.7, 0.2, -1.0}, {0.6, 0.5, 1.0}});
    double last = 0.0;
    const auto follow = [&](double fraction, const char*) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    };
    static_cast<void>(designerIn(ShellKind::Local, mesh).design(picks, {}, {}, {}, follow));
    EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace bspline_curve
