// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface crosses itself, face by face: the same as all at once.
#include "surface/face_crossings.h"

#include "support/meshes.h"
#include "surface/self_intersection.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

std::set<int> crossingFaces(const Surface& surface) {
    std::set<int> faces;
    for (const auto& [f, g] : findSelfIntersections(surface.vertices(), surface.faces())) {
        faces.insert(f);
        faces.insert(g);
    }
    return faces;
}

void expectSameAsAllAtOnce(TriangleMesh mesh, bool hasAny) {
    const Surface surface(std::move(mesh));
    const TriangleTree tree(surface.vertices(), surface.faces());
    const FaceCrossings crossings(surface, tree);
    const std::set<int> expected = crossingFaces(surface);
    EXPECT_EQ(!expected.empty(), hasAny);
    for (int again = 0; again < 2; ++again) {
        for (int f = 0; f < surface.faceCount(); ++f) {
            EXPECT_EQ(crossings.hasCrossing(f), expected.contains(f)) << "face " << f;
        }
    }
}

TEST(FaceCrossings, AreNoneOnASphere) {
    expectSameAsAllAtOnce(icosphere(3), false);
}

// So noisy that neighbours fold onto each other and through their next ones.
TEST(FaceCrossings, AreThoseOfACrumpledSphere) {
    expectSameAsAllAtOnce(withNoise(icosphere(3), 0.12, 7), true);
}

TEST(FaceCrossings, AreThoseBetweenComponents) {
    TriangleMesh mesh = icosphere(2);
    const int count = static_cast<int>(mesh.vertices.size());
    const TriangleMesh other = icosphere(2);
    for (const Vec3& vertex : other.vertices) {
        mesh.vertices.emplace_back(vertex + Vec3(0.7, 0.2, 0.1));
    }
    for (const Triangle& face : other.faces) {
        mesh.faces.push_back({face[0] + count, face[1] + count, face[2] + count});
    }
    expectSameAsAllAtOnce(std::move(mesh), true);
}

}  // namespace
}  // namespace bspline_curve
