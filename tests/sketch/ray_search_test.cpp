// SPDX-License-Identifier: GPL-3.0-or-later
// The first face that a ray meets, against a search over all faces.
#include "support/meshes.h"
#include "support/random.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

// By solving origin + t direction = a + u (b - a) + v (c - a).
double distanceTo(const TriangleMesh& mesh, const Triangle& face, const Vec3& o, const Vec3& d) {
    const Vec3& a = mesh.vertices[face[0]];
    Eigen::Matrix3d matrix;
    matrix << mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a, -d;
    const Vec3 x = matrix.fullPivLu().solve(o - a);
    const bool isInside = x[0] >= 0.0 && x[1] >= 0.0 && x[0] + x[1] <= 1.0 && x[2] >= 0.0;
    return isInside ? x[2] : std::numeric_limits<double>::infinity();
}

TEST(FirstHits, AreThoseOfASearchOverAllFaces) {
    const TriangleMesh mesh = withNoise(torus(24, 12), 0.02, 3);
    const TriangleTree tree(mesh.vertices, mesh.faces);
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Vec3 origin = random.point(-2.0, 2.0);
        const Vec3 direction = random.point(-1.2, 1.2) - origin;
        double least = std::numeric_limits<double>::infinity();
        for (const Triangle& face : mesh.faces) {
            least = std::min(least, distanceTo(mesh, face, origin, direction));
        }
        const TriangleTree::Hit hit = tree.firstHit(origin, direction);
        ASSERT_EQ(hit.point.face >= 0, std::isfinite(least));
        if (hit.point.face >= 0) {
            ++hits;
            EXPECT_NEAR(hit.distance, least, 1e-12);
            EXPECT_LT((hit.position - (origin + least * direction)).norm(), 1e-12);
            EXPECT_GE(hit.point.barycentric.minCoeff(), 0.0);
        }
    }
    EXPECT_GT(hits, 50);
}

// Through vertices and points of edges of a closed surface, from inside, also along the axes.
TEST(FirstHits, LetNoRaySlipThroughVerticesAndEdges) {
    for (const TriangleMesh& mesh : {withNoise(icosphere(2), 0.01, 5), box(4)}) {
        const TriangleTree tree(mesh.vertices, mesh.faces);
        Vec3 inside = Vec3::Zero();
        for (const Vec3& vertex : mesh.vertices) {
            inside += vertex / static_cast<double>(mesh.vertices.size());
        }
        for (const Triangle& face : mesh.faces) {
            for (int k = 0; k < 3; ++k) {
                const Vec3& a = mesh.vertices[face[k]];
                const Vec3& b = mesh.vertices[face[(k + 1) % 3]];
                for (const double s : {0.0, 0.5, 1.0 / 3.0}) {
                    const Vec3 target = a + s * (b - a);
                    EXPECT_GE(tree.firstHit(inside, target - inside).point.face, 0);
                }
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(tree.firstHit(inside, Vec3::Unit(axis)).point.face, 0);
            EXPECT_LT(tree.firstHit(10.0 * Vec3::Ones(), Vec3::Unit(axis)).point.face, 0);
        }
        EXPECT_LT(tree.firstHit(inside, Vec3::Zero()).point.face, 0);
    }
}

}  // namespace
}  // namespace bspline_curve
