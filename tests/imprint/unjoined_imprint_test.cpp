// SPDX-License-Identifier: GPL-3.0-or-later
// Imprints of meshes with seams: ids, and values that jump at seams, are those of the mesh.
#include "imprint/unjoined_imprint.h"

#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/seeds.h"
#include "surface/half_edges.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

std::vector<int> randomLabels(const TriangleMesh& mesh, Random& random) {
    std::vector<int> labels(mesh.faces.size());
    for (int& label : labels) {
        label = random.integer(0, 2);
    }
    return labels;
}

/// Two halves with a seam at x = 0.5, on 4 x 4 cells; vertex j * 5 + 2 is on it.
TriangleMesh halvedPlate() {
    const TriangleMesh whole = plate(4, 4);
    std::vector<int> labels;
    for (const Triangle& face : whole.faces) {
        double x = 0.0;
        for (const int v : face) {
            x += whole.vertices[v].x() / 3.0;
        }
        labels.push_back(x < 0.5 ? 0 : 1);
    }
    return partedByLabels(whole, labels);
}

using PlacedEdge = std::pair<std::array<double, 3>, std::array<double, 3>>;

PlacedEdge placed(const TriangleMesh& mesh, int from, int to) {
    const auto place = [&](int v) {
        const Vec3& at = mesh.vertices[v];
        return std::array{at.x(), at.y(), at.z()};
    };
    return std::minmax({place(from), place(to)});
}

/// Edges counted, vertices of faces counted, length of the boundary.
struct Shape {
    int euler = 0;
    double boundary = 0.0;
};

Shape shapeOf(const TriangleMesh& mesh) {
    Shape shape{.euler = static_cast<int>(mesh.faces.size())};
    std::set<int> vertices;
    for (const Triangle& face : mesh.faces) {
        vertices.insert(face.begin(), face.end());
    }
    shape.euler += static_cast<int>(vertices.size());
    forEachEdge(sortedHalfEdges(mesh.faces), [&](std::span<const HalfEdge> sides) {
        --shape.euler;
        EXPECT_LE(sides.size(), 2U);
        if (sides.size() == 1) {
            shape.boundary += (mesh.vertices[sides[0].low] - mesh.vertices[sides[0].high]).norm();
        }
    });
    return shape;
}

/// Values that differ at vertices of one place are linear in each face of the input.
void expectValuesOfTheirSide(const TriangleMesh& input, const ImprintedMesh& result) {
    std::vector<double> values;
    Random random(7);
    for (std::size_t v = 0; v < input.vertices.size(); ++v) {
        values.push_back(random.uniform(-1.0, 1.0));
    }
    const std::vector<double> carried = interpolated(result, input.faces, values);
    ASSERT_EQ(carried.size(), result.mesh.vertices.size());
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        const Triangle& parent = input.faces[result.parents[f]];
        const Vec3& a = input.vertices[parent[0]];
        Eigen::Matrix<double, 3, 2> sides;
        sides << input.vertices[parent[1]] - a, input.vertices[parent[2]] - a;
        for (const int v : result.mesh.faces[f]) {
            const Eigen::Vector2d place =
                sides.colPivHouseholderQr().solve(result.mesh.vertices[v] - a);
            const double expected = (1.0 - place.sum()) * values[parent[0]] +
                                    place[0] * values[parent[1]] + place[1] * values[parent[2]];
            ASSERT_NEAR(carried[v], expected, 1e-9) << "face " << f << ", vertex " << v;
        }
    }
}

void expectInputsVertices(const TriangleMesh& input, const ImprintedMesh& result) {
    const std::size_t count = input.vertices.size();
    ASSERT_TRUE(
        std::equal(input.vertices.begin(), input.vertices.end(), result.mesh.vertices.begin())
    );
    ASSERT_EQ(result.mesh.vertices.size(), count + result.newVertices.size());
    ASSERT_EQ(result.newVertices.size(), result.doubledVertices.size());
    for (std::size_t i = 0; i < result.newVertices.size(); ++i) {
        const Vec3& at = result.mesh.vertices[count + i];
        ASSERT_LT((positionOf(input, result.newVertices[i]) - at).norm(), 1e-12);
        const int doubled = result.doubledVertices[i];
        ASSERT_TRUE(doubled < 0 || input.vertices[doubled] == at);
    }
    std::vector<int> children(input.faces.size(), 0);
    for (const int parent : result.parents) {
        ++children[parent];
    }
    for (std::size_t f = 0; f < result.parents.size(); ++f) {
        if (children[result.parents[f]] == 1) {
            ASSERT_EQ(result.mesh.faces[f], input.faces[result.parents[f]]);
        }
    }
}

void expectUnjoined(const Surface& surface, std::vector<SurfacePolyline> curves) {
    for (SurfacePolyline& curve : curves) {
        surface.provenance().bringToInput(curve);
    }
    const TriangleMesh& input = surface.input();
    const ImprintedMesh joined = imprint(surface, curves, {});
    const ImprintedMesh result = unjoined(surface, joined);
    ASSERT_NO_FATAL_FAILURE(expectInputsVertices(input, result));
    ASSERT_NO_FATAL_FAILURE(expectValuesOfTheirSide(input, result));
    std::set<PlacedEdge> edges;
    ASSERT_EQ(result.mesh.faces.size(), joined.mesh.faces.size());
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        const Triangle& face = result.mesh.faces[f];
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(result.mesh.vertices[face[k]], joined.mesh.vertices[joined.mesh.faces[f][k]]);
            edges.insert(placed(result.mesh, face[k], face[(k + 1) % 3]));
        }
    }
    const Shape before = shapeOf(input);
    const Shape after = shapeOf(result.mesh);
    ASSERT_EQ(after.euler, before.euler);
    ASSERT_NEAR(after.boundary, before.boundary, 1e-9 * before.boundary);
    for (const auto& [closed, vertices] : result.curves) {
        for (std::size_t i = closed ? 0 : 1; i < vertices.size(); ++i) {
            const int from = vertices[i > 0 ? i - 1 : vertices.size() - 1];
            ASSERT_TRUE(
                vertices.size() == 1 || edges.contains(placed(result.mesh, from, vertices[i]))
            );
        }
    }
}

TEST(UnjoinedImprint, HasTheSeamsOfItsInputForRandomCurves) {
    for (const TriangleMesh& mesh :
         {slitAlongZ(openCylinder(12, 5)),
          renumbered(slitAlongZ(openCylinder(7, 3)), 3),
          halvedPlate()}) {
        const Surface surface(mesh, MendingOptions());
        ASSERT_TRUE(surface.provenance().hasInputCorners());
        forEachSeed(caseCount(150, 10), [&](Random& random) {
            expectUnjoined(surface, randomCurves(surface, random));
        });
    }
}

// Labels of faces are random, so that seams meet and vertices are left that faces of one label
// share beside a seam.
TEST(UnjoinedImprint, HasSeamsThatMeet) {
    for (const TriangleMesh& mesh : {plate(5, 4), icosphere(1), torus(8, 5)}) {
        forEachSeed(caseCount(100, 8), [&](Random& random) {
            const TriangleMesh parted = partedByLabels(mesh, randomLabels(mesh, random));
            const Surface surface(parted, MendingOptions());
            expectUnjoined(surface, randomCurves(surface, random));
        });
    }
}

SurfacePoint onGridEdge(const Surface& surface, int from, int to, double share) {
    for (const int face : surface.facesAround(from)) {
        const Triangle& corners = surface.faces()[face];
        if (cornerOf(corners, to) >= 0) {
            SurfacePoint point{.face = face};
            point.barycentric[cornerOf(corners, from)] = 1.0 - share;
            point.barycentric[cornerOf(corners, to)] = share;
            return point;
        }
    }
    throw std::logic_error("no such edge");
}

/// How many vertices an imprint of the halved plate has beyond those of the joined one.
int copiesAt(const Surface& surface, const SurfacePolyline& curve) {
    const ImprintedMesh joined = imprint(surface, std::vector{curve}, {});
    const ImprintedMesh result = unjoined(surface, joined);
    EXPECT_EQ(result.curves[0].vertices, joined.curves[0].vertices);
    EXPECT_EQ(result.crossings, joined.crossings);
    return static_cast<int>(result.mesh.vertices.size() - joined.mesh.vertices.size());
}

TEST(UnjoinedImprint, DoublesNewVerticesOnSeamsAlone) {
    const Surface surface(halvedPlate(), MendingOptions());
    ASSERT_EQ(surface.provenance().report()->joinedEdges.size(), 4U);
    const auto along = [&](const std::vector<std::array<int, 2>>& grid) {
        return alongGrid(surface, 4, grid, false);
    };
    // Through a vertex of the seam, and along it: nothing is new there.
    EXPECT_EQ(copiesAt(surface, along({{1, 2}, {2, 2}, {3, 2}})), 0);
    EXPECT_EQ(copiesAt(surface, along({{2, 0}, {2, 1}, {2, 2}, {2, 3}, {2, 4}})), 0);
    // From a vertex to the middle of an edge.
    const SurfacePoint middle = onGridEdge(surface, 7, 12, 0.5);
    const SurfacePoint vertex = onGridEdge(surface, 7, 12, 0.0);
    EXPECT_EQ(copiesAt(surface, polylineThrough(surface, {vertex, middle}, false)), 1);
    // Across the edge, from inside of one face into the other.
    std::vector<SurfacePoint> across;
    for (const int face : facesHolding(surface, middle)) {
        across.push_back({.face = face, .barycentric = Vec3::Constant(1.0 / 3.0)});
    }
    ASSERT_EQ(across.size(), 2U);
    const SurfacePolyline crossing =
        polylineThrough(surface, {across[0], middle, across[1]}, false);
    EXPECT_EQ(copiesAt(surface, crossing), 1);
}

TEST(UnjoinedImprint, KeepsTheVertexOfTheLowerSideInTheCurve) {
    const Surface surface(halvedPlate(), MendingOptions());
    const SurfacePolyline curve = polylineThrough(
        surface, {onGridEdge(surface, 7, 12, 0.5), onGridEdge(surface, 7, 12, 1.0)}, false
    );
    const ImprintedMesh result = unjoined(surface, imprint(surface, std::vector{curve}, {}));
    const int kept = result.curves[0].vertices.front();
    const auto copy = static_cast<int>(result.mesh.vertices.size()) - 1;
    ASSERT_EQ(copy, kept + 1);
    EXPECT_EQ(result.mesh.vertices[copy], result.mesh.vertices[kept]);
    EXPECT_EQ(surface.input().vertices[7].x(), 0.5);
    for (std::size_t f = 0; f < result.mesh.faces.size(); ++f) {
        const Triangle& face = result.mesh.faces[f];
        const Triangle& parent = surface.input().faces[result.parents[f]];
        // The lower side is that whose faces have the vertices 7 and 12 themselves.
        if (cornerOf(face, kept) >= 0) {
            EXPECT_TRUE(cornerOf(parent, 7) >= 0 && cornerOf(parent, 12) >= 0);
        }
        if (cornerOf(face, copy) >= 0) {
            EXPECT_TRUE(cornerOf(parent, 7) < 0 && cornerOf(parent, 12) < 0);
        }
    }
}

}  // namespace

}  // namespace bspline_curve
