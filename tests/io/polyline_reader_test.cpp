// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/small_curve.h"
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
        const std::vector<SpacePolyline> lines = readPolylines(write(name, bytes)).lines;
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
    EXPECT_EQ(readPolylines(write("c.obj", points + "v 5 5 5\nl 1 2\nl 3 4\n")).lines.size(), 2U);
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

TEST_F(PolylineReader, ReadsTheCurvesOfDxfThatDrawingsAreReadFrom) {
    const SpacePolyline circle = only("a.dxf", dxf("0 CIRCLE 10 1 20 0 30 2 40 3 "));
    EXPECT_TRUE(circle.closed);
    EXPECT_GT(circle.points.size(), 100U);
    for (const Vec3& point : circle.points) {
        EXPECT_NEAR((point - Vec3(1, 0, 2)).norm(), 3.0, 1e-3);
        EXPECT_EQ(point.z(), 2.0);
    }
    const SpacePolyline bulge =
        only("b.dxf", dxf("0 LWPOLYLINE 90 2 38 1 10 -1 20 0 42 1 10 1 20 0 "));
    for (const Vec3& point : bulge.points) {
        EXPECT_NEAR(point.head<2>().norm(), 1.0, 1e-3);
    }
    // A spline in space, and one entity that is none.
    const PolylineFile file = readPolylines(write(
        "c.dxf",
        dxf("0 SPLINE 71 1 40 0 40 0 40 1 40 1 10 0 20 0 30 5 10 1 20 2 30 6 0 CIRCLE 40 0 ")
    ));
    ASSERT_EQ(file.lines.size(), 1U);
    EXPECT_EQ(file.lines[0].points, (std::vector<Vec3>{{0, 0, 5}, {1, 2, 6}}));
    EXPECT_EQ(file.notes.size(), 1U);
}

TEST_F(PolylineReader, ReadsSplinesOfObj) {
    // A parabola, with a statement over two lines; a Bézier curve is left out.
    const PolylineFile file = readPolylines(write(
        "a.obj",
        "v 0 0 0\nv 1 2 0\nv 2 0 0\ncstype bspline\ndeg 2\ncurv 0 1 1 \\\n2 3\n"
        "parm u 0 0 0 1 1 1\nend\ncstype bezier\ncurv 0 1 1 2 3\nparm u 0 1\nend\n"
    ));
    ASSERT_EQ(file.lines.size(), 1U);
    for (const Vec3& point : file.lines[0].points) {
        EXPECT_NEAR(point.y(), point.x() * (2.0 - point.x()), 1e-12);
    }
    ASSERT_EQ(file.notes.size(), 1U);
    expectContains(file.notes[0], "1 free-form curve left out; line 11");
}

TEST_F(PolylineReader, ReadsAllThatCurvesAreWrittenAs) {
    for (const bool closed : {false, true}) {
        Curve curve = smallCurve(closed);
        curve.polyline.parameters.back() = closed ? 0.7 : 1.0;
        for (const char* const name : {"a.ply", "a.csv", "a.vtu"}) {
            const PolylineFile file = readPolylines(write(name, curveBytes(name, curve)));
            ASSERT_EQ(file.lines.size(), 1U) << name;
            EXPECT_EQ(file.lines[0].points, curve.polyline.points) << name;
            EXPECT_EQ(file.lines[0].closed, closed) << name;
            ASSERT_EQ(file.places[0].size(), curve.polyline.points.size()) << name;
            for (std::size_t i = 0; i < file.places[0].size(); ++i) {
                EXPECT_EQ(file.places[0][i].face, curve.polyline.surfacePoints[i].face);
                EXPECT_EQ(
                    file.places[0][i].barycentric, curve.polyline.surfacePoints[i].barycentric
                );
            }
        }
        for (const char* const name : {"a.bspline.obj", "a.bspline.dxf"}) {
            const PolylineFile file = readPolylines(write(name, curveBytes(name, curve)));
            ASSERT_EQ(file.lines.size(), 1U) << name;
            EXPECT_EQ(file.lines[0].closed, closed) << name;
        }
    }
}

TEST_F(PolylineReader, ReadsTextOfVtuAndRefusesWhatItCannot) {
    const std::string start = "<VTKFile type='UnstructuredGrid'";
    const std::string grid =
        "><UnstructuredGrid><Piece><Points><DataArray type='Float32' format='ascii'>0 0 1 1 0 1 0 "
        "2 "
        "1</DataArray></Points><Cells><DataArray Name='connectivity' format='ascii'>0 1 "
        "2</DataArray>"
        "<DataArray Name='offsets' format='ascii'>3</DataArray><DataArray Name='types' "
        "format='ascii'>4</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
    EXPECT_EQ(only("a.vtu", start + grid).points, kTriangle);
    expectContains(refused("b.vtu", start + " compressor='zlib'" + grid), "compressed");
    expectContains(refused("c.vtu", "<VTKFile/>"), "no unstructured grid");
    expectContains(refused("d.vtu", start), "line 1: is not XML");
    std::string wrong = start + grid;
    wrong.replace(wrong.find("0 1 2<"), 5, "0 1 9");
    expectContains(refused("e.vtu", wrong), "names a point that is not there");
}

TEST_F(PolylineReader, RefusesCsvWithoutRecords) {
    expectContains(refused("a.csv", "# x, y and z\n"), "no polyline");
    expectContains(refused("b.csv", "\n \n"), "no polyline");
}

TEST_F(PolylineReader, RefusesDxfWithoutCurves) {
    expectContains(refused("c.dxf", "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"), "ENTITIES");
    expectContains(refused("d.dxf", dxf("0 LINE 10 zero 20 0 11 1 21 1 ")), "not a finite number");
    expectContains(refused("e.dxf", dxf("0 LINE 10 nan 20 0 11 1 21 1 ")), "not a finite number");
    expectContains(refused("f.dxf", dxf("0 TEXT 1 word ")), "no curve");
    expectContains(refused("g.dxf", "AutoCAD Binary DXF\r\n\x1a"), "binary");
    expectContains(refused("h.dxf", "ply\nformat\n"), "no group code");
    expectContains(refused("i.stl", "solid\n"), "curves are read from .json");
}

}  // namespace bspline_curve::io_tests
