// SPDX-License-Identifier: GPL-3.0-or-later
// Curves where fibres are of no use: through other sheets, over folds, round the rims of the
// thinnest plates, past vertices that no direction sees. There is always one.
#include "curve_checks.h"
#include "support/random.h"
#include "surface/strict_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

// A polyline on the surface through the picks, whatever the spline is like.
Curve strictCurve(
    const CurveDesigner& designer, const std::vector<Vec3>& picks, const SolverOptions& options = {}
) {
    Curve curve = designer.design(picks, options);
    EXPECT_TRUE(isStrict(designer.surface(), curve.polyline));
    EXPECT_EQ(curve.polyline.picks.size(), picks.size());
    for (std::size_t i = 0; i < curve.polyline.picks.size(); ++i) {
        const Vec3 gap = curve.polyline.points[curve.polyline.picks[i]] - picks[i];
        EXPECT_LE(gap.norm(), 1e-9 * designer.surface().diagonal()) << "pick " << i;
    }
    return curve;
}

class OtherSheets : public EitherShell {};

TEST_P(OtherSheets, CurvesPassThroughThemAndStartInThem) {
    const CurveDesigner designer = designerOn(crossingPlates());
    for (const std::vector<Vec3>& picks : std::vector<std::vector<Vec3>>{
             {{0.5, 0.1, 0}, {0.5, 0.9, 0}},
             {{0.3, 0.1, 0}, {0.5, 0.55, 0}},
             {{0.1, 0.1, 0}, {0.5, 0.3, 0}, {0.9, 0.1, 0}}
         }) {
        const Curve curve = goodCurve(designer, picks);
        EXPECT_TRUE(std::ranges::all_of(curve.polyline.points, [](const Vec3& p) {
            return p.z() == 0.0;
        }));
    }
}

INSTANTIATE_TEST_SUITE_P(Shells, OtherSheets, kEitherShell, nameOfShell);

// ---- Plates: over the rim, never through ----

class ThinPlates : public testing::TestWithParam<double> {};

TEST_P(ThinPlates, CurvesGoOverTheRim) {
    const double thickness = GetParam();
    const CurveDesigner designer(box(20, {1.0, 1.0, thickness}));
    const std::vector<Vec3> picks = {
        {0.5, 0.5, thickness}, {0.8, 0.52, thickness}, {0.8, 0.55, 0.0}, {0.5, 0.57, 0.0}
    };
    const Curve curve = strictCurve(designer, picks);
    const std::vector<Vec3>& points = curve.polyline.points;
    EXPECT_TRUE(
        std::any_of(
            points.begin() + curve.polyline.picks[1],
            points.begin() + curve.polyline.picks[2],
            [](const Vec3& p) { return std::abs(p.x() - 1.0) < 1e-9; }
        )
    );
}

INSTANTIATE_TEST_SUITE_P(
    Thicknesses, ThinPlates, testing::Values(1e-3, 1e-4, 1e-5, 3e-6, 1e-6, 1e-7, 1e-8, 1e-9)
);

// ---- Fans and folds ----

// A vertex with many faces round it, in a ring of faces.
TriangleMesh fan(int valence, double roughness, std::uint64_t seed) {
    Random random(seed);
    TriangleMesh mesh;
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    for (int ring = 1; ring <= 2; ++ring) {
        for (int i = 0; i < valence; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / valence;
            const double z = ring == 1 ? random.uniform(-roughness, roughness) - 1.0 : -1.5;
            mesh.vertices.emplace_back(ring * std::cos(angle), ring * std::sin(angle), z);
        }
    }
    for (int i = 0; i < valence; ++i) {
        const int next = (i + 1) % valence;
        const int inner = 1 + i;
        const int outer = 1 + valence + i;
        mesh.faces.push_back({0, inner, 1 + next});
        mesh.faces.push_back({inner, outer, 1 + valence + next});
        mesh.faces.push_back({inner, 1 + valence + next, 1 + next});
    }
    return mesh;
}

TEST(Fans, AreCrossedWhateverTheirValence) {
    for (const int valence : {30, 300, 1000}) {
        for (const double roughness : {0.0, 0.5}) {
            SCOPED_TRACE(std::to_string(valence) + " " + std::to_string(roughness));
            const TriangleMesh mesh = fan(valence, roughness, 5);
            std::vector<Vec3> picks;
            for (const double share : {0.1, 0.35, 0.75}) {
                const Triangle& face = mesh.faces[3 * static_cast<int>(share * valence)];
                picks.emplace_back(
                    0.3 * mesh.vertices[face[0]] + 0.3 * mesh.vertices[face[1]] +
                    0.4 * mesh.vertices[face[2]]
                );
            }
            const Curve curve = strictCurve(CurveDesigner(mesh), picks);
            EXPECT_TRUE(curve.report.usable || roughness > 0.0);
        }
    }
}

// So noisy that neighbours fold onto each other and through their next ones.
TriangleMesh crumpledSphere(std::uint64_t seed) {
    return withNoise(icosphere(3), 0.12, seed);
}

std::vector<Vec3> farPicks(const TriangleMesh& sphere) {
    return {sphere.vertices[5], sphere.vertices[100], sphere.vertices[400], sphere.vertices[600]};
}

TEST(CrumpledSpheres, HaveCurves) {
    for (const std::uint64_t seed : {7, 8, 9, 10}) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = crumpledSphere(seed);
        const CurveDesigner designer(mesh);
        for (const bool closed : {false, true}) {
            const Curve curve = strictCurve(designer, farPicks(mesh), {.closed = closed});
            EXPECT_TRUE(curve.report.usable);
            EXPECT_FALSE(curve.report.farPart.has_value());
        }
    }
}

// Feet of a tight fit jump between folds, but the fit is near to its path.
TEST(CrumpledSpheres, HaveTightFitsAlongPaths) {
    int tight = 0;
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = crumpledSphere(seed);
        const Curve curve = strictCurve(CurveDesigner(mesh), farPicks(mesh));
        EXPECT_TRUE(curve.report.usable);
        tight += curve.report.status == SolveStatus::TightFit ? 1 : 0;
    }
    EXPECT_GT(tight, 0);
}

// Deep folds beside each other, over which the path is many times as long as the chords.
TriangleMesh accordion(int folds) {
    constexpr int kSteps = 12, kRows = 8;
    TriangleMesh mesh = jitteredPlate(2 * folds * kSteps, kRows, 0.0, 1);
    for (Vec3& vertex : mesh.vertices) {
        const double phase = vertex[0] * folds;
        vertex[2] = std::abs(phase - std::round(phase));
    }
    return mesh;
}

TEST(Accordions, HaveClosedCurves) {
    const TriangleMesh mesh = accordion(16);
    const std::vector<Vec3>& v = mesh.vertices;
    const auto at = [&](double share) {
        return v[static_cast<std::size_t>(share * static_cast<double>(v.size()))];
    };
    const Curve curve = strictCurve(
        CurveDesigner(mesh),
        {at(0.13), at(0.31), at(0.58), at(0.87)},
        {.closed = true, .minimumSpan = 5e-4}
    );
    EXPECT_TRUE(curve.report.usable);
}

// With few long spans.
TEST(CrumpledSpheres, SayWhereCurvesAreFar) {
    const TriangleMesh mesh = crumpledSphere(7);
    const SolveReport report =
        strictCurve(CurveDesigner(mesh), farPicks(mesh), {.maxRounds = 1, .minimumSpan = 0.1})
            .report;
    ASSERT_FALSE(report.usable);
    ASSERT_TRUE(report.farPart.has_value());
    EXPECT_LT(report.farPart->from, report.farPart->to);
    EXPECT_FALSE(report.farPart->faces.empty());
    EXPECT_GE(report.maxDistance, report.allowedDistance);
}

// Picks where the surface crosses itself, which no shell holds, and a tolerance that no spline with
// spans so long meets.
TEST(ShortestPaths, AreWhatIsLeft) {
    const TriangleMesh mesh = withNoise(crossingPlates(), 0.04, 3);
    const auto middle = [&](int f) -> Vec3 {
        const Triangle& face = mesh.faces[f];
        return (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
    };
    constexpr int kFirstOfRow = 16;  // of the row that the upright plate crosses
    const Curve curve = strictCurve(
        CurveDesigner(mesh),
        {middle(kFirstOfRow), middle(kFirstOfRow + 7)},
        {.distanceTolerance = 1e-4, .maxRounds = 1, .maxIterations = 1, .minimumSpan = 0.1}
    );
    EXPECT_EQ(curve.report.status, SolveStatus::ShortestPath);
    EXPECT_FALSE(curve.report.usable);
    EXPECT_TRUE(curve.report.farPart.has_value());
}

}  // namespace
}  // namespace bspline_curve
