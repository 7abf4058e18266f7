// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_writer.h"

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
    expectContains(header, "property double quality\n");
    bytes.erase(0, header.size() + end.size());
    for (std::size_t i = 0; i < 3; ++i) {
        for (const double x : curve.polyline.points[i]) {
            EXPECT_EQ(take<double>(bytes), x);
        }
        EXPECT_EQ(take<double>(bytes), curve.polyline.parameters[i]);
        EXPECT_EQ(take<std::int32_t>(bytes), curve.polyline.surfacePoints[i].face);
        for (const double b : curve.polyline.surfacePoints[i].barycentric) {
            EXPECT_EQ(take<double>(bytes), b);
        }
        EXPECT_EQ(take<double>(bytes), quality[i]);
    }
    for (const std::int32_t id : {0, 1, 1, 2}) {
        EXPECT_EQ(take<std::int32_t>(bytes), id);
    }
    EXPECT_TRUE(bytes.empty());
}

TEST_F(CurveWriter, PlyOfAClosedCurveHasTheClosingEdge) {
    const std::string bytes = curveBytes("a.ply", smallCurve(true));
    expectContains(bytes, "element edge 3\n");
    EXPECT_EQ(bytes.find("quality"), std::string::npos);
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
    EXPECT_EQ(polyline["quality"].get<std::vector<double>>(), (std::vector<double>{1, 2, 3}));
    const auto& spline = document["spline"];
    EXPECT_EQ(spline["degree"], 3);
    EXPECT_EQ(spline["knots"].get<std::vector<double>>(), curve.spline.knots);
    EXPECT_EQ(
        spline["control_points"][3].get<std::vector<double>>(), (std::vector<double>{3, 0.1, 0})
    );
    EXPECT_EQ(spline["pick_parameters"].get<std::vector<double>>(), curve.spline.pickParameters);
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
    expectContains(refused(path("a.txt")), ".txt");
    expectContains(refused(path("none/a.ply")), "does not exist");
    EXPECT_EQ(fileCount(), 0U);
}

TEST_F(CurveWriter, InterpolatesAFieldInTheFace) {
    const std::vector<Triangle> faces{{0, 1, 2}, {1, 3, 2}};
    const std::vector<double> field{1, 10, 100, 1000};
    const auto values = fieldAlong(smallCurve(false).polyline, faces, field);
    ASSERT_EQ(values.size(), 3U);
    EXPECT_DOUBLE_EQ(values[0], 0.1 * 1 + 0.2 * 10 + 0.7 * 100);
    EXPECT_DOUBLE_EQ(values[1], 0.5 * 1 + 0.5 * 100);
    EXPECT_DOUBLE_EQ(values[2], (10.0 + 1000 + 100) / 3);
}

}  // namespace bspline_curve::io_tests
