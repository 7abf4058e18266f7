// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that fills are made of: triangulations, crossings, retreats, values.
#include "bspline_curve/progress.h"
#include "fill/crossing_finder.h"
#include "fill/harmonic_values.h"
#include "fill/patch_fairing.h"
#include "fill/patch_refinement.h"
#include "fill/patch_retreat.h"
#include "fill/planar_triangulation.h"
#include "fill/rim_triangulation.h"
#include "fill/sheet_patch.h"
#include "support/meshes.h"
#include "support/seeds.h"
#include "surface/self_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

using namespace test_support;

double areaOf(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
    double area = 0.0;
    for (const auto& [a, b, c] : faces) {
        area += 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).norm();
    }
    return area;
}

/// A star with arms that bend round, in the plane z = 0.
std::vector<Vec3> spiralStar(int count) {
    std::vector<Vec3> star;
    for (int i = 0; i < count; ++i) {
        const double radius = i % 2 == 0 ? 1.0 : 0.35;
        const double angle = 2.0 * std::numbers::pi * i / count + 0.5 * radius;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return star;
}

double enclosedArea(const std::vector<Vec3>& polygon) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        area += 0.5 * polygon[i].cross(polygon[(i + 1) % polygon.size()]).z();
    }
    return area;
}

TEST(TriangulateSeen, CoversAPolygonOnce) {
    for (const int count : {4, 10, 40, 400}) {
        const std::vector<Vec3> star = spiralStar(count);
        const PlanarView view = planarView(star);
        EXPECT_NEAR(view.deviation, 0.0, 1e-15);
        const std::vector<Triangle> faces = triangulateSeen(star, view, {});
        ASSERT_EQ(std::ssize(faces), count - 2);
        EXPECT_NEAR(areaOf(star, faces), enclosedArea(star), 1e-12);
        EXPECT_TRUE(findSelfIntersections(star, faces).empty());
    }
}

TEST(TriangulateSeen, LeavesForbiddenChordsOut) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const PlanarView view = planarView(square);
    for (const auto& [chord, other] :
         {std::pair{std::array{0, 2}, std::array{1, 3}},
          std::pair{std::array{1, 3}, std::array{0, 2}}}) {
        const std::vector<Triangle> faces = triangulateSeen(square, view, {chord});
        ASSERT_EQ(faces.size(), 2U);
        for (const Triangle& face : faces) {
            EXPECT_TRUE(std::ranges::find(face, other[0]) != face.end());
            EXPECT_TRUE(std::ranges::find(face, other[1]) != face.end());
        }
    }
    EXPECT_TRUE(triangulateSeen(square, view, {{0, 2}, {1, 3}}).empty());
}

TEST(TriangulateRim, BendsLess) {
    // Two rectangles that meet in an edge, with points along the other sides: the bend is there
    // alone.
    std::vector<Vec3> bent;
    for (int i = 0; i <= 8; ++i) {
        bent.emplace_back(i, 0.0, i < 4 ? 0.0 : i - 4.0);
    }
    for (int i = 8; i >= 0; --i) {
        bent.emplace_back(i, 3.0, i < 4 ? 0.0 : i - 4.0);
    }
    const std::vector<Triangle> faces = triangulateRim(bent, {}, [] {});
    EXPECT_NEAR(areaOf(bent, faces), 3.0 * (4.0 + 4.0 * std::numbers::sqrt2), 1e-12);
}

TEST(TriangulateRim, AsksWhichTrianglesAreAllowed) {
    const std::vector<Vec3> star = spiralStar(12);
    const auto isAllowed = [](const Triangle& face) {
        return std::ranges::find(face, 3) == face.end() || std::ranges::find(face, 4) != face.end();
    };
    const std::vector<Triangle> faces = triangulateRim(star, {}, [] {}, kMostRimPoints, isAllowed);
    ASSERT_EQ(faces.size(), 10U);
    EXPECT_TRUE(std::ranges::all_of(faces, isAllowed));
    EXPECT_TRUE(triangulateRim(
                    star, {}, [] {}, kMostRimPoints, [](const Triangle&) { return false; }
    ).empty());
}

TEST(Retriangulated, ChangesARegionAlone) {
    const std::vector<Vec3> star = spiralStar(40);
    const std::vector<Triangle> before = triangulateRim(star, {}, [] {});
    const std::vector<int> region = grown(before, {5}, 2);
    ASSERT_GT(region.size(), 2U);
    ASSERT_LT(region.size(), before.size());
    const std::vector<Triangle> after =
        retriangulated(star, before, {}, region, [](const Triangle&) { return true; }, [] {});
    ASSERT_EQ(after.size(), before.size());
    EXPECT_NEAR(areaOf(star, after), areaOf(star, before), 1e-12);
    for (std::size_t f = 0; f < before.size(); ++f) {
        if (!std::ranges::binary_search(region, static_cast<int>(f))) {
            EXPECT_TRUE(std::ranges::find(after, before[f]) != after.end());
        }
    }
    const auto isAllowed = [](const Triangle&) { return false; };
    EXPECT_TRUE(retriangulated(star, before, {}, region, isAllowed, [] {}).empty());
}

TEST(TriangulateRim, CanBeEndedEarly) {
    const std::vector<Vec3> star = spiralStar(400);
    int calls = 0;
    const GoOn goOn = [&] {
        if (++calls == 100) {
            throw Cancelled();
        }
    };
    EXPECT_THROW(static_cast<void>(triangulateRim(star, {}, goOn)), Cancelled);
    EXPECT_EQ(calls, 100);
}

TEST(CrossingFinder, FindsWhatTheSearchOverAllPairsFinds) {
    forEachSeed(20, [](Random& random) {
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i) {
            points.emplace_back(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        }
        std::vector<Triangle> faces;
        for (int i = 0; i + 2 < 60; i += 2) {
            faces.push_back({i, i + 1, i + 2});
        }
        const std::vector<Triangle> kept(faces.begin(), faces.begin() + 15);
        const std::vector<Triangle> added(faces.begin() + 15, faces.end());
        const Crossings found = CrossingFinder(points, kept, false).crossingsOf(added);
        std::vector<int> withKept;
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < static_cast<int>(added.size()); ++i) {
            if (std::ranges::any_of(kept, [&](const Triangle& face) {
                    return trianglesIntersect(points, added[i], face);
                })) {
                withKept.push_back(i);
            }
            for (int j = i + 1; j < static_cast<int>(added.size()); ++j) {
                if (trianglesIntersect(points, added[i], added[j])) {
                    pairs.emplace_back(i, j);
                }
            }
        }
        EXPECT_EQ(found.withKept, withKept);
        EXPECT_EQ(found.pairs, pairs);
        EXPECT_EQ(found.isEmpty(), withKept.empty() && pairs.empty());
    });
}

TEST(CrossingFinder, FindsWhatIsFarFromWhereItLookedBefore) {
    TriangleMesh row = plate(60, 2);
    std::vector<Triangle> across;
    for (int i = 0; i < 20; ++i) {
        // Upright, through the middle of the plate.
        const double x = (i + 0.4) / 20.0;
        const auto first = static_cast<int>(row.vertices.size());
        row.vertices.insert(
            row.vertices.end(), {Vec3(x, 0.51, -0.01), Vec3(x, 0.52, 0.02), Vec3(x, 0.53, -0.01)}
        );
        across.push_back({first, first + 1, first + 2});
    }
    CrossingFinder finder(row.vertices, row.faces, false);
    for (const int i : {0, 19, 1, 18, 10, 3, 15, 7, 12, 5, 9, 0}) {
        EXPECT_EQ(finder.crossingsOf({across[i]}).withKept.size(), 1U) << i;
        EXPECT_TRUE(finder.crossesKept(across[i])) << i;
    }
}

TEST(CrossingFinder, TakesPointsThatRoundingJoinsAsOne) {
    // Two faces beside each other, with the edge between them twice.
    const std::vector<Vec3> points{
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}
    };
    const std::vector<Triangle> one{{0, 1, 2}};
    const std::vector<Triangle> other{{3, 5, 4}};
    EXPECT_FALSE(CrossingFinder(points, one, false).crossingsOf(other).isEmpty());
    EXPECT_TRUE(CrossingFinder(points, one, true).crossingsOf(other).isEmpty());
}

TEST(Retreated, GoesBackWhereFacesCrossAndNowhereElse) {
    const TriangleMesh grid = plate(10, 10);
    std::vector<Vec3> wanted = grid.vertices;
    for (Vec3& point : wanted) {
        point.z() = 1.0;
    }
    // A ceiling over one corner.
    const auto crossing = [&](const std::vector<Vec3>& points) {
        std::vector<int> faces;
        for (std::size_t f = 0; f < grid.faces.size(); ++f) {
            if (std::ranges::any_of(grid.faces[f], [&](int v) {
                    return points[v].x() < 0.15 && points[v].y() < 0.15 && points[v].z() > 0.3;
                })) {
                faces.push_back(static_cast<int>(f));
            }
        }
        return faces;
    };
    const std::vector<Vec3> points = retreated(grid.vertices, wanted, grid.faces, crossing);
    EXPECT_TRUE(crossing(points).empty());
    EXPECT_EQ(points.back().z(), 1.0);
    EXPECT_GT(points.front().z(), 0.05);
    // Where all crosses, the first positions come back.
    std::vector<int> all(grid.faces.size());
    for (std::size_t f = 0; f < all.size(); ++f) {
        all[f] = static_cast<int>(f);
    }
    EXPECT_EQ(
        retreated(grid.vertices, wanted, grid.faces, [&](const auto&) { return all; }),
        grid.vertices
    );
}

/// A disc of radius 1 in the plane z = 0: a point in the middle, two rings of it, the rim first.
Patch disc(int count) {
    Patch patch{
        .points = {}, .sizes = {}, .most = {}, .faces = {}, .rimCount = count, .forbidden = {}
    };
    for (const double radius : {1.0, 0.6}) {
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            patch.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        }
    }
    patch.points.emplace_back(Vec3::Zero());
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        patch.faces.push_back({i, next, count + i});
        patch.faces.push_back({next, count + next, count + i});
        patch.faces.push_back({count + i, count + next, 2 * count});
    }
    patch.sizes.assign(patch.points.size(), 0.3);
    patch.most = patch.sizes;
    return patch;
}

TEST(FairPatch, IsNotLedAwayBySlivers) {
    // A point hardly beside the middle of an edge between the rings.
    Patch patch = disc(12);
    const Triangle cut = patch.faces[2];
    const auto added = static_cast<int>(patch.points.size());
    const Vec3 middle = 0.5 * (patch.points[cut[0]] + patch.points[cut[1]]);
    patch.points.emplace_back(middle + 1e-10 * (patch.points[cut[2]] - middle));
    patch.sizes.push_back(0.3);
    patch.most.push_back(0.3);
    patch.faces[2] = {cut[0], cut[1], added};
    patch.faces.push_back({cut[1], cut[2], added});
    patch.faces.push_back({cut[2], cut[0], added});
    const std::vector<Vec3> before = patch.points;
    const auto rim = static_cast<std::size_t>(patch.rimCount);
    fairPatch(
        patch,
        {.laplacians = std::vector<Vec3>(rim, Vec3::Zero()),
         .normals = std::vector<Vec3>(rim, Vec3::UnitZ()),
         .isKnown = std::vector<char>(rim, 0)},
        3
    );
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LT((patch.points[i] - before[i]).norm(), 1e-3) << i;
    }
}

TEST(RefinePatch, EndsWithMoreFacesThanAsked) {
    Patch fine = disc(12);
    std::ranges::fill(fine.sizes, 0.02);
    fine.most = fine.sizes;
    Patch bounded = fine;
    refinePatch(fine, Relaxing::Tangential);
    refinePatch(bounded, Relaxing::Tangential, {}, 200);
    EXPECT_GT(bounded.faces.size(), 200U);
    EXPECT_LT(bounded.faces.size(), 800U);
    EXPECT_GT(fine.faces.size(), 10000U);
}

TEST(HarmonicFrom, IsLinearInAPlaneAndBetweenTheRimsValues) {
    // The rim first.
    const TriangleMesh grid = plate(6, 6);
    std::vector<int> order;
    for (const bool wanted : {true, false}) {
        for (std::size_t v = 0; v < grid.vertices.size(); ++v) {
            const Vec3& p = grid.vertices[v];
            const bool isOnRim = p.x() == 0.0 || p.x() == 1.0 || p.y() == 0.0 || p.y() == 1.0;
            if (isOnRim == wanted) {
                order.push_back(static_cast<int>(v));
            }
        }
    }
    std::vector<Vec3> points;
    std::vector<int> placeOf(order.size());
    for (const int vertex : order) {
        placeOf[vertex] = static_cast<int>(points.size());
        points.push_back(grid.vertices[vertex]);
    }
    std::vector<Triangle> faces = grid.faces;
    for (Triangle& face : faces) {
        for (int& corner : face) {
            corner = placeOf[corner];
        }
    }
    constexpr int kRim = 24;
    ValueRows rim(kRim, 2);
    for (int i = 0; i < kRim; ++i) {
        rim(i, 0) = 3.0 * points[i].x() - points[i].y();
        rim(i, 1) = points[i].x() == 0.0 ? 1.0 : 0.0;
    }
    const ValueRows values = harmonicFrom(points, faces, rim);
    ASSERT_EQ(values.rows(), std::ssize(points));
    for (int i = kRim; i < values.rows(); ++i) {
        EXPECT_NEAR(values(i, 0), 3.0 * points[i].x() - points[i].y(), 0.01);
        EXPECT_GT(values(i, 1), 0.0);
        EXPECT_LT(values(i, 1), 1.0);
    }
}

TEST(SheetBeside, CopiesADiscAndNothingElse) {
    TriangleMesh cap = icosphere(3);
    std::erase_if(cap.faces, [&](const Triangle& face) {
        return std::ranges::any_of(face, [&](int v) { return cap.vertices[v].z() < 0.3; });
    });
    std::vector<int> rim;
    {
        // Sides without another face, one after the other.
        std::vector<std::array<int, 2>> sides;
        for (const Triangle& face : cap.faces) {
            for (int k = 0; k < 3; ++k) {
                sides.push_back({face[k], face[(k + 1) % 3]});
            }
        }
        std::vector<int> next(cap.vertices.size(), -1);
        for (const auto& [from, to] : sides) {
            if (std::ranges::find(sides, std::array{to, from}) == sides.end()) {
                next[to] = from;
                rim.assign(1, to);
            }
        }
        for (int v = next[rim[0]]; v != rim[0]; v = next[v]) {
            rim.push_back(v);
        }
    }
    const std::optional<Patch> sheet = sheetBeside(cap, rim, true);
    ASSERT_TRUE(sheet);
    EXPECT_GE(sheet->faces.size(), cap.faces.size());
    EXPECT_NEAR(areaOf(sheet->points, sheet->faces), areaOf(cap.vertices, cap.faces), 1e-12);
    const std::vector<Vec3> ways = waysOff(*sheet);
    for (std::size_t i = 0; i < sheet->points.size(); ++i) {
        const bool isOnRim = sheet->isOnRim(static_cast<int>(i));
        EXPECT_EQ(ways[i].isZero(), isOnRim);
        EXPECT_TRUE(isOnRim || ways[i].normalized().dot(sheet->points[i]) < -0.9);  // turned over
    }
    EXPECT_TRUE(sheetBeside(cap, rim, true, cap.faces.size()));
    EXPECT_FALSE(sheetBeside(cap, rim, true, cap.faces.size() - 1));
    EXPECT_FALSE(sheetBeside(cap, rim, false));  // on that side there is nothing
    const TriangleMesh ring = openCylinder(12, 3);
    std::vector<int> lower(12);
    for (int i = 0; i < 12; ++i) {
        lower[i] = i;
    }
    EXPECT_FALSE(sheetBeside(ring, lower, true));
    EXPECT_FALSE(sheetBeside(ring, lower, false));
}

}  // namespace

}  // namespace bspline_curve
