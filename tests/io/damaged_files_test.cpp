// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/damage.h"
#include "io/temporary_files.h"

#include <algorithm>
#include <random>

namespace bspline_curve::io_tests {

namespace {

class DamagedMesh : public FileTest {
protected:
    /// What the refusal of a file says; it must name the file.
    std::string refused(
        const std::string& name,
        std::string_view bytes,
        InputErrorCode code = InputErrorCode::UnreadableFile
    ) {
        const auto file = write(name, bytes);
        std::string message = refusal([&] { return readMeshFile(file); }, code);
        expectContains(message, file.string());
        return message;
    }
};

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string binaryPly() {
    std::string bytes = kPly.substr(0, kPly.find("0 0 0"));
    bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) {
        bytes += bytesOf(x);
    }
    for (const int id : {0, 1, 2}) {
        bytes += std::string(id == 0 ? "\3" : "") + bytesOf(id);
    }
    bytes += '\3';
    for (const int id : {0, 2, 3}) {
        bytes += bytesOf(id);
    }
    return bytes;
}

std::string binaryStl() {
    std::string bytes(80, ' ');
    bytes += bytesOf(std::uint32_t{2});
    for (const float shift : {0.F, 1.F}) {
        for (const float x : {0.F, 0.F, -1.F, shift, 0.F, 0.F, 0.F, shift, 1.F, 0.3F, 0.F, 1.F}) {
            bytes += bytesOf(x);
        }
        bytes += bytesOf(std::uint16_t{0});
    }
    return bytes;
}

/// Whether a file is refused, or read as a mesh whose faces name vertices that are there.
bool holdsTogetherOrIsRefused(const std::filesystem::path& file) {
    try {
        const TriangleMesh mesh = readMesh(file);
        const auto count = static_cast<int>(mesh.vertices.size());
        return std::ranges::all_of(mesh.faces, [&](const Triangle& face) {
            return std::ranges::all_of(face, [&](int id) { return id >= 0 && id < count; });
        });
    } catch (const InputError&) {
        return true;
    }
}

}  // namespace

TEST_F(DamagedMesh, MissingFilesDirectoriesAndUnknownKindsAreRefused) {
    expectContains(refusal([&] { return readMesh(path("none.ply")); }), "no such file");
    std::filesystem::create_directory(path("folder.ply"));
    expectContains(refusal([&] { return readMesh(path("folder.ply")); }), "directory");
    expectContains(refused("a.fbx", "x"), ".fbx");
    expectContains(refused("a", "x"), "extension");
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
        expectContains(refused(name, ""), "empty");
    }
}

TEST_F(DamagedMesh, OtherFilesUnderAMeshNameAreRefused) {
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
        refused(name, "Dear reader, this is no mesh.\n");
        refused(name, std::string(500, '\0'));
        refused(name, std::string(2000, '\xff'));
        refused(name, "\n\n\n");
        refused(name, std::string(300, 'a'));
    }
}

TEST_F(DamagedMesh, MeshesWithoutFacesAreRefused) {
    expectContains(refused("a.obj", kObj), "face");
    expectContains(refused("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "no faces");
    expectContains(
        refused(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
            "float z\nend_header\n0 0 0\n"
        ),
        "no faces"
    );
    expectContains(
        refused("a.stl", std::string("solid ") + std::string(90, 'x') + "\nendsolid\n"), "no faces"
    );
}

TEST_F(DamagedMesh, IndicesOutOfRangeAreRefused) {
    expectContains(refused("a.ply", kPly + "3 0 1 2\n3 0 2 4\n"), "face 1 names vertex 4 of 4");
    expectContains(refused("b.ply", kPly + "3 0 1 2\n4 0 1 2 4\n"), "vertex 4");
    expectContains(refused("c.ply", kPly + "3 0 1 -2\n3 0 2 3\n"), "vertex -2");
    expectContains(refused("a.off", kOff + "3 0 1 3\n"), "line 6");
    expectContains(refused("b.off", kOff + "3 0 1 -1\n"), "line 6");
    expectContains(refused("a.obj", kObj + "f 1 2 4\n"), "line 4");
    expectContains(refused("b.obj", kObj + "f 1 2 0\n"), "line 4");
    expectContains(refused("c.obj", kObj + "f 1 2 -4\n"), "line 4");
    expectContains(refused("d.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n"), "line 3");
    expectContains(refused("e.obj", kObj + "f 1 2 3\nl 1 9\n"), "vertex 9");
}

TEST_F(DamagedMesh, FacesThatNameAVertexTwiceAreRefusedByTheirIndex) {
    const auto code = InputErrorCode::DegenerateFace;
    expectContains(refused("a.obj", kObj + "f 1 2 3\nf 1 2 2\n", code), "1");
    expectContains(refused("a.ply", kPly + "3 0 1 2\n3 0 0 3\n", code), "1");
    try {
        static_cast<void>(readMesh(write("b.obj", kObj + "f 1 2 3\nf 1 2 2\nf 3 3 1\n")));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.elements(), (std::vector<std::int64_t>{1, 2}));
    }
}

TEST_F(DamagedMesh, FacesThatNameAVertexTwiceKeepTheirPlaceWhereTheyAreWanted) {
    const auto facesOf = [&](const std::string& name, const std::string& bytes) {
        return readMeshFile(write(name, bytes), RepeatedVertices::Keep).mesh.faces;
    };
    const std::vector<Triangle> faces = {{0, 1, 2}, {0, 1, 1}, {2, 2, 0}, {0, 2, 3}, {1, 1, 1}};
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    EXPECT_EQ(facesOf("a.obj", obj + "f 1 2 3\nf 1 2 2\nf 3 3 1\nf 1 3 4\nf 2 2 2\n"), faces);
    const std::vector<Triangle> cut = {{0, 1, 1}, {0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(facesOf("b.obj", obj + "f 1 2 2 3 4\n"), cut);
    std::string ply = kPly;
    ply.replace(ply.find("face 2"), 6, "face 5");
    EXPECT_EQ(facesOf("a.ply", ply + "3 0 1 2\n3 0 1 1\n3 2 2 0\n3 0 2 3\n3 1 1 1\n"), faces);
}

TEST_F(DamagedMesh, TooFewCornersAreRefused) {
    expectContains(refused("a.ply", kPly + "3 0 1 2\n2 0 1\n"), "face 1 has 2 corners");
    expectContains(refused("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"), "line 3");
    expectContains(refused("a.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n"), "line 5");
}

TEST_F(DamagedMesh, WordsForNumbersAreRefused) {
    expectContains(refused("a.obj", "v 0 zero 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "\"zero\"");
    expectContains(refused("a.off", "OFF\n3 1 0\n0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"), "\"zero\"");
    refused(
        "a.ply",
        kPly.substr(0, kPly.find("0 0 0")) + "0 zero 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
    );
}

TEST_F(DamagedMesh, WhatOtherProgramsMisreadIsRefused) {
    expectContains(refused("a.obj", "v 0 0 0\n v 1 0 0\nv 0 1 0\nf 1 2 3\n"), "line 2");
    expectContains(refused("b.obj", kObj + "f 1 2 3\\"), "line 4");
    expectContains(
        refused("c.obj", "#MRGB ffffffff\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "MRGB"
    );
    expectContains(refused("a.off", "OFF BINARY\n1\n"), "binary");
    expectContains(refused("b.off", "4OFF\n1 1 0\n"), "4OFF");
    std::string big = kPly + "3 0 1 2\n3 0 2 3\n";
    big.replace(big.find("ascii"), 5, "binary_big_endian");
    for (int k = 0; k < 3; ++k) {
        big.replace(big.find("float"), 5, "double");
    }
    expectContains(refused("big.ply", big), "big-endian double");
    std::string unusual = kPly + "3 0 1 2\n3 0 2 3\n";
    unusual.replace(unusual.find("uchar int"), 9, "uchar float");
    expectContains(refused("unusual.ply", unusual), "type float");
    std::string grid = kPly + "3 0 1 2\n3 0 2 3\n";
    grid.replace(grid.find("element face"), 12, "element range_grid");
    expectContains(refused("grid.ply", grid), "range_grid");
}

TEST_F(DamagedMesh, StripsThatNameNoVertexAreRefused) {
    std::string strips = kPly + "4 0 1 2 3\n4 -1 0 1 4\n";
    strips.replace(strips.find("element face"), 12, "element tristrips");
    expectContains(refused("a.ply", strips), "tristrips 1 names vertex 4 of 4");
    strips.replace(strips.find("-1 0 1 4"), 8, "-2 0 1 2");
    expectContains(refused("b.ply", strips), "names vertex -2 of 4");
    strips.replace(strips.find("uchar int"), 9, "uchar float");
    expectContains(refused("c.ply", strips), "type float");
}

/// vcglib's importer counts three vertices here and writes four.
TEST_F(DamagedMesh, VerticesThatOtherProgramsOverlookAreRefused) {
    using namespace std::string_literals;
    for (const char separator : {'\0', '\r'}) {
        refused("a.obj", "v 0 0 0\nv"s + separator + " 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\n");
    }
}

TEST_F(DamagedMesh, EveryTruncationOfABinaryFileIsRefused) {
    for (const auto& [name, bytes] : {std::pair{"a.ply", binaryPly()}, {"a.stl", binaryStl()}}) {
        EXPECT_NO_THROW(static_cast<void>(readMesh(write(name, bytes)))) << name;
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            SCOPED_TRACE(std::string(name) + " of " + std::to_string(size) + " bytes");
            refused(name, bytes.substr(0, size));
        }
    }
}

TEST_F(DamagedMesh, EveryLineLostFromATextIsRefused) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
        "0\nendloop\nendfacet\n";
    std::string stl = "solid a\n";
    stl.append(facet).append(facet).append("endsolid a\n");
    for (const auto& [name, bytes] :
         {std::pair{"a.ply", kPly + "3 0 1 2\n3 0 2 3\n"},
          {"a.off", std::string("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n")},
          {"a.stl", stl}}) {
        EXPECT_NO_THROW(static_cast<void>(readMesh(write(name, bytes)))) << name;
        for (std::size_t end = bytes.rfind('\n', bytes.size() - 2);
             end != std::string::npos && end > 0;
             end = bytes.rfind('\n', end - 1)) {
            SCOPED_TRACE(std::string(name) + " of " + std::to_string(end + 1) + " bytes");
            refused(name, bytes.substr(0, end + 1));
        }
    }
}

/// Each reading either works or throws InputError, and what it returns holds together; run with the
/// sanitizers.
TEST_F(DamagedMesh, RandomDamageNeverCrashes) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"a.ply", binaryPly()},
        {"b.ply", kPly + "3 0 1 2\n3 0 2 3\n"},
        {"a.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n2 2 2\n3 0 1 2\n5 0 1 2 3 4\n"},
        {"a.obj",
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf -4 -2 -1\nl "
         "1 2 3\n"},
        {"a.stl", binaryStl()},
        {"b.stl",
         "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
         "0\nendloop\nendfacet\nendsolid a\n"},
    };
    constexpr unsigned kSeed = 20250731;
    std::mt19937 random(kSeed);
    for (int round = 0; round < 3000; ++round) {
        const auto& [name, original] = files[round % files.size()];
        const std::string bytes = damaged(original, "0123456789 -.\\#vflqeE\t\r", random);
        SCOPED_TRACE(
            std::string("seed ") + std::to_string(kSeed) + ", round " + std::to_string(round) +
            ": " + bytes
        );
        const std::filesystem::path file = write(name, bytes);
        EXPECT_TRUE(holdsTogetherOrIsRefused(file));
    }
}

}  // namespace bspline_curve::io_tests
