// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/mended_designer.h"

#include "bspline_curve/error.h"
#include "design/curve_checks.h"
#include "design/curve_on_given_mesh.h"
#include "support/meshes.h"
#include "support/refusal.h"

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
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            position += weights[k] * mesh.vertices[mesh.faces[face][k]];
        }
        EXPECT_LT((position - line.points[i]).norm(), 1e-12);
        const std::vector<int> here = facesAt(mesh, line.surfacePoints[i]);
        std::vector<int> common;
        std::ranges::set_intersection(before, here, std::back_inserter(common));
        EXPECT_TRUE(i == 0 || !common.empty()) << "segment " << i - 1;
        before = here;
    }
}

TEST(MendedDesigner, PassesFromEachPageOfABookToEachOther) {
    const TriangleMesh mesh = book();
    const Mended<CurveDesigner> mended = makeMendedDesigner(mesh, {});
    ASSERT_NE(mended.repair(), nullptr);
    ASSERT_EQ(surfaceOf(mended.made).componentCount(), 2);
    const std::vector<std::vector<int>> tours = {{0, 1}, {0, 2}, {1, 2}, {0, 1, 2}, {0, 2, 0, 1}};
    for (const std::vector<int>& pages : tours) {
        std::vector<Vec3> picks;
        for (const int page : pages) {
            picks.push_back(onPage(page, 0.5, 0.2 + 0.15 * static_cast<double>(picks.size())));
        }
        Curve curve = mended.made.design(picks);
        EXPECT_TRUE(curve.report.usable);
        bringBack(curve, mended.repair());
        expectStrictOn(mesh, curve.polyline);
        ASSERT_EQ(curve.polyline.picks.size(), picks.size());
        for (std::size_t i = 0; i < picks.size(); ++i) {
            EXPECT_LT((curve.polyline.points[curve.polyline.picks[i]] - picks[i]).norm(), 1e-9);
        }
    }
}

TEST(MendedDesigner, CarriesFieldAndAvoidedFacesOver) {
    const TriangleMesh mesh = book();
    const Mended<CurveDesigner> mended = makeMendedDesigner(mesh, {});
    const TriangleMesh& made = mended.made.mesh();
    const std::vector<Vec3> picks = {onPage(0, 0.5, 0.5), onPage(1, 0.5, 0.5), onPage(2, 0.5, 0.5)};
    const auto farthestFrom = [](const Curve& curve, double height) {
        double farthest = 0.0;
        for (const Vec3& point : curve.polyline.points) {
            farthest = std::max(farthest, std::abs(point.z() - height));
        }
        return farthest;
    };
    constexpr double kCell = 1.0 / 6.0;  // passages are somewhere on an edge
    EXPECT_LT(farthestFrom(mended.made.design(picks), 0.5), kCell);
    const std::vector<double> field =
        sampled(made, [](const Vec3& p) { return 1.0 + 8.0 * std::abs(p.z() - 0.9); });
    EXPECT_GT(farthestFrom(mended.made.design(picks, {}, {}, {.field = field}), 0.5), 1.5 * kCell);
    // A block on the spine at the picks' height.
    std::vector<int> avoid;
    for (int f = 0; f < static_cast<int>(made.faces.size()); ++f) {
        const Vec3 middle = surfaceOf(mended.made).position({f, Vec3::Constant(1.0 / 3.0)});
        if (middle.head<2>().norm() < 0.2 && std::abs(middle.z() - 0.5) < 0.2) {
            avoid.push_back(f);
        }
    }
    ASSERT_FALSE(avoid.empty());
    Curve curve = mended.made.design(picks, {}, {}, {.avoid = avoid});
    for (const SurfacePoint& point : curve.polyline.surfacePoints) {
        EXPECT_FALSE(std::ranges::binary_search(avoid, point.face));
    }
    bringBack(curve, mended.repair());
    expectStrictOn(mesh, curve.polyline);
}

TEST(MendedDesigner, DrawsTheSameWhateverWasDrawnBefore) {
    const Mended<CurveDesigner> mended = makeMendedDesigner(book(), {});
    const std::vector<Vec3> low = {onPage(0, 0.5, 0.2), onPage(1, 0.5, 0.2), onPage(2, 0.5, 0.2)};
    const std::vector<Vec3> high = {onPage(0, 0.5, 0.8), onPage(1, 0.5, 0.8), onPage(2, 0.5, 0.8)};
    const Curve first = mended.made.design(low);
    static_cast<void>(mended.made.design(high));
    expectSameBits(mended.made.design(low), first);
    expectSameBits(mended.made.design(low), first);
}

// Down to edges so short that a part of them makes no face any more: these picks are refused.
TEST(MendedDesigner, DividesEdgesOfAnyLengthOrRefusesThePicks) {
    int drawn = 0;
    int refused = 0;
    for (int digits = 4; digits < 50; ++digits) {
        TriangleMesh mesh = threeFacesAtAnEdge();
        mesh.vertices[1].z() = std::ldexp(1.0, -digits);  // the edge is from the origin to there
        if (repairMesh(mesh).mesh.faces.size() < mesh.faces.size()) {
            break;  // the faces themselves have no area
        }
        const Mended<CurveDesigner> mended = makeMendedDesigner(mesh, {});
        ASSERT_EQ(surfaceOf(mended.made).componentCount(), 2);
        for (const auto& [a, b] : {std::pair(2, 3), std::pair(2, 4), std::pair(3, 4)}) {
            const std::optional<InputError> error = refusal([&] {
                return mended.made.design({0.8 * mesh.vertices[a], 0.8 * mesh.vertices[b]});
            });
            ++(error ? refused : drawn);
            EXPECT_TRUE(!error || error->code() == InputErrorCode::PicksOnDifferentComponents);
        }
    }
    EXPECT_GT(drawn, 60);
    EXPECT_GT(refused, 0);
    EXPECT_LT(refused, drawn / 4);
}

TEST(MendedDesigner, RefusesPicksOnPartsThatNoEdgeJoins) {
    TriangleMesh far = plate(4, 4);
    for (Vec3& vertex : far.vertices) {
        vertex += Vec3(3.0, 0.0, 0.0);
    }
    const Mended<CurveDesigner> mended = makeMendedDesigner(joined(book(), far), {});
    const std::optional<InputError> error = refusal([&] {
        return mended.made.design({onPage(0, 0.5, 0.5), onPage(2, 0.5, 0.5), {3.5, 0.5, 0.0}});
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), InputErrorCode::PicksOnDifferentComponents);
    EXPECT_THROW(
        static_cast<void>(mended.made.design(
            {onPage(0, 0.5, 0.5), onPage(2, 0.5, 0.5)},
            {},
            {},
            {},
            [](double, const char*) { return false; }
        )),
        Cancelled
    );
}

}  // namespace
}  // namespace bspline_curve
