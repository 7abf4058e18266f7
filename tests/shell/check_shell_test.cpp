// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check_shell.h"

#include "built_shell.h"
#include "support/coarse_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"

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
        SCOPED_TRACE("thickness " + std::to_string(thickness));
        const BuiltShell built(GetParam().mesh, {.thickness = thickness});
        expectWhole(built);
        EXPECT_TRUE(built.extended.unseenVertices.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, CheckShellOnMesh, testing::ValuesIn(shellMeshes()), nameOfParam);

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
        expectValid(built.check());
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
    expectValid(check());
}

TEST_F(CheckShellOnDamage, FindsAPillarUpsideDown) {
    std::swap(pillars_[5].top, pillars_[5].bottom);
    const ShellCheck result = check();
    EXPECT_FALSE(result.positiveTetrahedra.holds);
    EXPECT_FALSE(result.transversalSurface.holds);
    EXPECT_TRUE(result.consistentNeighbours.holds);
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
    Prism& there = prisms_[here.neighbours[1]];
    there.neighbours[here.neighbourWalls[1]] = -1;
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
    const ShellCheck result = checkShell(built_.surface, built_.extended, built_.shell(), blocked);
    EXPECT_FALSE(result.completeTracking.holds);
    EXPECT_EQ(result.completeTracking.firstIds, blocked);
}

TEST_F(CheckShellOnDamage, FindsASurfaceOfAnotherShape) {
    const Surface other(torus(16, 8, 1.0, 0.31));
    EXPECT_FALSE(checkShell(other, built_.extended, built_.shell(), built_.blockedFaces())
                     .transversalSurface.holds);
}

TEST_F(CheckShellOnDamage, ReportsAsManyIdsAsAskedFor) {
    for (Pillar& pillar : pillars_) {
        std::swap(pillar.top, pillar.bottom);
    }
    const Shell upsideDown(pillars_, prisms_, built_.surface.faceCount());
    for (const int count : {0, 5}) {
        const ShellCheck result =
            checkShell(built_.surface, built_.extended, upsideDown, {}, {.maxReportedIds = count});
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
    const ShellCheck result = built.checkWith(pillars);
    EXPECT_FALSE(result.separateLayers.holds);
    EXPECT_TRUE(result.positiveTetrahedra.holds);
    EXPECT_TRUE(result.transversalSurface.holds);
}

// Nothing crosses, every tetrahedron is positive, and yet two prisms hold the middle.
TEST(CheckShell, FindsABottomThatTurnedInsideOut) {
    const std::vector<Pillar> pillars = {
        {{0.36, 0.18, -0.01}, {-0.42, -0.3, 0.02}, {-0.77, -0.52, 0.04}},
        {{0, -0.08, -0.06}, {0.25, -0.34, -0.25}, {0.97, -1.09, -0.8}},
        {{-0.08, 0.02, 0.01}, {-0.42, 0.09, -0.17}, {-0.56, 0.12, -0.25}},
        {{-0.04, -0.06, -0.08}, {-0.16, -0.13, -0.46}, {-0.49, -0.34, -1.58}},
        {{-0.04, -0.06, 0.04}, {-0.12, -0.01, 0.44}, {-0.21, 0.04, 0.92}},
        {{-0.13, 0.05, 0.03}, {-0.34, 0.26, 0.12}, {-0.4, 0.33, 0.14}},
        {{-0.02, 0, 0.01}, {-0.09, 0.4, 0}, {-0.2, 1.01, -0.01}},
        {{-0.03, -0.1, 0.05}, {0.21, -0.35, 0.26}, {0.9, -1.09, 0.88}},
        {{0.01, 0.04, 0}, {0.34, 0.24, -0.05}, {1.35, 0.84, -0.2}}
    };
    TriangleMesh middle{
        .vertices = {},
        // clang-format off
        .faces = {{0, 2, 3}, {1, 3, 8}, {0, 5, 2}, {4, 8, 6}, {2, 6, 3}, {0, 3, 1}, {4, 6, 5},
                  {0, 1, 7}, {0, 7, 4}, {0, 4, 5}, {4, 7, 8}, {2, 5, 6}, {1, 8, 7}, {3, 6, 8}}
        // clang-format on
    };
    for (const Pillar& pillar : pillars) {
        middle.vertices.push_back(pillar.middle);
    }
    const Surface surface(middle);
    const ShellCheck result = checkShell(
        surface,
        extendSurface(surface, 0),
        Shell(pillars, prismsOver(surface), surface.faceCount()),
        {}
    );
    EXPECT_TRUE(result.positiveTetrahedra.holds);
    EXPECT_EQ(result.separateLayers.violations, 1);
}

TEST(CheckShell, FindsAComponentInsideOfAnother) {
    const BuiltShell built(sphereWithSatellite());
    std::vector<Pillar> pillars = built.shell().pillars();
    for (std::size_t v = 0; v < 12; ++v) {
        pillars[v].top = pillars[v].middle + 2.0 * (pillars[v].middle - pillars[v].bottom);
    }
    const ShellCheck result = built.checkWith(pillars);
    EXPECT_FALSE(result.separateComponents.holds);
    EXPECT_TRUE(result.separateLayers.holds);
    EXPECT_TRUE(result.positiveTetrahedra.holds);
    EXPECT_GE(result.separateComponents.firstIds.front(), 12);
}

}  // namespace
}  // namespace bspline_curve
