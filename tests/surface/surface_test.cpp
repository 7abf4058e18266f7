// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface.h"

#include "support/meshes.h"
#include "support/random.h"
#include "utility/worker_task.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

std::vector<std::pair<std::string, TriangleMesh>> sampleMeshes() {
    return {
        {"plate", plate(5, 4)},
        {"open cylinder", openCylinder(9, 3)},
        {"icosphere", icosphere(2)},
        {"torus", torus(12, 7)},
        {"box", box(3)},
        {"two components", twoComponents()},
        {"renumbered torus", renumbered(torus(12, 7), 1)},
        {"renumbered plate", renumbered(jitteredPlate(6, 5, 0.2, 2), 3)},
        {"single face", {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}}},
    };
}

/// A cone about the z axis without its base; the apex is vertex 0 and at all the faces.
TriangleMesh cone(int faces) {
    TriangleMesh mesh{.vertices = {Vec3::UnitZ()}, .faces = {}};
    for (int i = 0; i < faces; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / faces;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % faces});
    }
    return mesh;
}

int vertexOf(const Surface& surface, int face, int k) {
    return surface.faces()[face][k % 3];
}

int neighbourOf(const Surface& surface, int face, int k) {
    return surface.faceNeighbours()[face][k % 3];
}

int cornerOf(const Surface& surface, int face, int vertex) {
    for (int k = 0; k < 3; ++k) {
        if (vertexOf(surface, face, k) == vertex) {
            return k;
        }
    }
    ADD_FAILURE() << "face " << face << " does not have vertex " << vertex;
    return 0;
}

void expectMutualNeighbours(const Surface& surface, int face, int k) {
    const int neighbour = neighbourOf(surface, face, k);
    if (neighbour < 0) {
        return;
    }
    // The neighbour has the same edge in the opposite direction.
    const int tail = vertexOf(surface, face, k + 1);
    const int head = vertexOf(surface, face, k + 2);
    const int back = cornerOf(surface, neighbour, head) + 2;
    EXPECT_EQ(vertexOf(surface, neighbour, back + 1), head);
    EXPECT_EQ(vertexOf(surface, neighbour, back + 2), tail);
    EXPECT_EQ(neighbourOf(surface, neighbour, back), face);
}

TEST(Surface, NeighboursLieAcrossTheOppositeEdgeAndKnowEachOther) {
    for (const auto& [name, mesh] : sampleMeshes()) {
        SCOPED_TRACE(name);
        const Surface surface(mesh);
        for (int face = 0; face < surface.faceCount(); ++face) {
            for (int k = 0; k < 3; ++k) {
                expectMutualNeighbours(surface, face, k);
            }
        }
    }
}

TEST(Surface, OnlyEdgesOfOneFaceHaveNoNeighbour) {
    const auto boundaryEdges = [](const TriangleMesh& mesh) {
        const Surface surface(mesh);
        int count = 0;
        for (const Triangle& neighbours : surface.faceNeighbours()) {
            count += static_cast<int>(std::count(neighbours.begin(), neighbours.end(), -1));
        }
        return count;
    };
    EXPECT_EQ(boundaryEdges(plate(5, 4)), 18);
    EXPECT_EQ(boundaryEdges(openCylinder(9, 3)), 18);
    EXPECT_EQ(boundaryEdges(icosphere(2)), 0);
    EXPECT_EQ(boundaryEdges(torus(12, 7)), 0);
    EXPECT_EQ(boundaryEdges(box(3)), 0);
}

/// A closed fan comes back to its first face, an open one runs from boundary to boundary.
void expectWholeFan(const Surface& surface, int vertex) {
    const Surface::FaceRange faces = surface.facesAround(vertex);
    ASSERT_FALSE(faces.empty());
    const auto across = [&](int face, int turn) {
        return neighbourOf(surface, face, cornerOf(surface, face, vertex) + turn);
    };
    for (int i = 0; i + 1 < faces.size(); ++i) {
        EXPECT_EQ(across(faces.first[i], 1), faces.first[i + 1]) << "counter-clockwise";
    }
    const int first = *faces.begin();
    const int last = *(faces.end() - 1);
    const bool isBoundary = surface.isBoundaryVertex(vertex);
    EXPECT_EQ(across(last, 1), isBoundary ? -1 : first);
    EXPECT_EQ(across(first, 2), isBoundary ? -1 : last);
}

TEST(Surface, FacesAroundAVertexAreItsWholeFanCounterClockwise) {
    for (const auto& [name, mesh] : sampleMeshes()) {
        SCOPED_TRACE(name);
        const Surface surface(mesh);
        int total = 0;
        for (int vertex = 0; vertex < surface.vertexCount(); ++vertex) {
            expectWholeFan(surface, vertex);
            total += surface.facesAround(vertex).size();
        }
        EXPECT_EQ(total, 3 * surface.faceCount()) << "no face is missing or doubled";
    }
}

/// Every fan is whole, and the largest has as many faces as the mesh.
void expectConeOfWholeFans(const TriangleMesh& mesh) {
    const Surface surface(mesh);
    int largest = 0;
    for (int vertex = 0; vertex < surface.vertexCount(); ++vertex) {
        expectWholeFan(surface, vertex);
        largest = std::max(largest, surface.facesAround(vertex).size());
    }
    EXPECT_EQ(largest, surface.faceCount());
}

TEST(Surface, OrdersTheFacesAroundAVertexOfVeryManyFaces) {
    for (const int count : {3, 24, 25, 100000}) {
        SCOPED_TRACE(count);
        TriangleMesh mesh = cone(count);
        expectConeOfWholeFans(renumbered(mesh, 6));
        mesh.faces.erase(mesh.faces.begin() + count / 2);
        expectConeOfWholeFans(renumbered(mesh, 6));
    }
}

TEST(Surface, ClosedFansStartAtTheFirstFace) {
    const Surface surface(renumbered(torus(12, 7), 7));
    for (int vertex = 0; vertex < surface.vertexCount(); ++vertex) {
        const Surface::FaceRange faces = surface.facesAround(vertex);
        EXPECT_EQ(faces.first[0], *std::min_element(faces.begin(), faces.end()));
    }
}

/// The part is in the whole, its faces and vertices moved up.
void expectHolds(const Surface& whole, const Surface& part, int firstFace, int firstVertex) {
    for (int face = 0; face < part.faceCount(); ++face) {
        for (int k = 0; k < 3; ++k) {
            const int neighbour = neighbourOf(part, face, k);
            ASSERT_EQ(
                neighbourOf(whole, firstFace + face, k), neighbour < 0 ? -1 : firstFace + neighbour
            );
        }
    }
    for (int vertex = 0; vertex < part.vertexCount(); ++vertex) {
        const Surface::FaceRange faces = part.facesAround(vertex);
        const Surface::FaceRange same = whole.facesAround(firstVertex + vertex);
        ASSERT_EQ(whole.isBoundaryVertex(firstVertex + vertex), part.isBoundaryVertex(vertex));
        ASSERT_TRUE(
            std::equal(
                faces.begin(), faces.end(), same.begin(), same.end(), [&](int own, int other) {
                    return firstFace + own == other;
                }
            )
        );
    }
}

/// Mean length of the edges, added by their low, then their high vertices.
double meanOfEdgesInOrder(const TriangleMesh& mesh) {
    std::set<std::pair<int, int>> edges;
    for (const Triangle& face : mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.insert(std::minmax({face[k], face[(k + 1) % 3]}));
        }
    }
    double sum = 0.0;
    for (const auto& [low, high] : edges) {
        sum += (mesh.vertices[low] - mesh.vertices[high]).norm();
    }
    return sum / static_cast<double>(edges.size());
}

TEST(Surface, IsTheSameOnTwoThreadsToTheLastDigit) {
    // The whole takes two threads, its parts one each.
    const TriangleMesh first = renumbered(jitteredPlate(100, 100, 0.2, 8), 9);
    const TriangleMesh second = renumbered(icosphere(4), 10);
    const TriangleMesh mesh = joined(first, second);
    ASSERT_LT(std::max(first.faces.size(), second.faces.size()), kFacesForTwoThreads);
    ASSERT_GE(mesh.faces.size(), kFacesForTwoThreads);
    const Surface whole(mesh);
    const auto firstFaces = static_cast<int>(first.faces.size());
    const auto firstVertices = static_cast<int>(first.vertices.size());
    expectHolds(whole, Surface(first), 0, 0);
    expectHolds(whole, Surface(second), firstFaces, firstVertices);
    EXPECT_EQ(whole.componentCount(), 2);
    EXPECT_EQ(whole.faceComponents()[first.faces.size() - 1], 0);
    EXPECT_EQ(whole.faceComponents()[first.faces.size()], 1);

    EXPECT_EQ(whole.averageEdgeLength(), meanOfEdgesInOrder(mesh));
}

TEST(Surface, AllowsUnreferencedVerticesAndLeavesThemOutOfTheBox) {
    TriangleMesh mesh = plate(1, 1, 3.0, 4.0);
    mesh.vertices.emplace_back(100.0, 100.0, 100.0);
    const Surface surface(mesh);
    EXPECT_TRUE(surface.facesAround(4).empty());
    EXPECT_EQ(surface.facesAround(4).size(), 0);
    EXPECT_FALSE(surface.isBoundaryVertex(4));
    EXPECT_DOUBLE_EQ(surface.diagonal(), 5.0);
}

TEST(Surface, NumbersComponentsInOrderOfTheirFirstFaces) {
    EXPECT_EQ(Surface(torus(8, 5)).componentCount(), 1);
    const Surface surface(twoComponents());
    ASSERT_EQ(surface.componentCount(), 2);
    for (int face = 0; face < surface.faceCount(); ++face) {
        const int expected = face < surface.faceCount() / 2 ? 0 : 1;
        EXPECT_EQ(surface.faceComponents()[face], expected);
    }
    const Surface shuffled(renumbered(twoComponents(), 4));
    EXPECT_EQ(shuffled.componentCount(), 2);
    EXPECT_EQ(shuffled.faceComponents().front(), 0);
}

TEST(Surface, MeasuresTheDiagonalAndTheMeanOfAllEdges) {
    // Unit cells: 4 sides of length 1 and a diagonal of sqrt 2.
    const Surface surface(plate(1, 1));
    EXPECT_DOUBLE_EQ(surface.diagonal(), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(surface.averageEdgeLength(), (4.0 + std::sqrt(2.0)) / 5.0);

    // Independent: inner edges counted by both faces, boundary edges twice.
    for (const auto& [name, mesh] : sampleMeshes()) {
        SCOPED_TRACE(name);
        const Surface sample(mesh);
        double sum = 0.0;
        double count = 0.0;
        for (int face = 0; face < sample.faceCount(); ++face) {
            for (int k = 0; k < 3; ++k) {
                const Vec3& tail = sample.vertices()[vertexOf(sample, face, k + 1)];
                const Vec3& head = sample.vertices()[vertexOf(sample, face, k + 2)];
                const double weight = neighbourOf(sample, face, k) < 0 ? 2.0 : 1.0;
                sum += weight * (head - tail).norm();
                count += weight;
            }
        }
        EXPECT_NEAR(sample.averageEdgeLength(), sum / count, 1e-13);
    }
}

TEST(Surface, MeasuresTheArea) {
    EXPECT_DOUBLE_EQ(Surface(plate(5, 4, 3.0, 2.0)).area(), 6.0);
    EXPECT_DOUBLE_EQ(Surface(box(3, {1.0, 2.0, 3.0})).area(), 22.0);
}

TEST(Surface, NormalsPointOutOfAClosedSurface) {
    const Surface surface(icosphere(2, 3.0));
    for (int face = 0; face < surface.faceCount(); ++face) {
        const Vec3 centre =
            surface.position({.face = face, .barycentric = Vec3::Constant(1.0 / 3)});
        EXPECT_NEAR(surface.faceNormal(face).norm(), 1.0, 1e-15);
        EXPECT_GT(surface.faceNormal(face).dot(centre.normalized()), 0.99);
    }
}

TEST(Surface, PositionFollowsTheBarycentricCoordinates) {
    const Surface surface(plate(1, 1));
    for (int face = 0; face < 2; ++face) {
        for (int k = 0; k < 3; ++k) {
            const Vec3& corner = surface.vertices()[vertexOf(surface, face, k)];
            EXPECT_EQ(surface.position({.face = face, .barycentric = Vec3::Unit(k)}), corner);
        }
    }
}

TEST(Surface, RigidMotionAndScalingChangeLengthsOnly) {
    constexpr std::uint64_t kSeed = 5;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    const TriangleMesh mesh = jitteredPlate(7, 7, 0.25, kSeed);
    const Surface before(mesh);
    const Surface after(transformed(mesh, random.isometry(10.0), 2.5));
    EXPECT_EQ(after.faceNeighbours(), before.faceNeighbours());
    EXPECT_EQ(after.faceComponents(), before.faceComponents());
    EXPECT_NEAR(after.averageEdgeLength(), 2.5 * before.averageEdgeLength(), 1e-12);
}

}  // namespace
}  // namespace bspline_curve
