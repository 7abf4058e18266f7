// SPDX-License-Identifier: GPL-3.0-or-later
// Imprints of curves that pass from sheet to sheet, where more than two faces meet in an edge.
#include "bspline_curve/error.h"
#include "imprint/unjoined_imprint.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/seeds.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

/// Two plates that cross in a line of edges of four faces, and a third one that ends there.
TriangleMesh platesThroughEachOther() {
    const TriangleMesh flat = plate(4, 4);
    TriangleMesh mesh = flat;
    const auto addSheet = [&](auto place, auto isTaken) {
        std::vector<int> ids(flat.vertices.size());
        for (std::size_t v = 0; v < ids.size(); ++v) {
            const Vec3& p = flat.vertices[v];
            ids[v] = static_cast<int>(p.x() == 0.5 ? v : mesh.vertices.size());
            if (p.x() != 0.5) {
                mesh.vertices.push_back(place(p));
            }
        }
        for (const Triangle& face : flat.faces) {
            if (std::ranges::all_of(face, [&](int v) { return isTaken(flat.vertices[v].x()); })) {
                mesh.faces.push_back({ids[face[0]], ids[face[1]], ids[face[2]]});
            }
        }
    };
    addSheet(
        [](const Vec3& p) { return Vec3(0.5, p.y(), p.x() - 0.5); }, [](double) { return true; }
    );
    addSheet(
        [](const Vec3& p) { return Vec3(p.x(), p.y(), p.x() - 0.5); },
        [](double x) { return x >= 0.5; }
    );
    return mesh;
}

/// A walk over edges from face to face, whatever the number of faces at an edge.
SurfacePolyline walkOverSheets(const TriangleMesh& mesh, Random& random, int steps) {
    SurfacePolyline line;
    int face = random.integer(0, static_cast<int>(mesh.faces.size()) - 1);
    const auto add = [&](const Vec3& barycentric) {
        line.surfacePoints.push_back({.face = face, .barycentric = barycentric});
        line.points.push_back(positionOf(mesh, line.surfacePoints.back()));
    };
    add(Vec3::Constant(1.0 / 3.0));
    for (int i = 0; i < steps; ++i) {
        const int k = random.integer(0, 2);
        const double share = random.uniform(0.2, 0.8);
        Vec3 place = Vec3::Zero();
        place[(k + 1) % 3] = 1.0 - share;
        place[(k + 2) % 3] = share;
        add(place);
        std::vector<int> others;
        for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
            const auto hasEnd = [&](int end) {
                return cornerOf(mesh.faces[f], mesh.faces[face][(k + end) % 3]) >= 0;
            };
            if (f != face && hasEnd(1) && hasEnd(2)) {
                others.push_back(f);
            }
        }
        if (others.empty()) {
            break;
        }
        face = others[random.integer(0, static_cast<int>(others.size()) - 1)];
        add(Vec3::Constant(1.0 / 3.0));
    }
    return line;
}

void expectOnInput(const TriangleMesh& input, const ImprintedMesh& result) {
    const auto count = static_cast<int>(input.vertices.size());
    ASSERT_TRUE(
        std::equal(input.vertices.begin(), input.vertices.end(), result.mesh.vertices.begin())
    );
    ASSERT_EQ(result.newVertices.size() + input.vertices.size(), result.mesh.vertices.size());
    ASSERT_EQ(result.doubledVertices.size(), result.newVertices.size());
    std::vector<double> values;
    Random random(3);
    for (std::size_t v = 0; v < input.vertices.size(); ++v) {
        values.push_back(random.uniform(-1.0, 1.0));
    }
    const std::vector<double> carried = interpolated(result, input.faces, values);
    std::vector<double> areas(input.faces.size(), 0.0);
    std::set<int> used;
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        const Triangle& parent = input.faces[result.parents[f]];
        const Vec3& a = input.vertices[parent[0]];
        Eigen::Matrix<double, 3, 2> sides;
        sides << input.vertices[parent[1]] - a, input.vertices[parent[2]] - a;
        const auto& [p, q, r] = result.mesh.faces[f];
        areas[result.parents[f]] += (result.mesh.vertices[q] - result.mesh.vertices[p])
                                        .cross(result.mesh.vertices[r] - result.mesh.vertices[p])
                                        .norm() /
                                    sides.col(0).cross(sides.col(1)).norm();
        for (const int v : result.mesh.faces[f]) {
            used.insert(v);
            const int given = v < count ? v : result.doubledVertices[v - count];
            ASSERT_TRUE(given < 0 || cornerOf(parent, given) >= 0);
            const Eigen::Vector2d place =
                sides.colPivHouseholderQr().solve(result.mesh.vertices[v] - a);
            const double expected = (1.0 - place.sum()) * values[parent[0]] +
                                    place[0] * values[parent[1]] + place[1] * values[parent[2]];
            ASSERT_NEAR(carried[v], expected, 1e-9);
        }
    }
    for (const double area : areas) {
        ASSERT_NEAR(area, 1.0, 1e-9);
    }
    for (int v = count; v < static_cast<int>(result.mesh.vertices.size()); ++v) {
        ASSERT_TRUE(used.contains(v)) << v;
    }
}

/// Whether the line could be joined; then its imprint is that of the input.
bool imprintsOverSheets(const TriangleMesh& input, const SurfacePolyline& line) {
    const auto mended = std::make_shared<const Surface>(input, MendingOptions());
    checkLine(*mended, line, "the walk");
    const JoinedLines made = joinedFor(mended, std::span(&line, 1));
    const Surface& surface = *made.surface;
    try {
        static_cast<void>(strictLine(surface, made.lines[0], "the walk"));
    } catch (const InputError&) {
        return false;
    }
    const ImprintedMesh joined = imprint(surface, made.lines, {});
    const ImprintedMesh result = unjoined(surface, joined);
    expectOnInput(input, result);
    // By places, since seams have two vertices at each.
    const auto placed = [&](int from, int to) {
        const Vec3& a = result.mesh.vertices[from];
        const Vec3& b = result.mesh.vertices[to];
        return std::minmax({std::array{a.x(), a.y(), a.z()}, std::array{b.x(), b.y(), b.z()}});
    };
    std::set<std::pair<std::array<double, 3>, std::array<double, 3>>> edges;
    for (const Triangle& face : result.mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.insert(placed(face[k], face[(k + 1) % 3]));
        }
    }
    const std::vector<int>& vertices = result.curves.at(0).vertices;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        EXPECT_TRUE(edges.contains(placed(vertices[i - 1], vertices[i])));
    }
    EXPECT_LT((result.mesh.vertices[vertices.front()] - line.points.front()).norm(), 1e-14);
    EXPECT_LT((result.mesh.vertices[vertices.back()] - line.points.back()).norm(), 1e-14);
    return true;
}

TEST(ImprintOverPartedEdges, IsOnTheInputForRandomWalks) {
    const TriangleMesh mesh = platesThroughEachOther();
    int joined = 0;
    const int count = caseCount(100, 10);
    forEachSeed(count, [&](Random& random) {
        joined += imprintsOverSheets(mesh, walkOverSheets(mesh, random, 10)) ? 1 : 0;
    });
    EXPECT_GT(joined, 0.9 * count);
}

TEST(ImprintOverPartedEdges, HasSeamsBesides) {
    const TriangleMesh whole = platesThroughEachOther();
    std::vector<int> labels;
    for (const Triangle& face : whole.faces) {
        double y = 0.0;
        for (const int v : face) {
            y += whole.vertices[v].y() / 3.0;
        }
        labels.push_back(y < 0.5 ? 0 : 1);
    }
    const TriangleMesh mesh = partedByLabels(whole, labels);
    int joined = 0;
    const int count = caseCount(50, 5);
    forEachSeed(count, [&](Random& random) {
        joined += imprintsOverSheets(mesh, walkOverSheets(mesh, random, 8)) ? 1 : 0;
    });
    EXPECT_GT(joined, 0.9 * count);
}

// One face of three passes over to each of the others: the edge, and that face, are divided, and
// the line has a further point where it passes from one part of the face to the other.
TEST(ImprintOverPartedEdges, DividesAnEdgeThatOneFacePassesTwice) {
    const TriangleMesh mesh = threeFacesAtAnEdge();
    SurfacePolyline line;
    const auto add = [&](int face, const Vec3& barycentric) {
        line.surfacePoints.push_back({.face = face, .barycentric = barycentric});
        line.points.push_back(positionOf(mesh, line.surfacePoints.back()));
    };
    add(1, {0.25, 0.25, 0.5});
    add(1, {0.3, 0.7, 0.0});
    add(0, {0.1, 0.1, 0.8});
    add(0, {0.2, 0.8, 0.0});
    add(2, {0.2, 0.3, 0.5});
    EXPECT_TRUE(imprintsOverSheets(mesh, line));
    const auto mended = std::make_shared<const Surface>(mesh, MendingOptions());
    const JoinedLines made = joinedFor(mended, std::span(&line, 1));
    EXPECT_EQ(made.surface->input().faces, mesh.faces);
    EXPECT_NE(made.surface, mended);
    EXPECT_EQ(made.surface->componentCount(), 1);
    EXPECT_GT(made.surface->faceCount(), 3);
    EXPECT_GE(made.lines[0].points.size(), line.points.size());
}

// A closed line over the seam of a strip with one side.
TEST(ImprintOverPartedEdges, CrossesWhereAOneSidedSurfaceIsCut) {
    const TriangleMesh mesh = moebiusStrip(12);
    const auto mended = std::make_shared<const Surface>(mesh, MendingOptions());
    ASSERT_TRUE(mended->provenance().isOneSided());
    const RepairReport& report = *mended->provenance().report();
    ASSERT_FALSE(report.cutEdges.empty());
    const auto [low, high] = report.cutEdges.front();
    SurfacePolyline line;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        const int a = cornerOf(mesh.faces[f], low);
        const int b = cornerOf(mesh.faces[f], high);
        if (a < 0 || b < 0) {
            continue;
        }
        const Vec3 inside = Vec3::Constant(1.0 / 3.0);
        const Vec3 middle = 0.5 * (Vec3::Unit(a) + Vec3::Unit(b));
        line.surfacePoints.push_back({.face = f, .barycentric = inside});
        if (line.surfacePoints.size() == 1) {
            line.surfacePoints.push_back({.face = f, .barycentric = middle});
        }
    }
    for (const SurfacePoint& point : line.surfacePoints) {
        line.points.push_back(positionOf(mesh, point));
    }
    ASSERT_EQ(line.points.size(), 3U);
    EXPECT_TRUE(imprintsOverSheets(mesh, line));
}

TEST(ImprintOverPartedEdges, LeavesAloneWhatIsOnOneSheet) {
    const auto mended = std::make_shared<const Surface>(platesThroughEachOther(), MendingOptions());
    SurfacePolyline line;
    for (const Vec3& place : {Vec3(0.2, 0.3, 0.5), Vec3(0.5, 0.3, 0.2)}) {
        line.surfacePoints.push_back({.face = 0, .barycentric = place});
        line.points.push_back(mended->position(line.surfacePoints.back()));
    }
    EXPECT_EQ(joinedFor(mended, std::span(&line, 1)).surface, mended);
    line.surfacePoints[1].face = 20;
    try {
        checkLine(*mended, line, "it");
        ADD_FAILURE() << "a line that is in no face was accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), InputErrorCode::NoPath);
    }
}

}  // namespace

}  // namespace bspline_curve
