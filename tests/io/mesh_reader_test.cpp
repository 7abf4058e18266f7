// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
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
    const std::string& format,
    const std::string& scalar,
    const std::string& more = "",
    const std::string& faces = "face 2\nproperty list uchar int"
) {
    return "ply\nformat " + format + " 1.0\nelement vertex 4\nproperty " + scalar +
           " x\nproperty " + scalar + " y\nproperty " + scalar + " z\n" + more + "element " +
           faces + " vertex_indices\nend_header\n";
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

/// Seen from above.
double signedArea(const std::vector<Vec3>& vertices, const Triangle& face) {
    const Vec3 a = vertices[face[1]] - vertices[face[0]];
    const Vec3 b = vertices[face[2]] - vertices[face[0]];
    return 0.5 * (a.x() * b.y() - a.y() * b.x());
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

/// An L, whose fan at some corners folds over.
TEST_F(MeshReader, CutsConcavePolygonsWithoutAFold) {
    const TriangleMesh corners =
        read("corners.off", "OFF\n6 1 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n2 0 0\n3 0 1 2\n");
    const std::string vertices = "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\n";
    for (const char* face :
         {"1 2 3 4 5 6",
          "2 3 4 5 6 1",
          "3 4 5 6 1 2",
          "4 5 6 1 2 3",
          "5 6 1 2 3 4",
          "6 1 2 3 4 5"}) {
        const auto faces = read("a.obj", vertices + "f " + face).faces;
        EXPECT_EQ(faces.size(), 4U) << face;
        double area = 0.0;
        for (const Triangle& triangle : faces) {
            area += std::abs(signedArea(corners.vertices, triangle));
            EXPECT_GT(signedArea(corners.vertices, triangle), 0.0) << face;
        }
        EXPECT_EQ(area, 3.0) << face;
    }
}

TEST_F(MeshReader, CutsConcavePolygonsOfOffAndPlyTheSameWay) {
    const std::string vertices = "2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n2 0 0\n";
    const std::vector<Triangle> faces =
        read("a.off", "OFF\n6 1 0\n" + vertices + "6 0 1 2 3 4 5\n").faces;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(read("a.ply", ply + vertices + "6 0 1 2 3 4 5\n").faces, faces);
    EXPECT_NE(faces[0], (Triangle{0, 1, 2})) << "which would be of a fan, and fold";
}

TEST_F(MeshReader, ReadsStripsOfTriangles) {
    const std::string file =
        plyHeader("ascii", "float", "", "tristrips 2\nproperty list uchar int") +
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n10 0 1 2 -1 -1 0 1 2 3 0\n3 2 1 3\n";
    const std::vector<Triangle> faces{{0, 1, 2}, {0, 1, 2}, {2, 1, 3}, {2, 3, 0}, {2, 1, 3}};
    EXPECT_EQ(read("a.ply", file).faces, faces);

    const auto binary = [&](const std::string& format, const std::string& type, bool swapped) {
        std::string bytes =
            plyHeader(format, "float", "", "tristrips 1\nproperty list " + type + " " + type);
        const std::string body = plyBody<float>(swapped);
        bytes += body.substr(0, 4 * 3 * sizeof(float));
        for (const int number : {7, 0, 1, 2, -1, 0, 2, 3}) {
            std::string four = bytesOf(number);
            if (swapped) {
                std::ranges::reverse(four);
            }
            bytes += four;
        }
        return bytes;
    };
    expectSquare(read("b.ply", binary("binary_little_endian", "int", false)));
    expectSquare(read("c.ply", binary("binary_big_endian", "int", true)));
    expectSquare(read("d.ply", binary("binary_little_endian", "uint", false)));
}

TEST_F(MeshReader, TakesFacesWhereAFileHasStripsToo) {
    const std::string header = plyHeader(
        "ascii",
        "float",
        "",
        "face 2\nproperty list uchar int vertex_indices\nelement tristrips 1\nproperty list int int"
    );
    expectSquare(
        read("a.ply", header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n4 0 1 2 3\n")
    );
}

TEST_F(MeshReader, OverlooksElementsOfPlyWithoutProperties) {
    const std::string header = plyHeader("ascii", "float", "element nothing 2000000000\n");
    expectSquare(read("a.ply", header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"));
}

TEST_F(MeshReader, OverlooksZeroBytesAtTheEndOfTexts) {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    expectSquare(read("a.obj", obj + '\0'));
    expectSquare(read("b.obj", obj + std::string(512, '\0')));
    expectSquare(read("a.off", off + std::string(9, '\0')));
}

TEST_F(MeshReader, JoinsLinesOfObjThatEndInABackslash) {
    expectSquare(read(
        "a.obj", "v 0 0 0\nv 1 0 \\\n0\nv 1 1 0\r\nv 0 1 0\nf 1 \\\r\n 2 \\\n3\n# no\\\nf 1 3 4\n"
    ));
}

/// A position with several texture coordinates is one vertex, so a seam parts nothing.
TEST_F(MeshReader, TakesSeamsOfTexturesForOneSurface) {
    expectSquare(read(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0\nvt 0.5 0.5\nvt 0 "
        "0.5\nf 1/1 2/2 3/3\nf 1/4 3/5 4/6\n"
    ));
}

TEST_F(MeshReader, CutsQuadsOfAnyFormatIntoTwo) {
    const TriangleMesh mesh = read("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ASSERT_EQ(mesh.faces.size(), 2U);
    for (const Triangle& face : mesh.faces) {
        EXPECT_EQ(signedArea(mesh.vertices, face), 0.5) << "oriented upwards";
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

TEST_F(MeshReader, ReadsStlWhoseHeaderOrEndMisleads) {
    const std::string facets =
        "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 1 1 0\n"
        " endloop\nendfacet\nfacet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 1 0\n"
        " vertex 0 1 0\n endloop\nendfacet\n";
    expectSquare(read("a.stl", "solid square\n" + facets + "end solid square\n"));
    expectSquare(read("b.stl", "Made by hand\n" + facets + "END SOLID\n"));
    expectSquare(read("c.stl", "\n  Solid\n" + facets + "  EndSolid  \n\nmade by hand\n"));
    // Letters that are no ASCII, beyond the place where a binary header would end.
    std::string name(90, 'n');
    for (int k = 0; k < 40; ++k) {
        name += "\xc3\xb6";
    }
    expectSquare(read("d.stl", "solid " + name + "\n" + facets + "endsolid " + name + "\n"));
    expectSquare(read("e.stl", "solid\n" + facets + "endsolid\n" + std::string(7, '\0')));
    const std::size_t half = facets.size() / 2;
    const std::string two = "solid a\n" + facets.substr(0, half) + "endsolid a\nsolid b\n";
    expectSquare(read("f.stl", two + facets.substr(half) + "endsolid b\n"));
}

TEST_F(MeshReader, ReadsBinaryStlThatSaysSolid) {
    std::string bytes = "solid square";
    bytes.resize(80, ' ');
    bytes += bytesOf(std::uint32_t{2});
    for (const Triangle& face : kTwoFaces) {
        bytes += bytesOf(0.0F) + bytesOf(0.0F) + bytesOf(1.0F);
        for (const int id : face) {
            for (const double x : kSquare[id]) {
                bytes += bytesOf(static_cast<float>(x));
            }
        }
        bytes += bytesOf(std::uint16_t{0});
    }
    expectSquare(read("a.stl", bytes));
    expectSquare(read("b.stl", bytes + std::string(4, '\xff')));
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
