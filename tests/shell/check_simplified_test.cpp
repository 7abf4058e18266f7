// SPDX-License-Identifier: GPL-3.0-or-later
#include "built_shell.h"
#include "handmade_shell.h"
#include "shell/check_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TriangleMesh withVertexMoved(TriangleMesh mesh, int vertex, const Vec3& by) {
    mesh.vertices[vertex] += by;
    return mesh;
}

TriangleMesh shifted(const TriangleMesh& mesh, const Vec3& by, double scale = 1.0) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translation() = by;
    return transformed(mesh, motion, scale);
}

// Around the unit plate and its ghosts.
TriangleMesh widePlate(double z = 0.0) {
    return shifted(plate(3, 3, 1.5, 1.5), Vec3(-0.25, -0.25, z));
}

// Takes back that the extended surface moves what no direction sees.
void undoMoves(HandmadeShell& coarse) {
    ExtendedSurface extended = *coarse.extended;
    for (std::size_t v = 0; v < coarse.surface->vertices().size(); ++v) {
        extended.vertices[v] = extended.frame.toUnit(coarse.surface->vertices()[v]);
    }
    coarse.extended = std::make_shared<const ExtendedSurface>(extended);
    coarse.track();
}

class CheckHandmadeShell : public testing::TestWithParam<NamedHandmadeShell> {};

TEST_P(CheckHandmadeShell, PassesWithoutDamage) {
    expectValid(GetParam().make().check());
}

TEST_P(CheckHandmadeShell, FindsADroppedTrack) {
    for (const int prism : {0, 3, 11}) {
        HandmadeShell coarse = GetParam().make();
        const int face = coarse.faceInside(prism);
        ASSERT_TRUE(coarse.forget(prism, face));
        const ShellCheck check = coarse.check();
        EXPECT_EQ(brokenInvariants(check), Names{"complete tracking"});
        EXPECT_EQ(check.completeTracking.firstIds, std::vector<int>{face});
    }
}

TEST_P(CheckHandmadeShell, FindsAPillarUpsideDown) {
    HandmadeShell coarse = GetParam().make();
    std::swap(coarse.pillars[5].top, coarse.pillars[5].bottom);
    const ShellCheck check = coarse.check();
    EXPECT_FALSE(check.positiveTetrahedra.holds);
    EXPECT_TRUE(check.consistentNeighbours.holds);
}

TEST_P(CheckHandmadeShell, FindsAPillarWithoutLength) {
    HandmadeShell coarse = GetParam().make();
    coarse.pillars[5].bottom = coarse.pillars[5].middle;
    EXPECT_FALSE(coarse.check().positiveTetrahedra.holds);
}

TEST_P(CheckHandmadeShell, FindsATwistedPrism) {
    HandmadeShell coarse = GetParam().make();
    coarse.prisms[3].orientation = static_cast<signed char>(-coarse.prisms[3].orientation);
    const ShellCheck check = coarse.check();
    EXPECT_EQ(check.positiveTetrahedra.firstIds, (std::vector<int>{18, 19, 20, 21, 22, 23}));
    coarse.prisms[3].orientation = 0;
    EXPECT_FALSE(coarse.check().consistentNeighbours.holds);
    EXPECT_FALSE(coarse.check().positiveTetrahedra.holds);
}

TEST_P(CheckHandmadeShell, FindsTornNeighbours) {
    HandmadeShell coarse = GetParam().make();
    Prism& here = coarse.prisms[3];
    const auto wall = static_cast<std::size_t>(
        std::find_if(here.neighbours.begin(), here.neighbours.end(), [](int i) { return i >= 0; }) -
        here.neighbours.begin()
    );
    Prism& there = coarse.prisms[here.neighbours[wall]];
    there.neighbours[here.neighbourWalls[wall]] = -1;
    here.neighbours[wall] = -1;
    EXPECT_EQ(brokenInvariants(coarse.check()), Names{"consistent neighbours"});
}

INSTANTIATE_TEST_SUITE_P(
    Shells, CheckHandmadeShell, testing::ValuesIn(handmadeShells()), nameOfParam
);

// ---- The surface in the shell ----

TEST(CheckSimplified, FindsASurfaceThroughTheTop) {
    // A spike whose faces are transversal: the pillars are steep enough.
    const TriangleMesh fine = plate(16, 16);
    const int vertex = 8 * 17 + 8;
    const auto spike = [&](double height) {
        return HandmadeShell(
            widePlate(), withVertexMoved(fine, vertex, height * Vec3::UnitZ()), 0.2
        );
    };
    expectValid(spike(0.199).check());
    for (const double height : {0.201, -0.201}) {
        const ShellCheck check = spike(height).check();
        EXPECT_EQ(
            check.containedSurface.violations, spike(height).surface->facesAround(vertex).size()
        ) << height;
        EXPECT_TRUE(check.transversalSurface.holds);
        EXPECT_TRUE(check.positiveTetrahedra.holds);
    }
}

TEST(CheckSimplified, FindsASurfaceThatTouchesTheTop) {
    const auto raised = [](double height) {
        return HandmadeShell(
            plate(2, 2, 4.0, 4.0), shifted(plate(4, 4), Vec3(1.25, 1.5, height)), 0.25
        );
    };
    EXPECT_EQ(brokenInvariants(raised(0.125).check()), Names{});
    // The frame's centre is at the height of the plate: all numbers are exact.
    EXPECT_EQ(brokenInvariants(raised(0.25).check()), Names{"contained surface"});
}

TEST(CheckSimplified, FindsATopThatSankBelowTheSurface) {
    HandmadeShell coarse = coarseSphere();
    for (Pillar& pillar : coarse.pillars) {
        pillar.top = pillar.middle + 0.1 * (pillar.top - pillar.middle);
    }
    const ShellCheck check = coarse.check();
    EXPECT_FALSE(check.containedSurface.holds);
    EXPECT_TRUE(check.positiveTetrahedra.holds);
    EXPECT_TRUE(check.separateLayers.holds);
}

TEST(CheckSimplified, FindsAFoldedFace) {
    // A vertex pushed beyond its neighbour's ring, in the surface.
    HandmadeShell folded(
        widePlate(), withVertexMoved(plate(16, 16), 8 * 17 + 8, Vec3(0.09, 0.04, 1e-3)), 0.2
    );
    undoMoves(folded);
    const ShellCheck check = folded.check({.fibresPerPrism = 2000});
    EXPECT_FALSE(check.transversalSurface.holds);
    EXPECT_FALSE(check.singleCrossings.holds);
    EXPECT_TRUE(check.containedSurface.holds);
    EXPECT_TRUE(check.completeTracking.holds);
}

TEST(CheckSimplified, FindsAFaceAlongTheFibres) {
    // A step in a plate: vertical faces, exactly.
    TriangleMesh fine = plate(4, 4);
    for (Vec3& p : fine.vertices) {
        if (p.x() > 0.6) {
            p += Vec3(-0.25, 0.0, 0.125);
        }
    }
    HandmadeShell coarse(widePlate(), fine, 0.25);
    undoMoves(coarse);
    const ShellCheck check = coarse.check();
    // The eight of the step, and the ghosts at its two ends.
    EXPECT_EQ(check.transversalSurface.violations, 8 + 4);
    EXPECT_TRUE(check.containedSurface.holds);
}

TEST(CheckSimplified, FindsALeaningPillar) {
    // The top leans so far that the fibres beside it run along the bumps.
    HandmadeShell coarse = coarsePlate();
    for (Pillar& pillar : coarse.pillars) {
        pillar.top += Vec3(1.2, 0.0, 0.0);
    }
    const ShellCheck check = coarse.check();
    EXPECT_TRUE(check.positiveTetrahedra.holds);
    EXPECT_FALSE(check.transversalSurface.holds);
}

TEST(CheckSimplified, FindsASecondSheet) {
    // Each sheet alone is as it should be; only the fibres know.
    const TriangleMesh sphere = icosphere(3);
    const HandmadeShell coarse(icosphere(1), joined(sphere, icosphere(3, 1.03)), 0.15);
    const ShellCheck check = coarse.check();
    EXPECT_EQ(brokenInvariants(check), Names{"single crossings"});
    EXPECT_EQ(check.singleCrossings.violations, 80);
    EXPECT_TRUE(coarse.check({.fibresPerPrism = 0}).passed());
}

TEST(CheckSimplified, FindsPrismsWithoutSurface) {
    const HandmadeShell coarse(
        shifted(plate(6, 6, 6.0, 6.0), Vec3(-2.5, -2.5, 0.0)), plate(8, 8), 0.2
    );
    const ShellCheck check = coarse.check();
    EXPECT_EQ(brokenInvariants(check), Names{"single crossings"});
    EXPECT_GE(check.singleCrossings.violations, 72 - 18);
}

TEST(CheckSimplified, AllowsHolesInTheSurface) {
    TriangleMesh fine = icosphere(3);
    fine.faces.erase(fine.faces.begin() + 100, fine.faces.begin() + 104);
    expectValid(HandmadeShell(icosphere(1), fine, 0.15).check());
}

TEST(CheckSimplified, FindsASurfaceOfAnotherShape) {
    const HandmadeShell coarse = coarseTorus();
    const Surface other(displaced(torus(16, 8), 2, [](const Vec3&) { return Vec3::Zero(); }));
    EXPECT_FALSE(checkShell(other, *coarse.extended, coarse.shell(), {}).transversalSurface.holds);
}

// ---- Where the surface ends ----

TEST(CheckSimplified, FindsASurfaceThroughTheEndWalls) {
    const HandmadeShell coarse(
        shifted(plate(3, 3, 0.9, 1.5), Vec3(0.05, -0.25, 0.0)), plate(16, 16), 0.2
    );
    const ShellCheck check = coarse.check();
    EXPECT_FALSE(check.containedSurface.holds);
    EXPECT_TRUE(check.positiveTetrahedra.holds);
    EXPECT_TRUE(check.transversalSurface.holds);
}

TEST(CheckSimplified, AllowsGhostsToLeaveThroughTheEndWalls) {
    const HandmadeShell coarse(
        shifted(plate(3, 3, 1.02, 1.02), Vec3(-0.01, -0.01, 0.0)), plate(16, 16), 0.2
    );
    ASSERT_GT(coarse.extended->faces.size(), coarse.surface->faces().size());
    expectValid(coarse.check());
}

TEST(CheckSimplified, AllowsASurfaceThatEndsInTheCornersOfTheEndWalls) {
    const HandmadeShell coarse(plate(3, 3), plate(3, 3), 0.2);
    expectValid(coarse.check());
}

// ---- Layers and components ----

/// Two bumpy plates, one above the other, with a shell around each.
HandmadeShell twoSheets() {
    const auto fine = [](double z) {
        return displaced(shifted(plate(4, 4), Vec3(0.0, 0.0, z)), 2, [](const Vec3& p) {
            return Vec3(0.0, 0.0, 0.02 * std::sin(5.0 * p.x()));
        });
    };
    return {joined(widePlate(0.0), widePlate(0.3)), joined(fine(0.0), fine(0.3)), 0.1};
}

TEST(CheckSimplified, FindsATopThroughTheBottomOfAnotherSheet) {
    HandmadeShell coarse = twoSheets();
    expectValid(coarse.check());
    Pillar& pillar = coarse.pillars[5];
    pillar.top = pillar.middle + 2.5 * (pillar.top - pillar.middle);
    const ShellCheck check = coarse.check();
    EXPECT_EQ(brokenInvariants(check), Names{"separate layers"});
}

TEST(CheckSimplified, FindsAComponentInsideOfAnother) {
    const Vec3 aside = 1.1 * icosphere(1).vertices[0];
    const auto both = [&](int level) {
        return joined(icosphere(level), shifted(icosphere(level), aside, 0.02));
    };
    HandmadeShell coarse(both(1), both(2), 0.005);
    for (std::size_t v = 0; v < 42; ++v) {
        Pillar& pillar = coarse.pillars[v];
        pillar.top = pillar.middle + 50.0 * (pillar.top - pillar.middle);
        pillar.bottom = pillar.middle + 20.0 * (pillar.bottom - pillar.middle);
    }
    coarse.track();
    const ShellCheck check = coarse.check();
    EXPECT_FALSE(check.separateComponents.holds);
    EXPECT_TRUE(check.separateLayers.holds);
    EXPECT_TRUE(check.positiveTetrahedra.holds);
}

// ---- Tracks and blocked faces ----

TEST(CheckSimplified, KnowsBlockedFaces) {
    HandmadeShell coarse = coarseSphere();
    const int face = coarse.faceInside(7);
    coarse.blockedFaces = {face};
    // Blocked, yet listed.
    EXPECT_EQ(brokenInvariants(coarse.check()), Names{"complete tracking"});
    coarse.track();
    expectValid(coarse.check());
    // Not listed, yet not blocked.
    coarse.blockedFaces.clear();
    const ShellCheck check = coarse.check();
    EXPECT_EQ(brokenInvariants(check), Names{"complete tracking"});
    EXPECT_EQ(check.completeTracking.firstIds, std::vector<int>{face});
}

TEST(CheckSimplified, FindsBlockedFacesOutOfOrder) {
    HandmadeShell coarse = coarseSphere();
    coarse.blockedFaces = {5, 9};
    coarse.track();
    std::swap(coarse.blockedFaces[0], coarse.blockedFaces[1]);
    EXPECT_EQ(brokenInvariants(coarse.check()), Names{"complete tracking"});
}

TEST(CheckSimplified, FindsTracksOutOfOrder) {
    HandmadeShell coarse = coarseSphere();
    std::swap(coarse.tracks.faces[0], coarse.tracks.faces[1]);
    EXPECT_FALSE(coarse.check().completeTracking.holds);
}

TEST(CheckSimplified, ReportsAsManyIdsAsAskedFor) {
    HandmadeShell coarse = coarseSphere();
    coarse.tracks.faces.clear();
    std::fill(coarse.tracks.offsets.begin(), coarse.tracks.offsets.end(), 0);
    for (const int count : {0, 3}) {
        const ShellCheck check = coarse.check({.maxReportedIds = count});
        EXPECT_EQ(static_cast<int>(check.completeTracking.firstIds.size()), count);
        EXPECT_EQ(check.completeTracking.violations, coarse.surface->faceCount());
    }
}

}  // namespace
}  // namespace bspline_curve
