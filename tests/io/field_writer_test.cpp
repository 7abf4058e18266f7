// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

namespace bspline_curve::io_tests {

namespace {

class FieldWriter : public FileTest {};

const TriangleMesh kMesh = test_support::icosphere(1);

std::vector<double> awkwardField() {
    std::vector<double> field;
    for (std::size_t i = 0; i < kMesh.vertices.size(); ++i) {
        field.push_back((i % 2 == 0 ? 1.0 : -1.0) / (3.0 + static_cast<double>(i)) * 1e-200);
    }
    return field;
}

}  // namespace

TEST_F(FieldWriter, KeepsEveryBitInEveryFormat) {
    const auto field = awkwardField();
    for (const char* const name : {"a.npy", "a.txt", "a.NPY"}) {
        const auto file = write(name, fieldBytes(path(name), kMesh, field));
        EXPECT_EQ(readField(file, field.size()), field) << name;
    }
    const MeshFile read = readMeshFile(write("a.ply", fieldBytes(path("a.ply"), kMesh, field)));
    EXPECT_EQ(read.quality, field);
    EXPECT_EQ(read.mesh.vertices, kMesh.vertices);
    EXPECT_EQ(read.mesh.faces, kMesh.faces);
}

TEST_F(FieldWriter, AlignsTheDataOfNpy) {
    for (const std::size_t count : {1U, 10U, 1000U, 12345U}) {
        const TriangleMesh mesh{.vertices = std::vector<Vec3>(count, Vec3::Zero()), .faces = {}};
        const std::string bytes = fieldBytes("a.npy", mesh, std::vector<double>(count, 1.0));
        EXPECT_EQ((bytes.size() - 8 * count) % 64, 0U) << count;
    }
}

TEST_F(FieldWriter, RefusesOtherExtensions) {
    const auto call = [] {
        checkFieldExtension("a.obj");
        return 0;
    };
    expectContains(refusal(call, InputErrorCode::UnwritableFile), "none of .ply, .npy, .txt");
}

}  // namespace bspline_curve::io_tests
