// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_builder.h"

#include "bspline_curve/error.h"
#include "built_shell.h"
#include "shell/face_geometry.h"
#include "shell/pillar_directions.h"
#include "shell/projection_stretch.h"
#include "shell/shell_boundary.h"
#include "support/meshes.h"
#include "surface/self_intersection.h"
#include "utility/index_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- Thickness ----

TEST(ShellBuilder, MakesPillarsAsLongAsAskedWhereNothingIsInTheWay) {
    const BuiltShell built(plate(6, 5), {.thickness = 0.75});
    for (int v = 0; v < built.surface.vertexCount(); ++v) {
        const Pillar& pillar = built.shell().pillars()[v];
        const double wanted = 0.75 * built.extended.edgeLengths[v];
        EXPECT_NEAR((pillar.top - pillar.middle).norm(), wanted, 1e-15);
        EXPECT_NEAR((pillar.bottom - pillar.middle).norm(), wanted, 1e-15);
    }
}

// With pillars as long as is asked projections stretch some of these by up to 7,000.
TEST(ShellBuilder, ShortensPillarsWhereProjectionsWouldLoseDigits) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const BuiltShell built(withNoise(icosphere(3), 0.1, seed));
        double largest = 0.0;
        for (const Prism& prism : built.shell().prisms()) {
            if (prism.orientation == 0) {
                continue;
            }
            std::array<Pillar, 3> pillars;
            for (std::size_t k = 0; k < 3; ++k) {
                pillars[k] = built.shell().pillars()[prism.pillars[k]];
            }
            const Gram face = gramOf(
                pillars[1].middle - pillars[0].middle, pillars[2].middle - pillars[0].middle
            );
            for (const std::size_t slab : {0U, 1U}) {
                const auto grams = gramsOf(pillars, fibresOf(pillars, slab), slab);
                largest = std::max(largest, largestStretch(grams, face));
            }
        }
        EXPECT_LE(largest, kMostStretch) << "seed " << seed;
        EXPECT_GT(largest, 0.5 * kMostStretch) << "seed " << seed;
        expectValid(built.check());
    }
}

TEST(ShellBuilder, SeparatesParallelPlates) {
    for (const double gap : {0.5, 0.02, 1e-5}) {
        for (const int cells : {3, 24}) {
            SCOPED_TRACE("gap " + std::to_string(gap) + ", cells " + std::to_string(cells));
            const BuiltShell built(parallelPlates(cells, gap));
            expectWhole(built);
            const int half = built.surface.vertexCount() / 2;
            double highestBelow = -1.0;
            double lowestAbove = 1.0;
            for (int v = 0; v < half; ++v) {
                highestBelow = std::max(highestBelow, built.shell().pillars()[v].top.z());
                lowestAbove = std::min(lowestAbove, built.shell().pillars()[half + v].bottom.z());
            }
            EXPECT_LT(highestBelow, lowestAbove);
            // Most of the gap is used, or all that was asked for.
            const double unitGap = gap / built.surface.diagonal();
            EXPECT_GT(
                built.shell().pillars()[0].top.z() - built.shell().pillars()[0].middle.z(),
                std::min(0.3 * unitGap, 0.7 * built.extended.edgeLengths[0])
            );
        }
    }
}

TEST(ShellBuilder, SeparatesAFineSheetOverACoarseOne) {
    // The fine sheet fits between the pillars of the coarse one.
    Eigen::Isometry3d above = Eigen::Isometry3d::Identity();
    above.translation() = Vec3(0.4, 0.32, 0.02);
    const BuiltShell built(joined(plate(2, 2), transformed(plate(5, 5), above, 0.03)));
    expectWhole(built);
}

TEST(ShellBuilder, SeparatesAComponentInsideOfAPrism) {
    const BuiltShell built(sphereWithSatellite());
    expectWhole(built);
    // The slab of face 0 ends below the satellite; elsewhere it is as thick as ever.
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    for (int v = 0; v < 12; ++v) {
        const Pillar& pillar = built.shell().pillars()[v];
        const double length = (pillar.top - pillar.middle).norm() / built.extended.edgeLengths[v];
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    EXPECT_LT(shortest, 0.4);
    EXPECT_NEAR(longest, 0.75, 1e-12);
}

// The bottom of the outer sphere would lie between the middle of the inner one and its top, and
// nothing would cross.
TEST(ShellBuilder, SeparatesConcentricSpheres) {
    const TriangleMesh inner = transformed(icosphere(3), Eigen::Isometry3d::Identity(), 0.9);
    const BuiltShell built(joined(icosphere(3), inner), {.thickness = 0.5});
    expectWhole(built);
    double lowest = 1.0;
    double highest = 0.0;
    const int half = built.surface.vertexCount() / 2;
    for (int v = 0; v < half; ++v) {
        const Pillar& outerPillar = built.shell().pillars()[v];
        const Pillar& innerPillar = built.shell().pillars()[half + v];
        const double gap = (outerPillar.middle - innerPillar.middle).norm();
        lowest = std::min(lowest, (outerPillar.bottom - innerPillar.middle).norm() / gap);
        highest = std::max(highest, (innerPillar.top - innerPillar.middle).norm() / gap);
    }
    EXPECT_LT(highest, lowest);
}

// A cone of needles, whose pillars are longer than the cone is wide: as they shrink by halves its
// bottom can leap through itself, and then crosses nothing.
TEST(ShellBuilder, TurnsNoBottomInsideOut) {
    constexpr int kNeedles = 500;
    TriangleMesh cone{{{0, 0, -1.5}, {0, 0, 1.5}}, {}};
    for (int i = 0; i < kNeedles; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kNeedles;
        cone.vertices.emplace_back(std::cos(angle), std::sin(angle), -1.5);
        const int here = 2 + i;
        const int next = 2 + (i + 1) % kNeedles;
        cone.faces.push_back({0, next, here});
        cone.faces.push_back({1, here, next});
    }
    const BuiltShell built(cone);
    expectWhole(built);
}

TEST(ShellBuilder, LeavesFoldedSheetsAndFlatBoxesWhole) {
    std::vector<TriangleMesh> meshes;
    for (const double gap : {0.2, 0.02, 0.002}) {
        meshes.push_back(foldedSheet(11, 5, gap));
        meshes.push_back(foldedSheet(60, 5, gap));
    }
    for (const double height : {0.1, 0.01, 1e-4}) {
        meshes.push_back(box(24, Vec3(1.0, 1.0, height)));
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        SCOPED_TRACE("mesh " + std::to_string(i));
        expectWhole(BuiltShell(meshes[i]));
    }
}

// ---- Blocked faces ----

// In the shell's frame: faces that just touch may come apart by rounding.
std::vector<int> crossingFaces(const BuiltShell& built) {
    std::vector<int> faces;
    for (const auto& [f, g] :
         findSelfIntersections(built.extended.vertices, built.surface.faces())) {
        faces.insert(faces.end(), {f, g});
    }
    sortUnique(faces);
    return faces;
}

TEST(ShellBuilder, BlocksTheFacesWhereTheSurfaceCrossesItselfAndReportsThem) {
    for (const int level : {0, 1, 2}) {
        TriangleMesh mesh = crossingPlates();
        for (int i = 0; i < level; ++i) {
            mesh = midpointSubdivide(mesh);
        }
        SCOPED_TRACE("subdivisions " + std::to_string(level));
        const BuiltShell built(mesh);
        const std::vector<int> crossing = crossingFaces(built);
        EXPECT_EQ(built.blockedFaces(), crossing);
        EXPECT_EQ(
            built.build.report.selfIntersections,
            findSelfIntersections(built.extended.vertices, built.surface.faces())
        );
        expectValid(built.check());
    }
}

TEST(ShellBuilder, BlocksFacesThatOnlyJustCross) {
    // A cone whose tip pierces a plate by little: no layers of theirs need to cross there.
    const TriangleMesh cone{
        .vertices = {{0.52, 0.51, -0.001}, {0.3, 0.3, 0.9}, {0.8, 0.35, 0.9}, {0.5, 0.8, 0.9}},
        .faces = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}}
    };
    const BuiltShell built(joined(plate(4, 4), cone));
    const std::vector<int> crossing = crossingFaces(built);
    EXPECT_GE(crossing.size(), 4U);
    EXPECT_EQ(built.blockedFaces(), crossing);
    expectValid(built.check());
}

TEST(ShellBuilder, BlocksSheetsThatLieOnEachOther) {
    const BuiltShell built(parallelPlates(4, 0.0));
    EXPECT_EQ(static_cast<int>(built.blockedFaces().size()), built.surface.faceCount());
    expectValid(built.check());
}

TEST(ShellBuilder, LetsGhostsGiveWayToTheSurface) {
    // The edge of the first plate ends just before the second one: its ghosts would cross it.
    Eigen::Isometry3d upright(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
    upright.pretranslate(Vec3(1.02, 0.0, 0.47));
    const BuiltShell built(joined(plate(4, 4), transformed(plate(4, 4), upright)));
    expectWhole(built);
    const auto& prisms = built.shell().prisms();
    EXPECT_TRUE(std::any_of(prisms.begin() + built.surface.faceCount(), prisms.end(), [](auto& p) {
        return p.orientation == 0;
    }));
}

// ---- Singular vertices ----

// How well the best direction sees the faces around a vertex.
double greatestLeastCosine(const Surface& surface, int vertex) {
    std::vector<Vec3> normals;
    for (const int f : surface.facesAround(vertex)) {
        normals.push_back(surface.faceNormal(f));
    }
    return leastCosine(directionOfLeastAngle(normals), normals);
}

TEST(ExtendedSurface, MovesASingularVertexUntilADirectionExists) {
    const BuiltShell built(plateWithSingularVertex());
    ASSERT_LT(greatestLeastCosine(built.surface, 4 * 9 + 4), kLeastPillarCosine);
    EXPECT_FALSE(built.extended.movedVertices.empty());
    EXPECT_TRUE(built.extended.unseenVertices.empty());
    expectWhole(built);
    for (int f = 0; f < built.surface.faceCount(); ++f) {
        const Vec3 normal = areaNormal(built.extended, f).normalized();
        for (const int v : built.extended.faces[f]) {
            EXPECT_GT(normal.dot(built.extended.directions[v]), 0.99 * kLeastPillarCosine);
        }
    }
}

TEST(ExtendedSurface, NamesTheVerticesThatGetNoDirection) {
    const BuiltShell built(tennisBallVertex());
    ASSERT_LT(greatestLeastCosine(built.surface, 0), 0.0);
    EXPECT_EQ(built.extended.unseenVertices, std::vector<int>{0});
    EXPECT_EQ(static_cast<int>(built.blockedFaces().size()), built.surface.faceCount());
    expectValid(built.check());
}

TEST(ExtendedSurface, MovesNothingElse) {
    const BuiltShell built(plateWithSingularVertex());
    const std::vector<int>& moved = built.extended.movedVertices;
    EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
    for (int v = 0; v < built.surface.vertexCount(); ++v) {
        const bool hasMoved =
            built.extended.vertices[v] != built.extended.frame.toUnit(built.surface.vertices()[v]);
        EXPECT_TRUE(!hasMoved || std::binary_search(moved.begin(), moved.end(), v))
            << "vertex " << v;
    }
    EXPECT_TRUE(BuiltShell(box(4)).extended.movedVertices.empty());
}

// ---- Ghosts ----

TEST(ExtendedSurface, GrowsGhostsBeyondEveryBoundaryEdge) {
    for (const auto& [mesh, boundaryEdges] :
         {std::pair(plate(6, 5), 22), {openCylinder(16, 5), 32}, {icosphere(1), 0}}) {
        const BuiltShell built(mesh);
        const ExtendedSurface& extended = built.extended;
        EXPECT_EQ(extended.surfaceVertexCount, built.surface.vertexCount());
        EXPECT_EQ(extended.surfaceFaceCount, built.surface.faceCount());
        EXPECT_EQ(static_cast<int>(extended.ghostSource.size()), boundaryEdges);
        EXPECT_EQ(
            static_cast<int>(extended.faces.size()), built.surface.faceCount() + 2 * boundaryEdges
        );
        for (int f = 0; f < built.surface.faceCount(); ++f) {
            EXPECT_FALSE(built.shell().isGhost(f));
            for (std::size_t k = 0; k < 3; ++k) {
                if (built.surface.faceNeighbours()[f][k] < 0) {
                    EXPECT_GE(extended.faceNeighbours[f][k], built.surface.faceCount());
                }
            }
        }
    }
}

TEST(ExtendedSurface, CollapsesGhostsToTheBoundary) {
    const BuiltShell built(withNoise(openCylinder(16, 5), 0.03, 7));
    const ExtendedSurface& extended = built.extended;
    for (int v = 0; v < static_cast<int>(extended.vertices.size()); ++v) {
        const int origin = extended.surfaceVertex(v);
        if (v < extended.surfaceVertexCount) {
            EXPECT_EQ(origin, v);
        } else {
            EXPECT_TRUE(built.surface.isBoundaryVertex(origin));
            EXPECT_NEAR(
                (extended.vertices[v] - extended.vertices[origin]).norm(),
                0.5 * extended.edgeLengths[origin],
                1e-12
            );
        }
    }
    for (std::size_t f = extended.surfaceFaceCount; f < extended.faces.size(); ++f) {
        std::set<int> origins;
        for (const int v : extended.faces[f]) {
            origins.insert(extended.surfaceVertex(v));
        }
        EXPECT_EQ(origins.size(), 2U) << "ghost face " << f;
    }
}

// ---- The boundary of a shell ----

TEST(ShellBoundary, FindsTheNearestPointOfTopAndBottom) {
    const BuiltShell built(icosphere(2));
    const ShellBoundary boundary(built.shell());
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0.3, -0.7, 0.2), Vec3(-1, 1, 1)}) {
        const Vec3 outside = 3.0 * direction.normalized();
        const ShellBoundary::Nearest above = boundary.nearest(outside);
        const ShellCell cell(built.shell(), above.tet);
        EXPECT_NEAR(cell.insideness(above.position), 0.0, 1e-12);
        EXPECT_NEAR(cell.height.at(above.position), 1.0, 1e-12);
        const ShellBoundary::Nearest below = boundary.nearest(1e-3 * direction);
        EXPECT_NEAR(ShellCell(built.shell(), below.tet).height.at(below.position), -1.0, 1e-12);
    }
}

TEST(ShellBoundary, KnowsNoBlockedPrisms) {
    const BuiltShell built(crossingPlates());
    const ShellBoundary boundary(built.shell());
    const std::vector<int>& blocked = built.blockedFaces();
    ASSERT_FALSE(blocked.empty());
    for (const int f : blocked) {
        const ShellBoundary::Nearest nearest =
            boundary.nearest(built.extended.position({f, Vec3::Constant(1.0 / 3.0)}));
        EXPECT_FALSE(
            std::binary_search(blocked.begin(), blocked.end(), nearest.tet / kTetrahedraPerPrism)
        );
    }
}

// ---- The same again ----

TEST(ShellBuilder, BuildsTheSameShellTwice) {
    for (const NamedMesh& named : shellMeshes()) {
        SCOPED_TRACE(named.name);
        const BuiltShell first(named.mesh);
        const BuiltShell second(named.mesh);
        EXPECT_TRUE(areSame(first.shell(), second.shell()));
    }
}

TEST(ShellBuilder, StopsWhereItIsCancelled) {
    const Surface surface(icosphere(2));
    const ExtendedSurface extended = extendSurface(surface, 3);
    EXPECT_THROW(
        static_cast<void>(buildShell(extended, {}, [](double, const char*) { return false; })),
        Cancelled
    );
}

// ---- Options ----

TEST(ShellOptions, RefusesValuesOutOfRange) {
    const auto codeOf = [](const ShellOptions& options) {
        try {
            options.validate();
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("must"), std::string::npos) << error.what();
            return error.code();
        }
        ADD_FAILURE() << "accepted thickness " << options.thickness << ", smoothing passes "
                      << options.smoothingPasses;
        return InputErrorCode::EmptyMesh;
    };
    for (const double thickness :
         {0.0, -1.0, 1001.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(codeOf({.thickness = thickness}), InputErrorCode::BadOption);
    }
    EXPECT_EQ(codeOf({.smoothingPasses = -1}), InputErrorCode::BadOption);
    EXPECT_NO_THROW(ShellOptions().validate());
    EXPECT_NO_THROW((ShellOptions{.thickness = 0.01, .smoothingPasses = 0}.validate()));
}

TEST(ShellBuilder, RefusesBadOptions) {
    const Surface surface(plate(2, 2));
    const ExtendedSurface extended = extendSurface(surface, 3);
    EXPECT_THROW(static_cast<void>(buildShell(extended, {.thickness = -1.0})), InputError);
}

}  // namespace
}  // namespace bspline_curve
