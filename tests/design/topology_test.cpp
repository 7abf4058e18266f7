// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that cross themselves, run over sharp edges, round handles, through many or crowded picks:
// always one chain.
#include "curve_checks.h"
#include "either_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>

namespace bspline_curve {
namespace {

using namespace test_support;

const std::vector<Vec3> kEight = {{0.2, 0.2, 0}, {0.8, 0.8, 0}, {0.8, 0.2, 0}, {0.2, 0.8, 0}};

class Topology : public EitherShell {};

TEST_P(Topology, CurvesMayCrossThemselves) {
    const CurveDesigner designer = designerOn(plate(20, 20));
    static_cast<void>(goodCurve(designer, kEight));
    const Curve closed = goodCurve(designer, kEight, closedOptions());
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
    static_cast<void>(goodCurve(designer, picks));
}

TEST_P(Topology, CurvesRunOverSharpEdgesAndCorners) {
    const CurveDesigner designer = designerOn(box(8));
    static_cast<void>(goodCurve(designer, {{0.5, 0.3, 1}, {1, 0.6, 0.5}}));
    static_cast<void>(goodCurve(designer, {{0.5, 0.3, 1}, {0.7, 0.8, 1}, {1, 0.6, 0.3}}));
    // Over the corner (1, 1, 1), and round the whole box.
    static_cast<void>(goodCurve(designer, {{0.9, 0.85, 1}, {1, 0.9, 0.9}, {0.8, 1, 0.85}}));
    const Curve round = goodCurve(
        designer, {{0.5, 0, 0.45}, {1, 0.5, 0.55}, {0.5, 1, 0.5}, {0, 0.5, 0.5}}, closedOptions()
    );
    EXPECT_NEAR(turnsAboutZ(round.polyline, Vec3(0.5, 0.5, 0)), 1.0, 1e-9);
}

TEST_P(Topology, CurvesRunAlongSharpEdges) {
    const CurveDesigner designer = designerOn(box(8));
    static_cast<void>(goodCurve(designer, {{0.1, 0.98, 1}, {0.5, 1, 0.97}, {0.9, 0.99, 1}}));
    static_cast<void>(goodCurve(designer, {{0.1, 1, 1}, {0.52, 1, 1}, {0.9, 1, 1}}));
}

Vec3 onTorusMesh(int majorSegments, int minorSegments, int i, int j) {
    const TriangleMesh mesh = torus(majorSegments, minorSegments);
    const int index = (j % minorSegments) * majorSegments + i % majorSegments;
    return mesh.vertices[index];
}

TEST_P(Topology, ClosedCurvesGoRoundAHandleEitherWay) {
    const CurveDesigner designer = designerOn(torus(40, 16));
    std::vector<Vec3> longWay;
    for (const int i : {0, 9, 21, 30}) {
        longWay.push_back(onTorusMesh(40, 16, i, i % 5));
    }
    const Curve around = goodCurve(designer, longWay, closedOptions());
    EXPECT_NEAR(turnsAboutZ(around.polyline), 1.0, 1e-9);

    std::vector<Vec3> tube;
    for (const int j : {0, 4, 7, 12}) {
        tube.push_back(onTorusMesh(40, 16, 3 + j % 3, j));
    }
    const Curve meridian = goodCurve(designer, tube, closedOptions());
    EXPECT_NEAR(turnsAboutZ(meridian.polyline), 0.0, 1e-9);
    EXPECT_GT(length(meridian.polyline), 1.8 * std::numbers::pi * 0.3);
}

TEST_P(Topology, ClosedCurvesGoRoundACylinder) {
    const CurveDesigner designer = designerOn(openCylinder(24, 12));
    const TriangleMesh mesh = openCylinder(24, 12);
    std::vector<Vec3> picks;
    for (const auto& [i, j] : {std::pair{0, 5}, {7, 7}, {13, 4}, {19, 6}}) {
        picks.push_back(mesh.vertices[j * 24 + i]);
    }
    const Curve curve = goodCurve(designer, picks, closedOptions());
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
    static_cast<void>(goodCurve(designer, vertices));
    static_cast<void>(goodCurve(designer, vertices, closedOptions()));
    static_cast<void>(goodCurve(designer, edges));
    static_cast<void>(goodCurve(designer, edges, closedOptions()));
}

TEST_P(Topology, CurvesMayRunAlongMeshEdges) {
    const CurveDesigner designer = designerOn(plate(10, 10));
    static_cast<void>(goodCurve(designer, {{0.1, 0.5, 0}, {0.4, 0.5, 0}, {0.9, 0.5, 0}}));
    static_cast<void>(goodCurve(designer, {{0.15, 0.5, 0}, {0.4, 0.5, 0}, {0.83, 0.5, 0}}));
    static_cast<void>(goodCurve(designer, {{0.1, 0.1, 0}, {0.5, 0.5, 0}, {0.9, 0.9, 0}}));
}

TEST_P(Topology, TwoPicksMayLieInOneFace) {
    const CurveDesigner designer = designerOn(plate(4, 4));
    static_cast<void>(goodCurve(designer, {{0.3, 0.28, 0}, {0.35, 0.27, 0}}));
    static_cast<void>(
        goodCurve(designer, {{0.3, 0.28, 0}, {0.35, 0.27, 0}, {0.35, 0.31, 0}}, closedOptions())
    );
    static_cast<void>(
        goodCurve(designer, {{0.1, 0.8, 0}, {0.3, 0.28, 0}, {0.35, 0.27, 0}, {0.9, 0.9, 0}})
    );
}

TEST_P(Topology, PicksMayBeVeryClose) {
    const CurveDesigner designer = designerOn(plate(10, 10));
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-6}) {
        SCOPED_TRACE("gap " + std::to_string(gap));
        static_cast<void>(goodCurve(
            designer, {{0.1, 0.3, 0}, {0.5, 0.62, 0}, {0.5 + gap, 0.62, 0}, {0.9, 0.4, 0}}
        ));
    }
}

TEST_P(Topology, FortyPicksGiveOneChain) {
    Random random(41);
    std::vector<Vec3> picks;
    const TriangleMesh mesh = icosphere(4);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.7 * i;
        const double z = -0.85 + 1.7 * i / 39.0 + random.uniform(-0.01, 0.01);
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 wish(r * std::cos(angle), r * std::sin(angle), z);
        picks.push_back(*std::ranges::min_element(mesh.vertices, {}, [&](const Vec3& v) {
            return (v - wish).squaredNorm();
        }));
    }
    const CurveDesigner designer = designerOn(mesh);
    static_cast<void>(goodCurve(designer, picks));
}

INSTANTIATE_TEST_SUITE_P(Shells, Topology, kEitherShell, nameOfShell);

class EveryDegree : public testing::TestWithParam<std::tuple<ShellKind, int>> {};

TEST_P(EveryDegree, GivesGoodCurves) {
    const TriangleMesh mesh = withNoise(icosphere(3), 0.01, 37);
    const CurveDesigner designer = designerIn(std::get<0>(GetParam()), mesh);
    std::vector<Vec3> picks;
    for (const std::size_t v : {5U, 100U, 222U, 400U}) {
        picks.push_back(mesh.vertices[v]);
    }
    SolverOptions options;
    options.degree = std::get<1>(GetParam());
    static_cast<void>(goodCurve(designer, picks, options));
    options.closed = true;
    static_cast<void>(goodCurve(designer, picks, options));
}

INSTANTIATE_TEST_SUITE_P(
    All, EveryDegree, testing::Combine(kEitherShell, testing::Values(2, 3, 4))
);

}  // namespace
}  // namespace bspline_curve
