// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/designer.h"
#include "fill/fill_holes.h"
#include "fill/part_filling.h"
#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace bspline_curve {

namespace {

using namespace test_support;

bool isWatertight(const Surface& surface) {
    return std::ranges::all_of(surface.faceNeighbours(), [](const Triangle& neighbours) {
        return std::ranges::all_of(neighbours, [](int face) { return face >= 0; });
    });
}

/// The mesh without the faces whose corners all satisfy a condition.
template <class Condition>
TriangleMesh without(TriangleMesh mesh, const Condition& condition) {
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        return std::ranges::all_of(face, [&](int v) { return condition(mesh.vertices[v]); });
    });
    return mesh;
}

FilledMesh filled(const TriangleMesh& mesh, FillShape shape) {
    return fillHoles(mesh, rimsOf(mesh.faces), shape);
}

void expectGivenComesFirst(const TriangleMesh& given, const TriangleMesh& result) {
    ASSERT_GE(result.vertices.size(), given.vertices.size());
    EXPECT_TRUE(
        std::ranges::equal(
            given.vertices,
            std::vector(
                result.vertices.begin(), result.vertices.begin() + std::ssize(given.vertices)
            )
        )
    );
    EXPECT_TRUE(
        std::ranges::equal(
            given.faces,
            std::vector(result.faces.begin(), result.faces.begin() + std::ssize(given.faces))
        )
    );
}

TEST(Fill, ASmoothCapComesNearTheSphereThatItIsCutFrom) {
    for (const int subdivisions : {3, 4}) {
        const TriangleMesh sphere = icosphere(subdivisions);
        const Vec3 axis = Vec3(0.3, 0.5, 0.8).normalized();
        for (const double degrees : {20.0, 40.0, 60.0, 80.0}) {
            SCOPED_TRACE(std::to_string(subdivisions) + ", " + std::to_string(degrees));
            const double angle = degrees * std::numbers::pi / 180.0;
            const TriangleMesh open =
                without(sphere, [&](const Vec3& v) { return v.dot(axis) > std::cos(angle); });
            const FilledMesh result = filled(open, FillShape::Smooth);
            expectGivenComesFirst(open, result.mesh);
            const Surface surface(result.mesh);
            EXPECT_TRUE(isWatertight(surface));
            EXPECT_EQ(surface.componentCount(), 1);
            double deviation = 0.0;
            for (std::size_t v = open.vertices.size(); v < result.mesh.vertices.size(); ++v) {
                deviation = std::max(deviation, std::abs(result.mesh.vertices[v].norm() - 1.0));
            }
            EXPECT_LT(deviation, 0.02 * std::sin(angle));
            // As many faces as were taken, more or less.
            const double taken = static_cast<double>(sphere.faces.size() - open.faces.size());
            const double given = static_cast<double>(result.mesh.faces.size() - open.faces.size());
            EXPECT_GT(given, 0.6 * taken);
            EXPECT_LT(given, 1.7 * taken);
        }
    }
}

TEST(Fill, APlateGetsItsPlaneBack) {
    const TriangleMesh plate = jitteredPlate(12, 12, 0.2, 5);
    const TriangleMesh open = without(plate, [](const Vec3& v) {
        return std::abs(v.x() - 0.5) < 0.3 && std::abs(v.y() - 0.5) < 0.2;
    });
    std::vector<std::vector<int>> rims = rimsOf(open.faces);
    ASSERT_EQ(rims.size(), 2U);
    std::erase_if(rims, [](const std::vector<int>& rim) { return rim[0] == 0; });  // the outer one
    for (const FillShape shape : {FillShape::Flat, FillShape::Smooth}) {
        const FilledMesh result = fillHoles(open, rims, shape);
        EXPECT_EQ(result.mesh.vertices.size() > open.vertices.size(), shape == FillShape::Smooth);
        EXPECT_NEAR(Surface(result.mesh).area(), 1.0, 1e-12);
        for (const Vec3& vertex : result.mesh.vertices) {
            EXPECT_NEAR(vertex.z(), 0.0, 1e-12);
        }
    }
}

TEST(Fill, SmoothFacesAreWellShaped) {
    const TriangleMesh open = without(icosphere(4), [](const Vec3& v) { return v.z() > 0.6; });
    const FilledMesh result = filled(open, FillShape::Smooth);
    for (std::size_t f = open.faces.size(); f < result.mesh.faces.size(); ++f) {
        const auto& [a, b, c] = result.mesh.faces[f];
        const Vec3 &p = result.mesh.vertices[a], &q = result.mesh.vertices[b],
                   &r = result.mesh.vertices[c];
        const double longest = std::max({(p - q).norm(), (q - r).norm(), (r - p).norm()});
        EXPECT_GT((q - p).cross(r - p).norm() / (longest * longest), 0.2) << "face " << f;
    }
}

TEST(Fill, LongRimsAreFilledInTwoSteps) {
    const TriangleMesh open = openCylinder(1500, 1);
    ASSERT_EQ(rimsOf(open.faces)[0].size(), 1500U);
    const Surface surface(filled(open, FillShape::Flat).mesh);
    EXPECT_TRUE(isWatertight(surface));
    constexpr double kArea = 2.0 * std::numbers::pi + 4.0 * std::numbers::pi;
    EXPECT_NEAR(surface.area(), kArea, 1e-3);
}

TEST(Fill, MakesNoEdgeThatTheMeshHas) {
    // The lid of a box without its upper face has every edge but the diagonals; without two of its
    // faces, the rim's chord is an edge beyond.
    const TriangleMesh open = without(box(1), [](const Vec3& v) { return v.z() > 0.5; });
    EXPECT_TRUE(isWatertight(Surface(filled(open, FillShape::Flat).mesh)));
    EXPECT_TRUE(isWatertight(Surface(filled(open, FillShape::Smooth).mesh)));
    // A tetrahedron without two faces: the one chord is there already, the other is free.
    const TriangleMesh two{
        .vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
        .faces = {{0, 1, 3}, {1, 2, 3}}
    };
    EXPECT_TRUE(isWatertight(Surface(filled(two, FillShape::Flat).mesh)));
}

TEST(Fill, ClosesEveryPartOfRandomNetworks) {
    for (const TriangleMesh& mesh : {icosphere(2), torus(14, 9), box(2)}) {
        const Surface surface(mesh);
        forEachSeed(caseCount(25, 2), [&](Random& random) {
            const ImprintedMesh imprinted = imprint(surface, randomCurves(surface, random), {});
            const MeshParts parts = partsOf(imprinted);
            for (const int label : partedParts(imprinted, parts)) {
                const FilledParts result = fillAround(imprinted, parts, {label}, FillShape::Smooth);
                const Surface whole(result.mesh);
                ASSERT_TRUE(isWatertight(whole));
                ASSERT_EQ(whole.componentCount(), 1);
                ASSERT_EQ(result.openRims, 0);
            }
        });
    }
}

TEST(Fill, IsAsDenseAsTheMeshAroundACurve) {
    // Beside an imprinted curve there are many short edges, which say nothing of the mesh.
    const TriangleMesh mesh = icosphere(5);
    const CurveDesigner designer(mesh);
    SolverOptions options;
    options.closed = true;
    const std::vector<Vec3> picks{{0.6, 0, 0.8}, {0, 0.6, 0.8}, {-0.6, 0, 0.8}, {0, -0.6, 0.8}};
    const std::array lines{designer.design(picks, options).polyline};
    const ImprintedMesh imprinted = imprint(Surface(mesh), lines, {});
    const MeshParts parts = partsOf(imprinted);
    const FilledParts result = fillAround(imprinted, parts, {0}, FillShape::Smooth);
    const auto added = std::ranges::count(result.labels, -1);
    const double removed = parts.parts[1].faces;
    EXPECT_GT(static_cast<double>(added), 0.7 * removed);
    EXPECT_LT(static_cast<double>(added), 1.4 * removed);
}

TEST(Fill, NewVerticesCarryTheMeanOfTheirRim) {
    const Surface surface(icosphere(2));
    Random random(3);
    const ImprintedMesh imprinted = imprint(surface, randomCurves(surface, random), {});
    const MeshParts parts = partsOf(imprinted);
    const FilledParts result = fillAround(imprinted, parts, {0}, FillShape::Smooth);
    std::vector<double> heights;
    for (const Vec3& vertex : imprinted.mesh.vertices) {
        heights.push_back(vertex.z());
    }
    const std::vector<double> values = result.carried(heights);
    ASSERT_EQ(values.size(), result.mesh.vertices.size());
    for (std::size_t v = 0; v < values.size(); ++v) {
        if (result.source[v] >= 0) {
            EXPECT_EQ(values[v], result.mesh.vertices[v].z());
        } else {
            EXPECT_LE(std::abs(values[v]), 1.0);
            EXPECT_NE(values[v], 0.0);
        }
    }
}

TEST(Fill, RefusesWhereTheBoundaryIsPartOfTheRim) {
    const Surface surface(plate(2, 2));
    const ImprintedMesh imprinted =
        imprint(surface, std::vector{polylineAlong(surface, {1, 4, 7}, false)}, {});
    expectRefused(
        [&] { return fillAround(imprinted, partsOf(imprinted), {0}, FillShape::Flat); },
        InputErrorCode::NoPath,
        "there is no hole to fill"
    );
}

}  // namespace

}  // namespace bspline_curve
