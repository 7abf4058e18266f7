// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/mesh_checksum.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

TriangleMesh twoFaces() {
    return {
        .vertices = {{0, 0, 0}, {1, 0, 0}, {0.1, -2.5, 3e-7}, {1, 1, 1}},
        .faces = {{0, 1, 2}, {2, 1, 3}}
    };
}

TEST(MeshChecksum, IsTheCrcOfFloatsAndIntegers) {
    // Of zlib: crc32(faces, crc32(vertices)), as '<f4' and '<i4'.
    const MeshChecksum expected{.vertices = 4, .faces = 2, .crc32 = 0xac0af69c};
    EXPECT_EQ(checksumOf(twoFaces()), expected);
    EXPECT_EQ(checksumOf(twoFaces()).digits(), "ac0af69c");
    EXPECT_EQ(MeshChecksum{}.digits(), "00000000");
}

TEST(MeshChecksum, IsTheSameForFloatsAndDoublesAndNegativeZero) {
    TriangleMesh mesh = twoFaces();
    mesh.vertices[2].x() = static_cast<double>(0.1F);
    mesh.vertices[0].z() = -0.0;
    EXPECT_EQ(checksumOf(mesh), checksumOf(twoFaces()));
}

TEST(MeshChecksum, DiffersForEveryChange) {
    const MeshChecksum then = checksumOf(twoFaces());
    TriangleMesh moved = twoFaces();
    moved.vertices[3].y() += 1e-6;
    EXPECT_EQ(
        describeChange(then, checksumOf(moved)), "coordinates, faces or their order are others"
    );
    TriangleMesh turned = twoFaces();
    turned.faces[0] = {1, 2, 0};
    EXPECT_NE(checksumOf(turned), then);
    TriangleMesh smaller = twoFaces();
    smaller.faces.pop_back();
    EXPECT_EQ(describeChange(then, checksumOf(smaller)), "it had 2 faces then and has 1 now");
    smaller = twoFaces();
    smaller.vertices.emplace_back(5, 5, 5);
    EXPECT_EQ(describeChange(then, checksumOf(smaller)), "it had 4 vertices then and has 5 now");
}

}  // namespace
}  // namespace bspline_curve
