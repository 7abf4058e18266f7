// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check_shell.h"

#include "built_shell.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

class CheckShellOnMesh : public testing::TestWithParam<NamedMesh> {};

TEST_P(CheckShellOnMesh, PassesAtEveryThickness) {
    for (const double thickness : {0.1, 0.75, 2.0, 4.0}) {
        const BuiltShell built(GetParam().mesh, {.thickness = thickness});
        EXPECT_TRUE(built.check().passed()) << "thickness " << thickness << "\n"
                                            << describe(built.check());
        EXPECT_TRUE(built.blockedFaces().empty())
            << "thickness " << thickness << ": " << built.blockedFaces().size() << " blocked";
        EXPECT_TRUE(built.base.unseenVertices.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, CheckShellOnMesh, testing::ValuesIn(shellMeshes()), [](const auto& instance) {
        return instance.param.name;
    }
);

// Heavy noise makes folds, singular vertices and surfaces that cross themselves: faces are blocked,
// and what remains is valid.
TEST(CheckShell, PassesWhateverTheNoise) {
    int blocked = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::vector<TriangleMesh> meshes = {
            icosphere(2),
            plate(10, 10),
            torus(20, 10),
            openCylinder(14, 6),
            joined(icosphere(2), icosphere(1, 0.9))
        };
        const TriangleMesh& mesh = meshes[seed % meshes.size()];
        const double amplitude = std::pow(10.0, random.uniform(-3.0, -0.4));
        const double thickness = std::pow(10.0, random.uniform(-1.0, 0.7));
        const BuiltShell built(withNoise(mesh, amplitude, seed), {.thickness = thickness});
        EXPECT_TRUE(built.check().passed()) << describe(built.check());
        blocked += static_cast<int>(built.blockedFaces().size());
    }
    EXPECT_GT(blocked, 0);
}

// Shells with one defect each: the invariant that it breaks must say so.
class CheckShellOnDamage : public testing::Test {
protected:
    [[nodiscard]] ShellCheck check() const {
        return built_.check(Shell(pillars_, prisms_, built_.surface.faceCount()));
    }

    BuiltShell built_{torus(16, 8)};
    std::vector<Pillar> pillars_ = built_.shell().pillars();
    std::vector<Prism> prisms_ = built_.shell().prisms();
};

TEST_F(CheckShellOnDamage, PassesWithoutDamage) {
    EXPECT_TRUE(check().passed()) << describe(check());
}

TEST_F(CheckShellOnDamage, FindsAPillarUpsideDown) {
    std::swap(pillars_[5].top, pillars_[5].bottom);
    EXPECT_FALSE(check().positiveTetrahedra.holds);
    EXPECT_FALSE(check().transversalSurface.holds);
    EXPECT_TRUE(check().consistentNeighbours.holds);
}

TEST_F(CheckShellOnDamage, FindsAPillarWithoutLength) {
    pillars_[5].top = pillars_[5].middle;
    EXPECT_FALSE(check().positiveTetrahedra.holds);
}

TEST_F(CheckShellOnDamage, FindsAMiddleThatLeftTheSurface) {
    Pillar& pillar = pillars_[7];
    pillar.middle += 1e-12 * (pillar.top - pillar.middle);
    const ShellCheck result = check();
    EXPECT_FALSE(result.transversalSurface.holds);
    EXPECT_EQ(result.transversalSurface.violations, built_.surface.facesAround(7).size());
    EXPECT_TRUE(result.positiveTetrahedra.holds);
}

TEST_F(CheckShellOnDamage, FindsATwistedFlag) {
    prisms_[3].orientation = static_cast<signed char>(-prisms_[3].orientation);
    EXPECT_FALSE(check().consistentNeighbours.holds);
    EXPECT_EQ(check().consistentNeighbours.firstIds.front(), 3);
}

TEST_F(CheckShellOnDamage, FindsANeighbourThatIsNone) {
    prisms_[3].neighbours[1] = (prisms_[3].neighbours[1] + 7) % built_.surface.faceCount();
    EXPECT_FALSE(check().consistentNeighbours.holds);
    prisms_[3].neighbours[1] = 1000000;
    EXPECT_FALSE(check().consistentNeighbours.holds);
}

TEST_F(CheckShellOnDamage, FindsANeighbourOnOneSideOnly) {
    prisms_[3].neighbours[1] = -1;
    EXPECT_FALSE(check().consistentNeighbours.holds);
}

TEST_F(CheckShellOnDamage, FindsTornNeighbours) {
    Prism& here = prisms_[3];
    Prism& there = prisms_[static_cast<std::size_t>(here.neighbours[1])];
    there.neighbours[static_cast<std::size_t>(here.neighbourWalls[1])] = -1;
    here.neighbours[1] = -1;
    EXPECT_FALSE(check().consistentNeighbours.holds);
    EXPECT_EQ(check().consistentNeighbours.violations, 2);
}

TEST_F(CheckShellOnDamage, FindsAWrongWall) {
    prisms_[3].neighbourWalls[0] = static_cast<signed char>((prisms_[3].neighbourWalls[0] + 1) % 3);
    EXPECT_FALSE(check().consistentNeighbours.holds);
}

TEST_F(CheckShellOnDamage, FindsAFaceThatLostItsPrism) {
    prisms_[3].orientation = 0;
    const ShellCheck result = check();
    EXPECT_FALSE(result.completeTracking.holds);
    EXPECT_EQ(result.completeTracking.firstIds.front(), 3);
}

TEST_F(CheckShellOnDamage, FindsABlockedFaceThatHasAPrism) {
    const std::vector<int> blocked = {3};
    const ShellCheck result = checkShell(built_.surface, built_.base, built_.shell(), blocked);
    EXPECT_FALSE(result.completeTracking.holds);
    EXPECT_EQ(result.completeTracking.firstIds, blocked);
}

TEST_F(CheckShellOnDamage, FindsASurfaceOfAnotherShape) {
    const Surface other(torus(16, 8, 1.0, 0.31));
    EXPECT_FALSE(checkShell(other, built_.base, built_.shell(), built_.blockedFaces())
                     .transversalSurface.holds);
}

TEST_F(CheckShellOnDamage, ReportsAsManyIdsAsAskedFor) {
    for (Pillar& pillar : pillars_) {
        std::swap(pillar.top, pillar.bottom);
    }
    const Shell upsideDown(pillars_, prisms_, built_.surface.faceCount());
    for (const int count : {0, 5}) {
        const ShellCheck result = checkShell(
            built_.surface,
            built_.base,
            upsideDown,
            built_.blockedFaces(),
            {.maxReportedIds = count}
        );
        EXPECT_EQ(static_cast<int>(result.positiveTetrahedra.firstIds.size()), count);
        EXPECT_EQ(result.positiveTetrahedra.violations, upsideDown.tetrahedronCount());
    }
}

TEST(CheckShell, FindsATipThroughTheOppositeSheet) {
    const BuiltShell built(foldedSheet(40, 4, 0.02));
    std::vector<Pillar> pillars = built.shell().pillars();
    // A vertex in the middle of the lower sheet, whose top faces the upper one.
    const std::size_t vertex = 2 * 41 + 10;
    const Vec3 up = (pillars[vertex].top - pillars[vertex].middle).normalized();
    pillars[vertex].top = pillars[vertex].middle + 0.03 / built.surface.diagonal() * up;
    const ShellCheck result =
        built.check(Shell(pillars, built.shell().prisms(), built.surface.faceCount()));
    EXPECT_FALSE(result.separateLayers.holds);
    EXPECT_TRUE(result.positiveTetrahedra.holds);
    EXPECT_TRUE(result.transversalSurface.holds);
}

TEST(CheckShell, FindsAComponentInsideOfAnother) {
    const BuiltShell built(sphereWithSatellite());
    std::vector<Pillar> pillars = built.shell().pillars();
    for (std::size_t v = 0; v < 12; ++v) {
        pillars[v].top = pillars[v].middle + 2.0 * (pillars[v].middle - pillars[v].bottom);
    }
    const ShellCheck result =
        built.check(Shell(pillars, built.shell().prisms(), built.surface.faceCount()));
    EXPECT_FALSE(result.separateComponents.holds);
    EXPECT_TRUE(result.separateLayers.holds);
    EXPECT_TRUE(result.positiveTetrahedra.holds);
    EXPECT_GE(result.separateComponents.firstIds.front(), 12);
}

}  // namespace
}  // namespace bspline_curve
