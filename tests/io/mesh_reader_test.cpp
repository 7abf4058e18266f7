// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.h"

#include "io/temporary_files.h"

#include <algorithm>

namespace bspline_curve::io_tests {

namespace {

class MeshReader : public FileTest {
protected:
    TriangleMesh read(const std::string& name, const std::string& bytes) {
        return readMesh(write(name, bytes));
    }
};

const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Triangle> kTwoFaces{{0, 1, 2}, {0, 2, 3}};

/// No float can hold these.
constexpr double kFine = 0.1234567890123456;

std::string plyHeader(
    const std::string& format, const std::string& scalar, const std::string& more = ""
) {
    return "ply\nformat " + format + " 1.0\nelement vertex 4\nproperty " + scalar +
           " x\nproperty " + scalar + " y\nproperty " + scalar + " z\n" + more +
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Scalar>
std::string plyBody(bool swapped = false) {
    std::string bytes;
    const auto append = [&](std::string number) {
        if (swapped) {
            std::ranges::reverse(number);
        }
        bytes += number;
    };
    for (const Vec3& p : kSquare) {
        for (const double x : p) {
            append(bytesOf(static_cast<Scalar>(x)));
        }
    }
    for (const Triangle& face : kTwoFaces) {
        bytes += '\3';
        for (const int id : face) {
            append(bytesOf(id));
        }
    }
    return bytes;
}

void expectSquare(const TriangleMesh& mesh) {
    ASSERT_EQ(mesh.vertices.size(), kSquare.size());
    for (std::size_t i = 0; i < kSquare.size(); ++i) {
        EXPECT_EQ(mesh.vertices[i], kSquare[i]) << "vertex " << i;
    }
    EXPECT_EQ(mesh.faces, kTwoFaces);
}

}  // namespace

TEST_F(MeshReader, ReadsBinaryPlyOfEitherEndianness) {
    expectSquare(read("a.ply", plyHeader("binary_little_endian", "double") + plyBody<double>()));
    expectSquare(read("b.ply", plyHeader("binary_little_endian", "float") + plyBody<float>()));
    expectSquare(read("c.PLY", plyHeader("binary_big_endian", "float") + plyBody<float>(true)));
}

TEST_F(MeshReader, ReadsAsciiPly) {
    expectSquare(read(
        "a.ply", plyHeader("ascii", "float") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
    ));
}

TEST_F(MeshReader, KeepsEveryDigitOfDoublePly) {
    const std::string ascii = plyHeader("ascii", "double") +
                              "0.1234567890123456 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    EXPECT_EQ(read("a.ply", ascii).vertices[0].x(), kFine);
    std::string binary = plyHeader("binary_little_endian", "double") + plyBody<double>();
    binary.replace(plyHeader("binary_little_endian", "double").size(), 8, bytesOf(kFine));
    EXPECT_EQ(read("b.ply", binary).vertices[0].x(), kFine);
}

TEST_F(MeshReader, KeepsEveryDigitOfObjAndOff) {
    EXPECT_EQ(
        read("a.obj", "v 0.1234567890123456 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").vertices[0].x(),
        kFine
    );
    EXPECT_EQ(
        read("a.off", "OFF\n3 1 0\n0.1234567890123456 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            .vertices[0]
            .x(),
        kFine
    );
}

TEST_F(MeshReader, ReadsPerVertexQualityOfFloatAndDouble) {
    const std::string body =
        "0 0 0 0.5\n1 0 0 -1\n1 1 0 2e10\n0 1 0 0.1234567890123456\n3 0 1 2\n3 0 2 3\n";
    const MeshFile precise = readMeshFile(
        write("a.ply", plyHeader("ascii", "float", "property double quality\n") + body)
    );
    EXPECT_EQ(precise.quality, (std::vector<double>{0.5, -1, 2e10, kFine}));
    const MeshFile coarse = readMeshFile(
        write("b.ply", plyHeader("ascii", "double", "property float quality\n") + body)
    );
    EXPECT_EQ(coarse.quality[0], 0.5);
    EXPECT_EQ(coarse.quality[3], static_cast<double>(static_cast<float>(kFine)));
    expectSquare(coarse.mesh);
}

TEST_F(MeshReader, DoesNotTakeConfidenceForQuality) {
    const std::string file = plyHeader("ascii", "float", "property float confidence\n") +
                             "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n3 0 1 2\n3 0 2 3\n";
    EXPECT_TRUE(readMeshFile(write("a.ply", file)).quality.empty());
}

TEST_F(MeshReader, SkipsOtherPropertiesOfPly) {
    const std::string file =
        "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty "
        "float y\n"
        "property float z\nproperty uchar red\nproperty int flags\nelement face 1\nproperty uchar "
        "red\n"
        "property list uchar float weights\nproperty list uchar int vertex_index\nproperty int "
        "flags\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
        "0 0 0 255 1\n1 0 0 255 1\n0 1 0 255 1\n7 2 0.5 0.5 3 0 1 2 1\n0 1\n";
    const TriangleMesh mesh = read("a.ply", file);
    EXPECT_EQ(mesh.vertices.size(), 3U);
    EXPECT_EQ(mesh.faces, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST_F(MeshReader, ReadsObjWithNormalsTexturesColoursAndRelativeIndices) {
    const std::string file =
        "# comment\r\nmtllib none.mtl\r\no square\r\nv 0 0 0 1 0 0\r\nv 1 0 0 1 0 0\r\nv 1 1 0 1 0 "
        "0\r\n"
        "v 0 1 0 1 0 0\r\nvt 0 0\r\nvn 0 0 1\r\nusemtl red\r\nf 1/1/1 2/1/1 3/1/1\r\nf -4//1 -2//1 "
        "-1//1\r\n";
    expectSquare(read("a.obj", file));
}

TEST_F(MeshReader, KeepsFacesWhoseNormalOrTextureIndexIsWrong) {
    const std::string file =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/9/9 2/9/9 3/9/9\nf 1 3 4\n";
    expectSquare(read("a.obj", file));
}

TEST_F(MeshReader, ReadsOffWithCommentsBlankLinesAndColours) {
    expectSquare(read("a.off", "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"));
    expectSquare(read(
        "b.off",
        "# first\nCOFF 4 2 0\n\n0 0 0 255 0 0 255 # a\n1 0 0 255 0 0 255\n   \n1 1 0 255 0 0 255\n"
        "0 1 0 255 0 0 255\n3 0 1 2 0.5 0.5 0.5\n  3 0 2 3\n"
    ));
}

TEST_F(MeshReader, CutsPolygonsIntoFans) {
    const std::string vertices = "0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n-1 1 0\n9 9 9\n8 8 8\n";
    const std::vector<Triangle> fan{{2, 3, 4}, {2, 4, 5}, {2, 5, 0}, {2, 0, 1}, {0, 6, 7}};
    EXPECT_EQ(read("a.off", "OFF\n8 2 0\n" + vertices + "6 2 3 4 5 0 1\n3 0 6 7\n").faces, fan);
    EXPECT_EQ(
        read(
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double "
            "y\nproperty double z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
                vertices + "6 2 3 4 5 0 1\n3 0 6 7\n"
        )
            .faces,
        fan
    );
    std::string obj;
    for (const char* line :
         {"0 0 0", "2 0 0", "3 1 0", "2 2 0", "0 2 0", "-1 1 0", "9 9 9", "8 8 8"}) {
        obj += std::string("v ") + line + "\n";
    }
    EXPECT_EQ(read("a.obj", obj + "f 3 4 5 6 1 2\nf 1 7 8\n").faces, fan);
}

TEST_F(MeshReader, CutsQuadsOfAnyFormatIntoTwo) {
    const TriangleMesh mesh = read("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ASSERT_EQ(mesh.faces.size(), 2U);
    for (const Triangle& face : mesh.faces) {
        const auto at = [&](std::size_t k) { return mesh.vertices[face[k]]; };
        const Vec3 a = at(1) - at(0);
        const Vec3 b = at(2) - at(0);
        EXPECT_EQ(a.x() * b.y() - a.y() * b.x(), 1.0) << "twice the area, oriented upwards";
    }
}

TEST_F(MeshReader, WeldsEqualVerticesOfStl) {
    const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
        return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b +
               "\n  vertex " + c + "\n endloop\nendfacet\n";
    };
    expectSquare(read(
        "a.stl",
        "solid square\n" + facet("0 0 0", "1 0 0", "1 1 0") +
            facet("-0 0 0", "1.0 1e0 0", "0 1 0") + "endsolid square\n"
    ));
    std::string binary(80, ' ');
    binary += bytesOf(std::uint32_t{2});
    for (const Triangle& face : kTwoFaces) {
        binary += bytesOf(0.0F) + bytesOf(0.0F) + bytesOf(1.0F);
        for (const int id : face) {
            for (const double x : kSquare[id]) {
                binary += bytesOf(static_cast<float>(x));
            }
        }
        binary += bytesOf(std::uint16_t{0});
    }
    expectSquare(read("b.stl", binary));
}

TEST_F(MeshReader, DoesNotWeldVerticesThatOnlyNearlyMeet) {
    const std::string file =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
        "0\nendloop\nendfacet\n"
        "facet normal 0 0 1\nouter loop\nvertex 1e-7 0 0\nvertex 1 1 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid a\n";
    EXPECT_EQ(read("a.stl", file).vertices.size(), 5U);
}

TEST_F(MeshReader, DoesNotWeldOtherFormats) {
    EXPECT_EQ(
        read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 4 5 6\n")
            .vertices.size(),
        6U
    );
}

TEST_F(MeshReader, ReadsNamesWithSpacesAndUnicode) {
    EXPECT_EQ(
        read("Knöchel, links 足.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faces.size(), 1U
    );
}

}  // namespace bspline_curve::io_tests
