// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polyline_reader.h"

#include "io/temporary_files.h"

namespace bspline_curve::io_tests {

namespace {

class PolylineReader : public FileTest {
protected:
    std::string refused(const std::string& name, std::string_view bytes) {
        const auto file = write(name, bytes);
        std::string message = refusal([&] { return readPolylines(file); });
        expectContains(message, file.string());
        return message;
    }

    SpacePolyline only(const std::string& name, std::string_view bytes) {
        const std::vector<SpacePolyline> lines = readPolylines(write(name, bytes));
        EXPECT_EQ(lines.size(), 1U);
        return lines.front();
    }
};

const std::vector<Vec3> kTriangle{{0, 0, 1}, {1, 0, 1}, {0, 2, 1}};
constexpr const char* kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nproperty uchar red\nelement edge 2\nproperty int vertex1\nproperty int "
    "vertex2\nend_header\n0 0 1 7\n1 0 1 7\n0 2 1 7\n";

/// The entities of a DXF file, one pair of code and value a line.
std::string dxf(const std::string& pairs) {
    std::string text =
        "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"
        "0\nSECTION\n2\nENTITIES\n";
    for (const char c : pairs) {
        text += c == ' ' ? '\n' : c;
    }
    return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace

TEST_F(PolylineReader, ReadsEdgesOfPlyAndPassesOverOtherElements) {
    const SpacePolyline line = only("a.ply", std::string(kPlyHead) + "2 1\n1 0\n");
    EXPECT_EQ(line.points, (std::vector<Vec3>{kTriangle[2], kTriangle[1], kTriangle[0]}));
    EXPECT_FALSE(line.closed);
    std::string binary =
        "ply\nformat binary_little_endian 1.0\nelement edge 3\nproperty int vertex1\nproperty int "
        "vertex2\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex "
        "3\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (const std::int32_t end : {0, 1, 1, 2, 2, 0}) {
        binary += bytesOf(end);
    }
    binary += bytesOf(std::uint8_t{3});
    for (const std::int32_t corner : {0, 1, 2}) {
        binary += bytesOf(corner);
    }
    for (const Vec3& point : kTriangle) {
        for (const double x : point) {
            binary += bytesOf(x);
        }
    }
    const SpacePolyline ring = only("b.ply", binary);
    EXPECT_TRUE(ring.closed);
    EXPECT_EQ(ring.points.size(), 3U);
}

TEST_F(PolylineReader, RefusesPlyWithoutEdgesOrWithWrongOnes) {
    const std::string head = kPlyHead;
    expectContains(refused("a.ply", head + "2 1\n"), "no edge 1 of 2");
    expectContains(refused("b.ply", head + "2 1\n1 3\n"), "edge 1 names vertex 3 of 3");
    expectContains(refused("c.ply", head + "2 1\n1 -1\n"), "edge 1 names vertex -1");
    expectContains(
        refused("d.ply", head.substr(0, head.find("element edge")) + "end_header\n0 0 1 7\n"),
        "no element \"edge\""
    );
}

TEST_F(PolylineReader, ReadsLineElementsOfObj) {
    const std::string points = "v 0 0 1\nv 1 0 1\nv 0 2 1\nvn 0 0 1\nf 1 2 3\n";
    EXPECT_EQ(only("a.obj", points + "l 1 2 3\n").points, kTriangle);
    EXPECT_TRUE(only("b.obj", points + "l 1/1 2/2\nl -2 -1\nl 3 1\n").closed);
    EXPECT_EQ(readPolylines(write("c.obj", points + "v 5 5 5\nl 1 2\nl 3 4\n")).size(), 2U);
    expectContains(refused("d.obj", points), "no polyline");
    expectContains(refused("e.obj", points + "l 1 4\n"), "line 6: \"4\" is not the index");
    expectContains(refused("f.obj", "v 0 0\n"), "three coordinates");
    expectContains(refused("g.obj", "v 0 0 nan\nv 1 0 0\nl 1 2\n"), "vertex 0 is not finite");
}

TEST_F(PolylineReader, ReadsLinesAndPolylinesOfDxf) {
    const std::string soup =
        dxf("0 LINE 8 0 10 0 20 0 30 1 11 1 21 0 31 1 "
            "0 TEXT 10 4 20 4 1 word "
            "0 LINE 10 0 20 2 30 1 11 1 21 0 31 1 ");
    EXPECT_EQ(only("a.dxf", soup).points, kTriangle);
    const std::string heavy =
        dxf("0 POLYLINE 66 1 70 9 0 VERTEX 10 0 20 0 30 1 0 VERTEX 10 1 20 0 30 1 "
            "0 VERTEX 10 0 20 2 30 1 0 SEQEND ");
    EXPECT_EQ(only("b.dxf", heavy).points.size(), 3U);
    EXPECT_TRUE(only("b.dxf", heavy).closed);
    // In its own coordinates: z is -y, x is the world's x.
    const std::string light =
        dxf("0 LWPOLYLINE 90 2 70 0 38 5 210 0 220 -1 230 0 10 1 20 2 10 3 20 4 ");
    EXPECT_EQ(only("c.dxf", light).points, (std::vector<Vec3>{{1, -5, 2}, {3, -5, 4}}));
}

TEST_F(PolylineReader, RefusesCurvesOfDxfThatAreNoPolylines) {
    expectContains(refused("a.dxf", dxf("0 CIRCLE 10 0 20 0 40 1 ")), "the entity CIRCLE");
    expectContains(
        refused("b.dxf", dxf("0 LWPOLYLINE 90 2 10 0 20 0 42 0.5 10 1 20 0 ")), "an arc (bulge)"
    );
    expectContains(refused("c.dxf", "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"), "ENTITIES");
    expectContains(refused("d.dxf", dxf("0 LINE 10 zero 20 0 11 1 21 1 ")), "not a finite number");
    expectContains(refused("e.dxf", dxf("0 LINE 10 nan 20 0 11 1 21 1 ")), "not a finite number");
    expectContains(refused("f.dxf", dxf("0 TEXT 1 word ")), "no polyline");
    expectContains(refused("g.dxf", "AutoCAD Binary DXF\r\n\x1a"), "binary");
    expectContains(refused("h.dxf", "ply\nformat\n"), "no group code");
    expectContains(refused("i.stl", "solid\n"), "curves are read from .json");
}

}  // namespace bspline_curve::io_tests
