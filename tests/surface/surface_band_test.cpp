// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_band.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/index_sets.h"
#include "surface/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<int> allFaces(const Surface& surface) {
    std::vector<int> faces(at(surface.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

int boundaryEdgeCount(const Surface& surface) {
    int count = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        count += static_cast<int>(std::ranges::count(neighbours, -1));
    }
    return count;
}

// The same triangles as in the whole surface, corner by corner.
void expectPartOf(const Surface& whole, const SurfaceBand& band) {
    EXPECT_TRUE(std::ranges::is_sorted(band.faces));
    EXPECT_TRUE(std::ranges::is_sorted(band.vertices));
    std::vector<Vec3> positions;
    for (const int v : band.vertices) {
        positions.push_back(whole.vertices()[at(v)]);
    }
    EXPECT_EQ(band.surface.vertices(), positions);
    std::vector<Triangle> faces;
    std::vector<Triangle> asked;
    for (int f = 0; f < band.surface.faceCount(); ++f) {
        const Triangle& face = band.surface.faces()[at(f)];
        faces.push_back(
            {band.vertices[at(face[0])], band.vertices[at(face[1])], band.vertices[at(face[2])]}
        );
        asked.push_back(whole.faces()[at(band.faces[at(f)])]);
        EXPECT_EQ(band.indexOf(band.faces[at(f)]), f);
    }
    EXPECT_EQ(faces, asked);
}

// All faces around the vertices of some faces, ascending.
std::vector<int> ringAbout(const Surface& surface, const std::vector<int>& faces) {
    std::vector<int> ring;
    for (const int face : faces) {
        for (const int v : surface.faces()[at(face)]) {
            const Surface::FaceRange around = surface.facesAround(v);
            ring.insert(ring.end(), around.begin(), around.end());
        }
    }
    sortUnique(ring);
    return ring;
}

std::optional<InputErrorCode> codeOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.code();
    }
    return std::nullopt;
}

// ---- Cutting ----

TEST(CutBand, KeepsTheFacesAskedForInTheirOrder) {
    const Surface whole(withNoise(plate(6, 6), 0.02, 1));
    const std::vector<int> asked = {40, 16, 17, 41, 16, 28, 29};
    const SurfaceBand band = cutBand(whole, asked);
    expectPartOf(whole, band);
    EXPECT_EQ(band.faces, (std::vector<int>{16, 17, 28, 29, 40, 41}));
    EXPECT_EQ(band.indexOf(15), -1);
    EXPECT_EQ(band.indexOf(42), -1);
    EXPECT_EQ(band.surface.componentCount(), 1);
}

TEST(CutBand, GivesTheSurfaceBackForAllOfItsFaces) {
    for (const TriangleMesh& mesh : {torus(9, 7), openCylinder(8, 3), twoComponents()}) {
        const Surface whole(mesh);
        const SurfaceBand band = cutBand(whole, allFaces(whole));
        EXPECT_EQ(band.surface.vertices(), whole.vertices());
        EXPECT_EQ(band.surface.faces(), whole.faces());
    }
}

TEST(CutBand, LeavesOutVerticesWithoutFaces) {
    const Surface whole(icosphere(3));
    const SurfaceBand band = cutBand(whole, std::vector<int>{7});
    expectPartOf(whole, band);
    EXPECT_EQ(band.surface.vertexCount(), 3);
    EXPECT_EQ(boundaryEdgeCount(band.surface), 3);
}

TEST(CutBand, AddsTheFacesAroundAVertexInWhichTheRimWouldTouchItself) {
    const Surface whole(plate(4, 4));
    const int middle = 12;
    const Surface::FaceRange around = whole.facesAround(middle);
    ASSERT_GE(around.size(), 4);
    const SurfaceBand band =
        cutBand(whole, std::vector<int>{around.begin()[0], around.begin()[around.size() / 2]});
    expectPartOf(whole, band);
    EXPECT_EQ(band.faces.size(), at(around.size()));
    for (const int face : around) {
        EXPECT_GE(band.indexOf(face), 0);
    }
}

TEST(CutBand, AddsTheFacesAroundAVertexOfTheBoundaryToo) {
    const Surface whole(plate(4, 4));
    const int onBoundary = 2;
    const Surface::FaceRange around = whole.facesAround(onBoundary);
    ASSERT_GE(around.size(), 3);
    const SurfaceBand band = cutBand(whole, std::vector<int>{*around.begin(), *(around.end() - 1)});
    expectPartOf(whole, band);
    EXPECT_EQ(band.faces.size(), at(around.size()));
}

TEST(CutBand, MakesAManifoldOfAnyFaces) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Surface whole(seed % 2 == 0 ? icosphere(3) : openCylinder(24, 10));
        const double share = random.uniform(0.01, 0.9);
        std::vector<int> asked = {random.integer(0, whole.faceCount() - 1)};
        for (const int face : allFaces(whole)) {
            if (random.uniform(0.0, 1.0) < share) {
                asked.push_back(face);
            }
        }
        const SurfaceBand band = cutBand(whole, asked);  // validates the band
        expectPartOf(whole, band);
        for (const int face : asked) {
            EXPECT_GE(band.indexOf(face), 0);
        }
    }
}

TEST(CutBand, KeepsAStripRoundAHandleOpen) {
    const Surface whole(torus(24, 12));
    std::vector<int> strip;
    for (const int face : allFaces(whole)) {
        const std::vector<Vec3>& p = whole.vertices();
        const Triangle& t = whole.faces()[at(face)];
        const Vec3 centre = (p[at(t[0])] + p[at(t[1])] + p[at(t[2])]) / 3.0;
        if (centre.x() > 0.0 && std::abs(centre.y()) < 0.3) {
            strip.push_back(face);
        }
    }
    const SurfaceBand band = cutBand(whole, strip);
    EXPECT_EQ(band.faces, strip);
    EXPECT_EQ(band.surface.componentCount(), 1);
    // Vertices - edges + faces of an annulus.
    const int edges = (3 * band.surface.faceCount() + boundaryEdgeCount(band.surface)) / 2;
    EXPECT_EQ(band.surface.vertexCount() - edges + band.surface.faceCount(), 0);
}

TEST(CutBand, RefusesFacesThatAreNotThere) {
    const Surface whole(icosphere(1));
    const auto refusal = [&](const std::vector<int>& faces) {
        return codeOf([&] { static_cast<void>(cutBand(whole, faces)); });
    };
    EXPECT_EQ(refusal({}), InputErrorCode::EmptyMesh);
    EXPECT_EQ(refusal({0, -1}), InputErrorCode::IndexOutOfRange);
    EXPECT_EQ(refusal({whole.faceCount()}), InputErrorCode::IndexOutOfRange);
    EXPECT_EQ(refusal({0, whole.faceCount() - 1}), std::nullopt);
}

// ---- Faces near a path ----

TEST(FacesNear, FindsTheWantedNumberNearerOnesFirst) {
    const Surface surface(withNoise(torus(30, 14), 0.01, 3));
    const std::vector<int> path = {100, 101, 102, 103};
    std::vector<int> before = facesNear(surface, path, 1);
    EXPECT_EQ(before, path);
    for (const int count : {5, 20, 100, 400}) {
        const std::vector<int> found = facesNear(surface, path, count);
        EXPECT_EQ(found.size(), at(count));
        EXPECT_TRUE(std::ranges::is_sorted(found));
        EXPECT_TRUE(std::ranges::includes(found, before)) << "nearer faces come first";
        before = found;
    }
}

TEST(FacesNear, FindsWholeRingsOneAfterTheOther) {
    const Surface surface(withNoise(torus(30, 14), 0.01, 3));
    const std::vector<int> path = {100, 101, 102, 103};
    const std::vector<int> first = ringAbout(surface, path);
    const std::vector<int> second = ringAbout(surface, first);
    EXPECT_EQ(facesNear(surface, path, static_cast<int>(first.size())), first);
    EXPECT_EQ(facesNear(surface, path, static_cast<int>(second.size())), second);
}

TEST(FacesNear, StaysOnTheComponentsOfThePath) {
    const Surface surface(twoComponents());
    EXPECT_EQ(facesNear(surface, std::vector<int>{3}, 1000).size(), 80U);
    EXPECT_EQ(facesNear(surface, std::vector<int>{3, 100}, 1000).size(), 160U);
    const std::vector<int> few = facesNear(surface, std::vector<int>{3, 100}, 40);
    EXPECT_LT(few.front(), 80);
    EXPECT_GE(few.back(), 80);
}

TEST(FacesNear, RefusesBadPathsAndCounts) {
    const Surface surface(icosphere(1));
    const auto refusal = [&](const std::vector<int>& path, int count) {
        return codeOf([&] { static_cast<void>(facesNear(surface, path, count)); });
    };
    EXPECT_EQ(refusal({}, 5), InputErrorCode::EmptyMesh);
    EXPECT_EQ(refusal({-1}, 5), InputErrorCode::IndexOutOfRange);
    EXPECT_EQ(refusal({surface.faceCount()}, 5), InputErrorCode::IndexOutOfRange);
    EXPECT_EQ(refusal({0}, 0), InputErrorCode::BadOption);
    EXPECT_EQ(refusal({0}, -3), InputErrorCode::BadOption);
    EXPECT_EQ(refusal({0}, 5), std::nullopt);
}

}  // namespace
}  // namespace bspline_curve
