// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/designer_cache.h"

#include "bspline_curve/error.h"
#include "design/designer_surface.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A cache that says how often it had to make a designer.
class CountedCache {
public:
    explicit CountedCache(std::size_t capacity = DesignerCache::kDefaultCapacity)
        : cache_(capacity) {}

    DesignerCache::Found find(const TriangleMesh& mesh, const ShellOptions& options = {}) {
        return cache_.findOrMake(mesh, options, [&] {
            ++made_;
            return Mended<CurveDesigner>{CurveDesigner(mesh, options)};
        });
    }

    [[nodiscard]] int made() const { return made_; }

private:
    DesignerCache cache_;
    int made_ = 0;
};

TEST(DesignerCache, KeepsTheDesignerOfAMesh) {
    CountedCache cache;
    const DesignerCache::Found first = cache.find(plate(4, 4));
    const DesignerCache::Found second = cache.find(plate(4, 4));
    EXPECT_FALSE(first.isKept);
    EXPECT_TRUE(second.isKept);
    EXPECT_EQ(first.designer, second.designer);
    EXPECT_EQ(cache.made(), 1);
}

TEST(DesignerCache, MissesWhereTheLastBitOfAVertexMoved) {
    CountedCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.find(mesh));
    double& x = mesh.vertices[12].x();
    x = std::nextafter(x, 2.0);
    const DesignerCache::Found moved = cache.find(mesh);
    EXPECT_FALSE(moved.isKept);
    EXPECT_EQ(surfaceOf(*moved.designer).vertices()[12], mesh.vertices[12]);
}

TEST(DesignerCache, TellsTheSignsOfZerosApart) {
    CountedCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.find(mesh));
    mesh.vertices[3].z() = -0.0;
    EXPECT_FALSE(cache.find(mesh).isKept);
}

TEST(DesignerCache, MissesWhereAFaceWasEdited) {
    CountedCache cache;
    TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.find(mesh));
    TriangleMesh turned = mesh;
    turned.faces[5] = {turned.faces[5][1], turned.faces[5][2], turned.faces[5][0]};
    EXPECT_FALSE(cache.find(turned).isKept);
    mesh.faces.pop_back();
    EXPECT_FALSE(cache.find(mesh).isKept);
}

TEST(DesignerCache, MissesWithAnyOtherOptionOfTheShell) {
    CountedCache cache(16);
    const TriangleMesh mesh = plate(4, 4);
    static_cast<void>(cache.find(mesh));
    EXPECT_FALSE(cache.find(mesh, {.thickness = 0.5}).isKept);
    EXPECT_FALSE(cache.find(mesh, {.smoothingPasses = 2}).isKept);
    EXPECT_FALSE(cache.find(mesh, {.targetThickness = 0.1}).isKept);
    EXPECT_FALSE(cache.find(mesh, {.targetEdgeLength = 0.5}).isKept);
    EXPECT_FALSE(cache.find(mesh, {.kind = ShellKind::Simplified}).isKept);
    EXPECT_TRUE(cache.find(mesh).isKept);
    EXPECT_EQ(cache.made(), 6);
}

TEST(DesignerCache, FindsTheDesignerOfAnEditThatWasUndone) {
    CountedCache cache;
    const TriangleMesh mesh = plate(4, 4);
    TriangleMesh edited = mesh;
    edited.vertices[7].z() += 0.01;
    const DesignerCache::Found before = cache.find(mesh);
    static_cast<void>(cache.find(edited));
    const DesignerCache::Found after = cache.find(mesh);
    EXPECT_TRUE(after.isKept);
    EXPECT_EQ(before.designer, after.designer);
}

TEST(DesignerCache, GivesUpTheOneThatWasNotUsedForLongest) {
    CountedCache cache(2);
    static_cast<void>(cache.find(plate(3, 3)));
    static_cast<void>(cache.find(plate(4, 4)));
    EXPECT_TRUE(cache.find(plate(3, 3)).isKept);
    static_cast<void>(cache.find(plate(5, 5)));
    EXPECT_TRUE(cache.find(plate(3, 3)).isKept);
    EXPECT_FALSE(cache.find(plate(4, 4)).isKept);
}

TEST(DesignerCache, KeepsNothingOfAMeshThatWasRefused) {
    CountedCache cache;
    EXPECT_THROW(static_cast<void>(cache.find(bowTie())), InputError);
    EXPECT_THROW(static_cast<void>(cache.find(bowTie())), InputError);
    EXPECT_EQ(cache.made(), 2);
}

TEST(DesignerCache, WhatItGaveUpLivesOnForThoseWhoHoldIt) {
    CountedCache cache(1);
    const DesignerCache::Found first = cache.find(plate(3, 3));
    static_cast<void>(cache.find(plate(4, 4)));
    EXPECT_EQ(surfaceOf(*first.designer).faceCount(), 18);
}

}  // namespace
}  // namespace bspline_curve
