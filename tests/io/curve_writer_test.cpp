// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/small_curve.h"
#include "io/temporary_files.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace bspline_curve::io_tests {

namespace {

class CurveWriter : public FileTest {};

/// Takes binary numbers off the front.
template <class Number>
Number take(std::string& bytes) {
    Number value{};
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.erase(0, sizeof value);
    return value;
}

}  // namespace

TEST_F(CurveWriter, PlyHoldsEveryNumberExactly) {
    const Curve curve = smallCurve(false);
    const std::vector<double> quality{7, 8, 9.1};
    writeCurve(path("a.ply"), curve, quality);
    std::string bytes = read(path("a.ply"));
    const std::string end = "end_header\n";
    const std::string header = bytes.substr(0, bytes.find(end));
    expectContains(header, "element vertex 3\n");
    expectContains(header, "element edge 2\n");
    expectContains(header, "property double quality\nproperty double t\nproperty int face\n");
    expectContains(header, "property uchar is_pick\n");
    bytes.erase(0, header.size() + end.size());
    for (std::size_t i = 0; i < 3; ++i) {
        for (const double x : curve.polyline.points[i]) {
            EXPECT_EQ(take<double>(bytes), x);
        }
        EXPECT_EQ(take<double>(bytes), quality[i]);
        EXPECT_EQ(take<double>(bytes), curve.polyline.parameters[i]);
        EXPECT_EQ(take<std::int32_t>(bytes), curve.polyline.surfacePoints[i].face);
        for (const double b : curve.polyline.surfacePoints[i].barycentric) {
            EXPECT_EQ(take<double>(bytes), b);
        }
        EXPECT_EQ(take<std::uint8_t>(bytes), i == 1 ? 0 : 1);
    }
    for (const std::int32_t id : {0, 1, 1, 2}) {
        EXPECT_EQ(take<std::int32_t>(bytes), id);
    }
    EXPECT_TRUE(bytes.empty());
}

TEST_F(CurveWriter, PlyOfAClosedCurveHasTheClosingEdge) {
    const std::string bytes = curveBytes("a.ply", smallCurve(true));
    expectContains(bytes, "element edge 3\n");
    EXPECT_EQ(bytes.substr(bytes.size() - 8), bytesOf(std::int32_t{2}) + bytesOf(std::int32_t{0}));
}

TEST_F(CurveWriter, ObjHoldsPointsExactlyAndSegmentsInOrder) {
    const Curve curve = smallCurve(true);
    std::istringstream lines(curveBytes("a.OBJ", curve));
    std::vector<Vec3> points;
    std::string segments;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "v") {
            Vec3 p;
            words >> p.x() >> p.y() >> p.z();
            points.push_back(p);
        } else if (keyword == "l") {
            segments += line + ";";
        }
    }
    EXPECT_EQ(points, curve.polyline.points);
    EXPECT_EQ(segments, "l 1 2;l 2 3;l 3 1;");
}

TEST_F(CurveWriter, QualityIsTWhereThereIsNoField) {
    const Curve curve = smallCurve(false);
    EXPECT_EQ(curveBytes("a.ply", curve), curveBytes("a.ply", curve, curve.polyline.parameters));
    EXPECT_EQ(curveBytes("a.csv", curve), curveBytes("a.csv", curve, curve.polyline.parameters));
}

TEST_F(CurveWriter, CsvHasALinePerVertexWithTheShortestExactNumbers) {
    EXPECT_EQ(
        curveBytes("a.csv", smallCurve(true), std::vector<double>{7, 8, 9.1}),
        "x,y,z,t,face,b0,b1,b2,quality,is_pick\n"
        "0.1,0.3333333333333333,-2e-09,0,0,0.1,0.2,0.7,7,1\n"
        "1,2,3,0.3,0,0.5,0,0.5,8,0\n"
        "4,5,0.1234567890123456,1,1,0.3333333333333333,0.3333333333333333,0.3333333333333333,9.1,1"
        "\n"
    );
}

TEST_F(CurveWriter, FreeFormObjHoldsTheSpline) {
    EXPECT_EQ(
        curveBytes("a.bspline.obj", smallCurve(false)),
        "# B-spline curve on a triangle mesh: its spline\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0.1 0\n"
        "cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 0 0 0 1 1 1 1\nend\n"
    );
}

TEST_F(CurveWriter, FreeFormObjOfAClosedCurveNamesTheFirstPointsAgain) {
    EXPECT_EQ(
        curveBytes("a.BSpline.OBJ", smallCurve(true)),
        "# B-spline curve on a triangle mesh: its spline\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0.1 0\n"
        "cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4 1 2 3\n"
        "parm u -0.75 -0.5 -0.25 0 0.25 0.5 0.75 1 1.25 1.5 1.75\nend\n"
    );
}

TEST_F(CurveWriter, DxfHoldsAClosed3dPolyline) {
    const std::string bytes = curveBytes("a.dxf", smallCurve(true));
    expectContains(bytes, "9\n$ACADVER\n1\nAC1009\n");
    expectContains(bytes, "9\n$EXTMIN\n10\n0.1\n20\n0.3333333333333333\n30\n-2e-09\n");
    expectContains(bytes, "70\n9\n0\nVERTEX\n8\nPOLYLINE\n10\n0.1\n20\n0.3333333333333333\n");
    expectContains(bytes, "10\n4.0\n20\n5.0\n30\n0.1234567890123456\n70\n32\n0\nSEQEND\n");
    expectContains(curveBytes("a.dxf", smallCurve(false)), "70\n8\n0\nVERTEX\n");
}

TEST_F(CurveWriter, SplineDxfIsClampedWhereTheCurveIsClosed) {
    const std::string bytes = curveBytes("a.bspline.dxf", smallCurve(true));
    expectContains(bytes, "1\nAC1015\n");
    expectContains(bytes, "100\nAcDbSpline\n70\n1\n71\n3\n72\n11\n73\n7\n74\n0\n");
    expectContains(bytes, "40\n0.0\n40\n0.0\n40\n0.0\n40\n0.0\n40\n0.25\n");
    expectContains(curveBytes("a.bspline.dxf", smallCurve(false)), "100\nAcDbSpline\n70\n0\n");
}

TEST_F(CurveWriter, JsonHoldsPolylineAndSplineExactly) {
    const Curve curve = smallCurve(true);
    writeCurve(path("a.json"), curve, std::vector<double>{1, 2, 3});
    const auto document = nlohmann::json::parse(read(path("a.json")));
    EXPECT_EQ(document["closed"], true);
    const auto& polyline = document["polyline"];
    EXPECT_EQ(
        polyline["points"].get<std::vector<std::vector<double>>>()[2],
        (std::vector<double>{4, 5, 0.1234567890123456})
    );
    EXPECT_EQ(polyline["faces"].get<std::vector<int>>(), (std::vector<int>{0, 0, 1}));
    EXPECT_EQ(
        polyline["barycentrics"][0].get<std::vector<double>>(), (std::vector<double>{0.1, 0.2, 0.7})
    );
    EXPECT_EQ(polyline["t"].get<std::vector<double>>(), curve.polyline.parameters);
    EXPECT_EQ(polyline["picks"].get<std::vector<int>>(), (std::vector<int>{0, 2}));
    EXPECT_EQ(polyline["quality"].get<std::vector<double>>(), (std::vector<double>{1, 2, 3}));
    const auto& spline = document["spline"];
    EXPECT_EQ(spline["degree"], 3);
    EXPECT_EQ(spline["closed"], true);
    EXPECT_EQ(spline["knots"].get<std::vector<double>>(), curve.spline.knots);
    EXPECT_EQ(
        spline["control_points"][3].get<std::vector<double>>(), (std::vector<double>{3, 0.1, 0})
    );
    EXPECT_EQ(spline["pick_parameters"].get<std::vector<double>>(), curve.spline.pickParameters);
    EXPECT_FALSE(document.contains("mesh"));
}

TEST_F(CurveWriter, JsonNamesTheMeshWhereItIsGiven) {
    const MeshChecksum mesh{.vertices = 5, .faces = 6, .crc32 = 0xab};
    writeCurve(path("a.json"), smallCurve(true), {}, mesh);
    const auto document = nlohmann::json::parse(read(path("a.json")));
    EXPECT_EQ(document["mesh"].dump(), R"({"crc32":"000000ab","faces":6,"vertices":5})");
}

TEST_F(CurveWriter, RefusesOtherExtensionsAndPlaces) {
    const auto refused = [&](const std::filesystem::path& file) {
        return refusal(
            [&] {
                writeCurve(file, smallCurve(false));
                return 0;
            },
            InputErrorCode::UnwritableFile
        );
    };
    expectContains(
        refused(path("a.txt")),
        "\".txt\" of the output is none of .ply, .bspline.obj, .obj, .bspline.dxf, .dxf, .vtu, "
        ".csv, "
        ".polyline.step, "
    );
    refused(path(".ply"));
    refused(path("ply"));
    expectContains(refused(path("none/a.ply")), "does not exist");
    EXPECT_EQ(fileCount(), 0U);
}

}  // namespace bspline_curve::io_tests
