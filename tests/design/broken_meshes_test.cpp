// SPDX-License-Identifier: GPL-3.0-or-later
// Curves on meshes that are mended for them.
#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "design/curve_checks.h"
#include "design/detours.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "surface/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Three plates that meet in the z axis as the pages of a book, 120 degrees apart.
TriangleMesh book() {
    TriangleMesh mesh;
    for (int page = 0; page < 3; ++page) {
        const double angle = 2.0 * M_PI / 3.0 * page;
        TriangleMesh leaf = plate(6, 6);
        for (Vec3& vertex : leaf.vertices) {
            const double radius = vertex.x();
            vertex = {radius * std::cos(angle), radius * std::sin(angle), vertex.y()};
        }
        mesh = joined(mesh, leaf);
    }
    // The spine's vertices are those of the first page.
    const int each = static_cast<int>(mesh.vertices.size()) / 3;
    for (Triangle& face : mesh.faces) {
        for (int& v : face) {
            if (v >= each && mesh.vertices[v].head<2>().norm() < 1e-9) {
                v %= each;
            }
        }
    }
    return mesh;
}

Vec3 onPage(int page, double radius, double height) {
    const double angle = 2.0 * M_PI / 3.0 * page;
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

/// The faces of the mesh that hold a point of one of them.
std::vector<int> facesAt(const TriangleMesh& mesh, const SurfacePoint& point) {
    std::vector<int> faces;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        const Triangle& corners = mesh.faces[f];
        bool holds = true;
        for (int k = 0; k < 3; ++k) {
            holds = holds && (point.barycentric[k] < 1e-12 ||
                              std::ranges::count(corners, mesh.faces[point.face][k]) == 1);
        }
        if (holds) {
            faces.push_back(f);
        }
    }
    return faces;
}

/// Expects a polyline of the given mesh, each segment in one of its faces.
void expectStrictOn(const TriangleMesh& mesh, const SurfacePolyline& line) {
    std::vector<int> before;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const auto& [face, weights] = line.surfacePoints[i];
        EXPECT_LT((positionOf(mesh, {face, weights}) - line.points[i]).norm(), 1e-12);
        const std::vector<int> here = facesAt(mesh, line.surfacePoints[i]);
        std::vector<int> common;
        std::ranges::set_intersection(before, here, std::back_inserter(common));
        EXPECT_TRUE(i == 0 || !common.empty()) << "segment " << i - 1;
        before = here;
    }
}

TEST(BrokenMeshes, PassesFromEachPageOfABookToEachOther) {
    const TriangleMesh mesh = book();
    const CurveDesigner designer(mesh);
    ASSERT_EQ(designer.surface().componentCount(), 2);
    const std::vector<std::vector<int>> tours = {{0, 1}, {0, 2}, {1, 2}, {0, 1, 2}, {0, 2, 0, 1}};
    for (const std::vector<int>& pages : tours) {
        std::vector<Vec3> picks;
        for (const int page : pages) {
            picks.push_back(onPage(page, 0.5, 0.2 + 0.15 * static_cast<double>(picks.size())));
        }
        const Curve curve = designer.design(picks);
        EXPECT_TRUE(curve.report.usable);
        expectStrictOn(mesh, curve.polyline);
        ASSERT_EQ(curve.polyline.picks.size(), picks.size());
        for (std::size_t i = 0; i < picks.size(); ++i) {
            EXPECT_LT((curve.polyline.points[curve.polyline.picks[i]] - picks[i]).norm(), 1e-9);
        }
    }
}

TEST(BrokenMeshes, CarriesFieldAndAvoidedFacesOver) {
    const TriangleMesh mesh = book();
    const CurveDesigner designer(mesh);
    const std::vector<Vec3> picks = {onPage(0, 0.5, 0.5), onPage(1, 0.5, 0.5), onPage(2, 0.5, 0.5)};
    const auto farthestFrom = [](const Curve& curve, double height) {
        double farthest = 0.0;
        for (const Vec3& point : curve.polyline.points) {
            farthest = std::max(farthest, std::abs(point.z() - height));
        }
        return farthest;
    };
    constexpr double kCell = 1.0 / 6.0;  // passages are somewhere on an edge
    EXPECT_LT(farthestFrom(designer.design(picks), 0.5), kCell);
    const std::vector<double> field =
        sampled(mesh, [](const Vec3& p) { return 1.0 + 8.0 * std::abs(p.z() - 0.9); });
    EXPECT_GT(farthestFrom(designer.design(picks, {}, {}, {.field = field}), 0.5), 1.5 * kCell);
    // A block on the spine at the picks' height.
    std::vector<int> avoid;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        const Vec3 middle = positionOf(mesh, {f, Vec3::Constant(1.0 / 3.0)});
        if (middle.head<2>().norm() < 0.2 && std::abs(middle.z() - 0.5) < 0.2) {
            avoid.push_back(f);
        }
    }
    ASSERT_FALSE(avoid.empty());
    const Curve curve = designer.design(picks, {}, {}, {.avoid = avoid});
    for (const SurfacePoint& point : curve.polyline.surfacePoints) {
        EXPECT_FALSE(std::ranges::binary_search(avoid, point.face));
    }
    expectStrictOn(mesh, curve.polyline);
}

TEST(BrokenMeshes, DrawsTheSameWhateverWasDrawnBefore) {
    const CurveDesigner designer(book());
    const std::vector<Vec3> low = {onPage(0, 0.5, 0.2), onPage(1, 0.5, 0.2), onPage(2, 0.5, 0.2)};
    const std::vector<Vec3> high = {onPage(0, 0.5, 0.8), onPage(1, 0.5, 0.8), onPage(2, 0.5, 0.8)};
    const Curve first = designer.design(low);
    static_cast<void>(designer.design(high));
    expectSameBits(designer.design(low), first);
    expectSameBits(designer.design(low), first);
}

// Down to edges so short that a part of them makes no face any more.
TEST(BrokenMeshes, PassesEdgesOfAnyLength) {
    for (int digits = 4; digits < 50; ++digits) {
        TriangleMesh mesh = threeFacesAtAnEdge();
        mesh.vertices[1].z() = std::ldexp(1.0, -digits);  // the edge is from the origin to there
        if (repairMesh(mesh).mesh.faces.size() < mesh.faces.size()) {
            break;  // the faces themselves have no area
        }
        const CurveDesigner designer(mesh);
        ASSERT_EQ(designer.surface().componentCount(), 2);
        for (const auto& [a, b] : {std::pair(2, 3), std::pair(2, 4), std::pair(3, 4)}) {
            const Curve curve = designer.design({0.8 * mesh.vertices[a], 0.8 * mesh.vertices[b]});
            EXPECT_LT(length(curve.polyline), 2.3) << digits;
        }
    }
}

/// The length of a curve relative to the sum of straight lines from each pick to the next, over the
/// middles that are given.
double relativeLength(const Curve& curve, const std::vector<Vec3>& corners) {
    double least = 0.0;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        least += (corners[i + 1] - corners[i]).norm();
    }
    return length(curve.polyline) / least;
}

Vec3 middleOf(const TriangleMesh& mesh, int face) {
    const Triangle& corners = mesh.faces[face];
    return (mesh.vertices[corners[0]] + mesh.vertices[corners[1]] + mesh.vertices[corners[2]]) /
           3.0;
}

// Around a tetrahedron's vertex inside of it, every edge has three faces, and the ends of each are
// held together by the faces around them.
TEST(BrokenMeshes, PassesBetweenAnyTwoFacesOfAnEdge) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0.4, 0.4, 0.4}};
    for (int a = 0; a < 5; ++a) {
        for (int b = a + 1; b < 5; ++b) {
            for (int c = b + 1; c < 5; ++c) {
                mesh.faces.push_back({a, b, c});
            }
        }
    }
    const CurveDesigner designer(mesh);
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        for (int g = f + 1; g < static_cast<int>(mesh.faces.size()); ++g) {
            std::vector<int> common;
            std::ranges::set_intersection(mesh.faces[f], mesh.faces[g], std::back_inserter(common));
            if (common.size() == 2) {
                const Vec3 over = 0.5 * (mesh.vertices[common[0]] + mesh.vertices[common[1]]);
                const std::vector<Vec3> corners = {middleOf(mesh, f), over, middleOf(mesh, g)};
                const Curve curve = designer.design({corners.front(), corners.back()});
                expectStrictOn(mesh, curve.polyline);
                EXPECT_LT(relativeLength(curve, corners), kNotedDetour) << f << " " << g;
            }
        }
    }
}

TEST(BrokenMeshes, PassesTheCutOfAOneSidedSurface) {
    const TriangleMesh mesh = moebiusStrip(24);
    const CurveDesigner designer(mesh);
    const auto count = static_cast<int>(mesh.faces.size());
    std::vector<Vec3> round;
    for (int f = 0; f < count; f += 2) {
        const std::vector<Vec3> corners = {middleOf(mesh, f), middleOf(mesh, (f + 4) % count)};
        const Curve curve = designer.design(corners);
        EXPECT_LT(relativeLength(curve, corners), 1.2) << f;
        EXPECT_TRUE(curve.report.detours.empty());
        if (f % 8 == 0) {
            round.push_back(corners.front());
        }
    }
    // All round it there is no curve with one side; the note says so.
    const Curve curve = designer.design(round, {.closed = true});
    ASSERT_EQ(curve.report.detours.size(), 1U);
    EXPECT_GT(curve.report.detours[0].ratio, 2.0);
    EXPECT_EQ(curve.report.detours[0].round, Detour::Round::Cut);
}

TEST(BrokenMeshes, ReportsWhereACurveGoesRoundASlit) {
    // Two halves of a plate that are joined in the upper half of the line between them only.
    TriangleMesh mesh = joined(plate(4, 8, 0.5, 1.0), plate(4, 8, 0.5, 1.0));
    const int half = static_cast<int>(mesh.vertices.size()) / 2;
    for (int v = half; v < 2 * half; ++v) {
        mesh.vertices[v].x() += 0.5;
    }
    for (Triangle& face : mesh.faces) {
        for (int& v : face) {
            if (v >= half && mesh.vertices[v].x() == 0.5 && mesh.vertices[v].y() > 0.5) {
                v += 4 - half;  // the last vertex of the row in the first half
            }
        }
    }
    const std::vector<Vec3> picks = {{0.4, 0.1, 0.0}, {0.6, 0.1, 0.0}, {0.7, 0.9, 0.0}};
    EXPECT_LT(relativeLength(CurveDesigner(mesh).design(picks), picks), 1.2);
    for (const MendingOptions& options : {MendingOptions{.strict = true}, {.slits = true}}) {
        const Curve curve = CurveDesigner(mesh, {}, options).design(picks);
        ASSERT_EQ(curve.report.detours.size(), 1U);
        EXPECT_EQ(curve.report.detours[0].from, 0);
        EXPECT_GT(curve.report.detours[0].ratio, 3.0);
        EXPECT_EQ(curve.report.detours[0].round, Detour::Round::Slit);
    }
}

TEST(BrokenMeshes, RefusesPicksOnPartsThatNoEdgeJoins) {
    TriangleMesh far = plate(4, 4);
    for (Vec3& vertex : far.vertices) {
        vertex += Vec3(3.0, 0.0, 0.0);
    }
    const CurveDesigner designer(joined(book(), far));
    const std::optional<InputError> error = refusal([&] {
        return designer.design({onPage(0, 0.5, 0.5), onPage(2, 0.5, 0.5), {3.5, 0.5, 0.0}});
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), InputErrorCode::PicksOnDifferentComponents);
    EXPECT_THROW(
        static_cast<void>(designer.design(
            {onPage(0, 0.5, 0.5), onPage(2, 0.5, 0.5)},
            {},
            {},
            {},
            [](double, const char*) { return false; }
        )),
        Cancelled
    );
}

// A noisy sphere whose first face is there three times, so that all others have other numbers once
// it is mended; and a curve that is far from it, with few long spans.
TEST(BrokenMeshes, AreKnownByTheirOwnFacesInReports) {
    const TriangleMesh sound = withNoise(icosphere(3), 0.12, 7);
    TriangleMesh mesh = sound;
    mesh.faces.insert(mesh.faces.begin(), 2, mesh.faces.front());
    const std::vector<Vec3> picks = {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400]};
    const SolverOptions options{.maxRounds = 1, .minimumSpan = 0.1};
    const Curve curve = CurveDesigner(mesh).design(picks, options);
    const Curve reference = CurveDesigner(sound).design(picks, options);
    ASSERT_TRUE(curve.report.farPart && reference.report.farPart);
    const std::vector<int>& faces = curve.report.farPart->faces;
    ASSERT_EQ(faces.size(), reference.report.farPart->faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        EXPECT_EQ(mesh.faces[faces[i]], sound.faces[reference.report.farPart->faces[i]]);
    }
    expectStrictOn(mesh, curve.polyline);
}

// A start has the faces of the mesh as well.
TEST(BrokenMeshes, LetADraggedCurveStartFromTheLast) {
    const TriangleMesh sound = withNoise(icosphere(4), 0.002, 5);
    TriangleMesh mesh = sound;
    mesh.faces.insert(mesh.faces.begin(), 2, mesh.faces.front());
    const auto dragged = [](const TriangleMesh& on) {
        const CurveDesigner designer(on);
        std::vector<Vec3> picks = {on.vertices[5], on.vertices[100], on.vertices[400]};
        const Curve first = designer.design(picks);
        picks[1] += Vec3(0.01, 0.01, 0.01);
        return designer.design(picks, {}, {}, {.start = &first});
    };
    const Curve curve = dragged(mesh);
    const Curve reference = dragged(sound);
    EXPECT_EQ(curve.polyline.points, reference.polyline.points);
    EXPECT_EQ(curve.report.newtonIterations, reference.report.newtonIterations);
    expectStrictOn(mesh, curve.polyline);
}

}  // namespace
}  // namespace bspline_curve
