// SPDX-License-Identifier: GPL-3.0-or-later
// Simplified shells of random meshes with random options, each checked by means that share nothing
// with the simplifier.
#include "built_shell.h"
#include "random_mesh.h"
#include "support/many_cases.h"
#include "support/random.h"
#include "tetgen_proof.h"
#include "tetrahedra/facet_complex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kMeshesPerKind = caseCount(6, 2);

ShellOptions randomOptions(Random& random) {
    return {
        .smoothingPasses = random.integer(0, 4),
        .targetThickness = std::exp(random.uniform(std::log(0.01), std::log(0.5))),
        .targetEdgeLength = std::exp(random.uniform(std::log(0.02), 0.0))
    };
}

enum class Proof { Given, TooHardForTetgen };

Proof expectValidShell(RandomKind kind, std::uint64_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const SimplifiedShell simplified(randomMesh(kind, seed), randomOptions(random));
    expectValid(simplified.check());
    const std::vector<int>& blocked = simplified.build.report.blockedFaces;
    if (shortestTetgenEdge(simplified.shell(), simplified.extended, blocked) < kLeastTetgenEdge) {
        return Proof::TooHardForTetgen;
    }
    const TetgenProof proof = proveWithTetgen(simplified.shell(), simplified.extended, blocked);
    EXPECT_TRUE(proof.holds()) << proof;
    return Proof::Given;
}

class SimplifiedRandomMesh : public testing::TestWithParam<RandomKind> {};

TEST_P(SimplifiedRandomMesh, HoldsEveryInvariant) {
    int proven = 0;
    for (std::uint64_t seed = 1; seed <= kMeshesPerKind; ++seed) {
        proven += static_cast<int>(expectValidShell(GetParam(), seed) == Proof::Given);
    }
    EXPECT_GE(2 * proven, kMeshesPerKind);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, SimplifiedRandomMesh, testing::ValuesIn(kRandomKinds), [](const auto& instance) {
        return nameOf(instance.param);
    }
);

// A small torus whose bottom could leap through itself.
TEST(SimplifiedTorus, KeepsItsBottomRightSideOut) {
    EXPECT_EQ(expectValidShell(RandomKind::SeveralPieces, 41), Proof::Given);
}

}  // namespace
}  // namespace bspline_curve
