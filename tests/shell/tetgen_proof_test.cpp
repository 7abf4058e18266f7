// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetgen_proof.h"

#include "built_shell.h"
#include "handmade_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

using namespace test_support;

TetgenProof prove(const HandmadeShell& coarse) {
    return proveWithTetgen(coarse.shell(), *coarse.extended, coarse.blockedFaces);
}

class ProvenHandmadeShell : public testing::TestWithParam<NamedHandmadeShell> {};

TEST_P(ProvenHandmadeShell, HasLayersThatDoNotMeet) {
    const TetgenProof proof = prove(GetParam().make());
    EXPECT_TRUE(proof.holds()) << proof;
}

INSTANTIATE_TEST_SUITE_P(
    Shells, ProvenHandmadeShell, testing::ValuesIn(handmadeShells()), nameOfParam
);

class ProvenShell : public testing::TestWithParam<NamedMesh> {};

TEST_P(ProvenShell, HasLayersThatDoNotMeet) {
    const BuiltShell built(GetParam().mesh);
    const TetgenProof proof = proveWithTetgen(built.shell(), built.extended, built.blockedFaces());
    EXPECT_TRUE(proof.holds()) << proof;
}

INSTANTIATE_TEST_SUITE_P(Meshes, ProvenShell, testing::ValuesIn(shellMeshes()), nameOfParam);

TEST(TetgenProof, HoldsForFifteenThousandFaces) {
    const TriangleMesh middle = torus(30, 16);
    const HandmadeShell coarse(
        middle, displaced(middle, 2, [](const Vec3& p) -> Vec3 { return 0.002 * p; }), 0.05
    );
    ASSERT_EQ(coarse.surface->faceCount(), 15360);
    const TetgenProof proof = prove(coarse);
    EXPECT_TRUE(proof.holds()) << proof;
}

TEST(TetgenProof, FailsWhereTheSurfacePassesTheTop) {
    HandmadeShell coarse = coarseSphere();
    for (Pillar& pillar : coarse.pillars) {
        pillar.top = pillar.middle + 0.1 * (pillar.top - pillar.middle);
    }
    EXPECT_FALSE(coarse.check().containedSurface.holds);
    const TetgenProof proof = prove(coarse);
    EXPECT_GT(proof.intersectingFaces, 0);
    EXPECT_FALSE(proof.holds());
}

TEST(TetgenProof, FailsWhereOnePillarPassesTheOtherSheet) {
    HandmadeShell coarse(parallelPlates(3, 0.3), parallelPlates(3, 0.3), 0.1);
    EXPECT_TRUE(prove(coarse).holds()) << prove(coarse);
    Pillar& pillar = coarse.pillars[5];
    pillar.top = pillar.middle + 2.5 * (pillar.top - pillar.middle);
    EXPECT_GT(prove(coarse).intersectingFaces, 0);
}

// The exact predicates must be as they were.
TEST(TetgenProof, LeavesThePredicatesAlone) {
    const HandmadeShell coarse = coarseTorus();
    const ShellCheck before = coarse.check();
    EXPECT_TRUE(prove(coarse).holds());
    const ShellCheck after = coarse.check();
    EXPECT_TRUE(before.passed());
    EXPECT_TRUE(after.passed());
}

}  // namespace
}  // namespace bspline_curve
