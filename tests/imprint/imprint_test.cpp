// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of imprint(), checked from its result alone, for random curves on generated meshes.
#include "imprint/imprint.h"

#include "bspline_curve/error.h"
#include "imprint/mesh_parts.h"
#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/half_edges.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace bspline_curve {

namespace {

using namespace test_support;

Vec3 normalOf(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& a = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
}

Vec3 barycentricIn(const TriangleMesh& mesh, const Triangle& face, const Vec3& point) {
    const Vec3 normal = normalOf(mesh, face);
    Vec3 result;
    for (int k = 0; k < 3; ++k) {
        const Vec3& b = mesh.vertices[face[(k + 1) % 3]];
        const Vec3& c = mesh.vertices[face[(k + 2) % 3]];
        result[k] = (c - b).cross(point - b).dot(normal) / normal.squaredNorm();
    }
    return result;
}

int eulerOf(const std::vector<Triangle>& faces) {
    std::set<int> vertices;
    int edges = 0;
    for (const Triangle& face : faces) {
        vertices.insert(face.begin(), face.end());
    }
    forEachEdge(sortedHalfEdges(faces), [&](auto) { ++edges; });
    return static_cast<int>(vertices.size()) - edges + static_cast<int>(faces.size());
}

/// Children have area, their parent's orientation, lie in it and cover it.
void expectChildrenFillParents(const Surface& surface, const ImprintedMesh& result) {
    // New vertices are rounded as their coordinates are, which counts far from the origin.
    double largest = 0.0;
    for (const Vec3& vertex : surface.vertices()) {
        largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    }
    const double tolerance = 1e-12 + 1e-15 * largest / surface.averageEdgeLength();
    std::vector<double> areas(surface.faceCount(), 0.0);
    std::vector<int> count(surface.faceCount(), 0);
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        const Triangle& parent = surface.faces()[result.parents[f]];
        const Vec3 normal = normalOf(result.mesh, result.mesh.faces[f]);
        ASSERT_GT(normal.dot(normalOf(surface.mesh(), parent)), 0.0) << "face " << f;
        areas[result.parents[f]] += normal.norm();
        ++count[result.parents[f]];
        for (const int vertex : result.mesh.faces[f]) {
            const Vec3 place = barycentricIn(surface.mesh(), parent, result.mesh.vertices[vertex]);
            ASSERT_GE(place.minCoeff(), -tolerance) << "face " << f;
        }
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
        ASSERT_NEAR(areas[f] / normalOf(surface.mesh(), surface.faces()[f]).norm(), 1.0, 1e-9);
    }
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        if (count[result.parents[f]] == 1) {
            ASSERT_EQ(result.mesh.faces[f], surface.faces()[result.parents[f]]);
        }
    }
}

void expectCurvesAreEdges(
    const ImprintedMesh& result, const std::vector<SurfacePolyline>& curves, double tolerance
) {
    std::set<std::pair<int, int>> edges;
    for (const HalfEdge& side : sortedHalfEdges(result.mesh.faces)) {
        edges.emplace(side.low, side.high);
    }
    ASSERT_EQ(result.curves.size(), curves.size());
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const std::vector<int>& vertices = result.curves[c].vertices;
        const std::size_t count = vertices.size();
        std::size_t at = 0;
        for (std::size_t i = 0; i + 1 < count + (result.curves[c].closed ? 1 : 0); ++i) {
            ASSERT_TRUE(edges.contains(std::minmax(vertices[i], vertices[(i + 1) % count])));
        }
        // The curve's own points come in order.
        for (const Vec3& point : curves[c].points) {
            std::size_t tries = 0;
            while ((result.mesh.vertices[vertices[at % count]] - point).norm() > tolerance) {
                ++at;
                ASSERT_LE(++tries, count) << "curve " << c << " leaves out a point";
            }
        }
    }
}

void expectContract(const Surface& surface, const std::vector<SurfacePolyline>& curves) {
    const ImprintedMesh result = imprint(surface, curves, {});
    ASSERT_TRUE(
        std::equal(
            surface.vertices().begin(), surface.vertices().end(), result.mesh.vertices.begin()
        )
    );
    expectChildrenFillParents(surface, result);
    expectCurvesAreEdges(result, curves, 1e-6);
    ASSERT_EQ(eulerOf(result.mesh.faces), eulerOf(surface.faces()));
    const Surface again(result.mesh);  // still a surface
    ASSERT_NEAR(again.area(), surface.area(), 1e-9 * surface.area());
    ASSERT_LT(result.largestMove, 1e-7);

    const TriangleMesh removed = withoutImprint(result);
    ASSERT_EQ(removed.vertices, surface.vertices());
    ASSERT_EQ(removed.faces, surface.faces());

    std::vector<SurfacePolyline> imprinted;
    for (const ImprintedCurve& curve : result.curves) {
        if (curve.vertices.size() > 1) {
            imprinted.push_back(polylineOf(again, curve));
        }
    }
    const ImprintedMesh twice = imprint(again, imprinted, {});
    ASSERT_EQ(twice.mesh.vertices, result.mesh.vertices);
    ASSERT_EQ(twice.mesh.faces, result.mesh.faces);

    const std::vector<SurfacePolyline> reversed(curves.rbegin(), curves.rend());
    const ImprintedMesh other = imprint(surface, reversed, {});
    ASSERT_EQ(other.mesh.vertices, result.mesh.vertices);
    ASSERT_EQ(other.mesh.faces, result.mesh.faces);
}

void expectParts(const Surface& surface, const std::vector<SurfacePolyline>& curves) {
    const ImprintedMesh result = imprint(surface, curves, {});
    const MeshParts parts = partsOf(result);
    double area = 0.0;
    int faces = 0;
    for (const MeshPart& part : parts.parts) {
        area += part.area;
        faces += part.faces;
    }
    ASSERT_NEAR(area, surface.area(), 1e-9 * surface.area());
    ASSERT_EQ(faces, static_cast<int>(result.mesh.faces.size()));

    const CutMesh cut = cutAlongCurves(result);
    const Surface opened(cut.mesh);
    ASSERT_EQ(opened.componentCount(), static_cast<int>(parts.parts.size()));
    int euler = 0;
    for (const MeshPart& part : parts.parts) {
        euler += part.euler;
    }
    ASSERT_EQ(euler, eulerOf(cut.mesh.faces));
    TriangleMesh welded = cut.mesh;
    for (Triangle& face : welded.faces) {
        for (int& vertex : face) {
            ASSERT_EQ(cut.mesh.vertices[vertex], result.mesh.vertices[cut.source[vertex]]);
            vertex = cut.source[vertex];
        }
    }
    ASSERT_EQ(welded.faces, result.mesh.faces);
}

struct MeshCase {
    std::string name;
    TriangleMesh mesh;
};

std::vector<MeshCase> meshCases() {
    return {
        {"plate", plate(2, 2)},
        {"jittered plate", jitteredPlate(9, 7, 0.25, 3)},
        {"sphere", icosphere(2)},
        {"torus", torus(14, 9)},
        {"box", box(1)},
        {"cylinder", openCylinder(9, 4)},
        {"two components", twoComponents()},
        {"far away",
         transformed(icosphere(1), Eigen::Isometry3d(Eigen::Translation3d(1e4, -3e3, 5e3)))},
        {"needles", plate(40, 1, 1.0, 30.0)},
    };
}

TEST(Imprint, KeepsItsContractForRandomCurves) {
    for (const auto& [name, mesh] : meshCases()) {
        SCOPED_TRACE(name);
        const Surface surface(mesh);
        forEachSeed(caseCount(120, 8), [&](Random& random) {
            expectContract(surface, randomCurves(surface, random));
        });
    }
}

TEST(Imprint, PartsAndCutsAddUpForRandomCurves) {
    for (const auto& [name, mesh] : meshCases()) {
        SCOPED_TRACE(name);
        const Surface surface(mesh);
        forEachSeed(caseCount(60, 4), [&](Random& random) {
            expectParts(surface, randomCurves(surface, random));
        });
    }
}

SurfacePoint at(int face, double a, double b, double c) {
    return {face, Vec3(a, b, c)};
}

TEST(Imprint, NamesTheVertexWhereTwoCurvesCross) {
    const Surface surface(plate(1, 1));
    const auto across = [&](int i, int j) {
        SurfacePoint from{.face = 0};
        from.barycentric[i] = 0.5;
        from.barycentric[(i + 1) % 3] = 0.5;
        SurfacePoint to{.face = 0};
        to.barycentric[j] = 1.0;
        return polylineThrough(surface, {from, to}, false);
    };
    // Two medians.
    const std::vector<SurfacePolyline> curves{across(0, 2), across(1, 0)};
    const ImprintedMesh result = imprint(surface, curves, {});
    ASSERT_EQ(result.crossings.size(), 1U);
    const Vec3 crossing = result.mesh.vertices[result.crossings[0]];
    EXPECT_LT((crossing - surface.position(at(0, 1.0 / 3, 1.0 / 3, 1.0 / 3))).norm(), 1e-15);
    for (const ImprintedCurve& curve : result.curves) {
        EXPECT_EQ(curve.vertices.size(), 3U);
        EXPECT_EQ(curve.vertices[1], result.crossings[0]);
    }
}

TEST(Imprint, AnEdgeOfTheMeshIsNoChange) {
    const Surface surface(icosphere(1));
    const SurfacePolyline edge = polylineThrough(surface, {at(5, 1, 0, 0), at(5, 0, 1, 0)}, false);
    const ImprintedMesh result = imprint(surface, std::vector{edge}, {});
    EXPECT_EQ(result.mesh.faces, surface.faces());
    EXPECT_EQ(
        result.curves[0].vertices, (std::vector{surface.faces()[5][0], surface.faces()[5][1]})
    );
}

TEST(Imprint, ACurveRoundAVertexPartsADiscFromASphere) {
    const Surface surface(icosphere(2));
    std::vector<SurfacePoint> points;
    for (const int face : surface.facesAround(7)) {
        SurfacePoint point{.face = face};
        for (int k = 0; k < 3; ++k) {
            point.barycentric[k] = surface.faces()[face][k] == 7 ? 0.4 : 0.3;
        }
        points.push_back(point);
        // On to the edge to the next face.
        const int k = surface.faces()[face][0] == 7 ? 0 : (surface.faces()[face][1] == 7 ? 1 : 2);
        SurfacePoint edge{.face = face};
        edge.barycentric[k] = 0.5;
        edge.barycentric[(k + 2) % 3] = 0.5;
        points.push_back(edge);
    }
    const ImprintedMesh result =
        imprint(surface, std::vector{polylineThrough(surface, points, true)}, {});
    const MeshParts parts = partsOf(result);
    ASSERT_EQ(parts.parts.size(), 2U);
    EXPECT_GT(parts.parts[0].area, parts.parts[1].area);
    EXPECT_EQ(parts.parts[0].euler, 1);
    EXPECT_EQ(parts.parts[1].euler, 1);
    EXPECT_DOUBLE_EQ(parts.parts[0].perimeter, parts.parts[1].perimeter);
}

TEST(Imprint, QualityIsLinearInParents) {
    const Surface surface(jitteredPlate(6, 6, 0.2, 1));
    std::vector<double> heights;
    const Vec3 slope(1.0, -2.0, 0.5);
    for (const Vec3& vertex : surface.vertices()) {
        heights.push_back(slope.dot(vertex));
    }
    Random random(4);
    const ImprintedMesh result = imprint(surface, randomCurves(surface, random), {});
    const std::vector<double> values = interpolated(result, surface.faces(), heights);
    ASSERT_EQ(values.size(), result.mesh.vertices.size());
    for (std::size_t v = 0; v < values.size(); ++v) {
        EXPECT_NEAR(values[v], slope.dot(result.mesh.vertices[v]), 1e-14);
    }
}

TEST(Imprint, TakesPointsWithinTheSnappingDistanceAsOne) {
    const Surface surface(plate(1, 1));
    const SurfacePolyline low =
        polylineThrough(surface, {at(0, 0, 1, 0), at(0, 0.5, 0, 0.5)}, false);
    const SurfacePolyline high =
        polylineThrough(surface, {at(0, 0.499, 0, 0.501), at(0, 0.2, 0.2, 0.6)}, false);
    const std::vector curves{low, high};
    EXPECT_EQ(imprint(surface, curves, {}).crossings.size(), 0U);
    const ImprintedMesh snapped = imprint(surface, curves, {.snap = 0.005});
    EXPECT_EQ(snapped.curves[0].vertices.back(), snapped.curves[1].vertices.front());
    EXPECT_NEAR(snapped.largestMove, 0.001 * std::sqrt(2.0), 1e-4);
}

// Corners may be farther apart than the snapping distance and each within it of the opposite side:
// divided at each of them, sides would become each other in a circle.
TEST(Imprint, DividesNoSmallTriangleInACircle) {
    const Surface surface(plate(1, 1));
    const double snap = 0.005;
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        std::vector<SurfacePoint> corners;
        for (int k = 0; k < 3; ++k) {
            const double x = 0.3 + snap * random.uniform(0.0, 3.0);
            const double y = 0.3 + snap * random.uniform(0.0, 3.0);
            corners.push_back(at(0, 1.0 - x - y, x, y));
        }
        const std::vector curves{polylineThrough(surface, corners, true)};
        const ImprintedMesh result = imprint(surface, curves, {.snap = snap});
        EXPECT_EQ(withoutImprint(result).faces, surface.faces());
    }
}

// Three faces at an edge, the first of them turned over: vertices are doubled where it is parted.
TEST(Imprint, IsOnTheMeshAsItWasGiven) {
    const TriangleMesh mesh = withFaceReversed(threeFacesAtAnEdge(), 0);
    const Surface surface(mesh, MendingOptions());
    ASSERT_GT(surface.vertexCount(), static_cast<int>(mesh.vertices.size()));
    std::vector<SurfacePolyline> lines;
    for (int face = 0; face < 3; ++face) {
        SurfacePolyline line =
            polylineThrough(surface, {at(face, 0.2, 0.3, 0.5), at(face, 0.0, 0.9, 0.1)}, false);
        surface.provenance().bringToInput(line);
        lines.push_back(std::move(line));
    }
    const ImprintedMesh result = imprint(surface, lines, {});
    const std::size_t old = mesh.vertices.size();
    ASSERT_EQ(result.newVertices.size() + old, result.mesh.vertices.size());
    for (std::size_t i = 0; i < result.newVertices.size(); ++i) {
        const Vec3 position = positionOf(mesh, result.newVertices[i]);
        EXPECT_LT((position - result.mesh.vertices[old + i]).norm(), 1e-14) << i;
    }
    ASSERT_EQ(result.parents.size(), result.mesh.faces.size());
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        for (const int vertex : result.mesh.faces[f]) {
            const Vec3 place =
                barycentricIn(mesh, mesh.faces[result.parents[f]], result.mesh.vertices[vertex]);
            EXPECT_GE(place.minCoeff(), -1e-14) << "face " << f;
        }
    }
    EXPECT_EQ(withoutImprint(result).faces, surface.faces());
}

TEST(Imprint, RefusesWhatIsNotOnTheSurface) {
    const Surface surface(plate(3, 3));
    const SurfacePolyline jump =
        polylineThrough(surface, {at(0, 0.2, 0.3, 0.5), at(9, 0.2, 0.3, 0.5)}, false);
    expectRefused(
        [&] { return imprint(surface, std::vector{jump}, {}); },
        InputErrorCode::NoPath,
        "curve 0: the segment from vertex 0 to 1 is not in one face"
    );
    const SurfacePolyline dot = polylineThrough(surface, {at(0, 0.2, 0.3, 0.5)}, false);
    expectRefused(
        [&] { return imprint(surface, std::vector{dot}, {}); },
        InputErrorCode::NoPath,
        "has no segment"
    );
    expectRefused(
        [&] { return imprint(surface, {}, {.snap = 0.5}); },
        InputErrorCode::BadOption,
        "snap is 0.5, but must be in [0, 0.01]"
    );
}

}  // namespace

}  // namespace bspline_curve
