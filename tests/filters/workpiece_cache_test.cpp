// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/workpiece_cache.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(WorkpieceCache, KeepsTheWorkpieceOfAMesh) {
    WorkpieceCache cache;
    const WorkpieceCache::Found first = cache.findOrMake(plate(4, 4), {});
    const WorkpieceCache::Found second = cache.findOrMake(plate(4, 4), {});
    EXPECT_FALSE(first.isKept);
    EXPECT_TRUE(second.isKept);
    EXPECT_EQ(first.workpiece, second.workpiece);
}

TEST(WorkpieceCache, MissesWhereTheLastBitOfAVertexMoved) {
    WorkpieceCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.findOrMake(mesh, {}));
    double& x = mesh.vertices[12].x();
    x = std::nextafter(x, 2.0);
    const WorkpieceCache::Found moved = cache.findOrMake(mesh, {});
    EXPECT_FALSE(moved.isKept);
    EXPECT_EQ(moved->mendedMesh().vertices[12], mesh.vertices[12]);
}

TEST(WorkpieceCache, TellsTheSignsOfZerosApart) {
    WorkpieceCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.findOrMake(mesh, {}));
    mesh.vertices[3].z() = -0.0;
    EXPECT_FALSE(cache.findOrMake(mesh, {}).isKept);
}

TEST(WorkpieceCache, MissesWhereAFaceWasEdited) {
    WorkpieceCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.findOrMake(mesh, {}));
    TriangleMesh turned = mesh;
    turned.faces[5] = {turned.faces[5][1], turned.faces[5][2], turned.faces[5][0]};
    EXPECT_FALSE(cache.findOrMake(turned, {}).isKept);
    mesh.faces.pop_back();
    EXPECT_FALSE(cache.findOrMake(mesh, {}).isKept);
}

TEST(WorkpieceCache, MissesWithAnyOtherOptionOfTheShell) {
    WorkpieceCache cache(16);
    const TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.findOrMake(mesh, {}));
    EXPECT_FALSE(cache.findOrMake(mesh, {.shell = {.thickness = 0.5}}).isKept);
    EXPECT_FALSE(cache.findOrMake(mesh, {.shell = {.smoothingPasses = 2}}).isKept);
    EXPECT_FALSE(cache.findOrMake(mesh, {.shell = {.targetThickness = 0.1}}).isKept);
    EXPECT_FALSE(cache.findOrMake(mesh, {.shell = {.targetEdgeLength = 0.5}}).isKept);
    EXPECT_FALSE(cache.findOrMake(mesh, {.shell = {.kind = ShellKind::Simplified}}).isKept);
    EXPECT_TRUE(cache.findOrMake(mesh, {}).isKept);
}

TEST(WorkpieceCache, FindsTheWorkpieceOfAnEditThatWasUndone) {
    WorkpieceCache cache;
    const TriangleMesh mesh = plate(4, 4);
    TriangleMesh edited = mesh;
    edited.vertices[7].z() += 0.01;
    const WorkpieceCache::Found before = cache.findOrMake(mesh, {});
    static_cast<void>(cache.findOrMake(edited, {}));
    const WorkpieceCache::Found after = cache.findOrMake(mesh, {});
    EXPECT_TRUE(after.isKept);
    EXPECT_EQ(before.workpiece, after.workpiece);
}

TEST(WorkpieceCache, GivesUpTheOneThatWasNotUsedForLongest) {
    WorkpieceCache cache(2);
    static_cast<void>(cache.findOrMake(plate(3, 3), {}));
    static_cast<void>(cache.findOrMake(plate(4, 4), {}));
    EXPECT_TRUE(cache.findOrMake(plate(3, 3), {}).isKept);
    static_cast<void>(cache.findOrMake(plate(5, 5), {}));
    EXPECT_TRUE(cache.findOrMake(plate(3, 3), {}).isKept);
    EXPECT_FALSE(cache.findOrMake(plate(4, 4), {}).isKept);
}

TEST(WorkpieceCache, KeepsNothingOfAMeshThatWasRefused) {
    WorkpieceCache cache;
    const PreparingOptions strict{.mending = {.strict = true}};
    EXPECT_THROW(static_cast<void>(cache.findOrMake(bowTie(), strict)), InputError);
    EXPECT_FALSE(cache.findOrMake(bowTie(), {}).isKept);
    EXPECT_THROW(static_cast<void>(cache.findOrMake(bowTie(), strict)), InputError);
    EXPECT_TRUE(cache.findOrMake(bowTie(), {}).isKept);
}

TEST(WorkpieceCache, WhatItGaveUpLivesOnForThoseWhoHoldIt) {
    WorkpieceCache cache(1);
    const WorkpieceCache::Found first = cache.findOrMake(plate(3, 3), {});
    static_cast<void>(cache.findOrMake(plate(4, 4), {}));
    EXPECT_EQ(first->mendedMesh().faces.size(), 18U);
}

}  // namespace
}  // namespace bspline_curve
