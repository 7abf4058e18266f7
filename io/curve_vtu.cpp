// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"
#include "io/vtk_array.h"

#include <cstdint>

namespace bspline_curve {

namespace {

std::string pointData(const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    const std::size_t count = polyline.points.size();
    const std::span<const double> quality = content.quality();
    const std::vector<char> isPick = pickFlags(polyline);
    const auto face = [&](std::size_t i) { return polyline.surfacePoints[i].face; };
    const auto barycentric = [&](std::size_t i) {
        return polyline.surfacePoints[i / 3].barycentric[static_cast<Eigen::Index>(i % 3)];
    };
    return "<PointData Scalars=\"quality\">\n" +
           vtkArray<double>(
               "Float64", "quality", 1, count, [&](std::size_t i) { return quality[i]; }
           ) +
           vtkArray<double>(
               "Float64", "t", 1, count, [&](std::size_t i) { return polyline.parameters[i]; }
           ) +
           vtkArray<std::int32_t>("Int32", "face", 1, count, face) +
           vtkArray<double>("Float64", "barycentric", 3, 3 * count, barycentric) +
           vtkArray<std::uint8_t>(
               "UInt8", "is_pick", 1, count, [&](std::size_t i) { return isPick[i]; }
           ) +
           "</PointData>\n";
}

}  // namespace

std::string curveVtu(const CurveContent& content) {
    constexpr int kVtkLine = 3;
    const std::vector<Vec3>& points = content.curve.polyline.points;
    const auto segments = segmentsOf(content.curve.polyline);
    const auto coordinate = [&](std::size_t i) {
        return points[i / 3][static_cast<Eigen::Index>(i % 3)];
    };
    const auto corner = [&](std::size_t i) {
        return i % 2 == 0 ? segments[i / 2].first : segments[i / 2].second;
    };
    return std::string(kVtuStart) + "<Piece NumberOfPoints=\"" + std::to_string(points.size()) +
           "\" NumberOfCells=\"" + std::to_string(segments.size()) + "\">\n" + pointData(content) +
           "<Points>\n" + vtkArray<double>("Float64", "Points", 3, 3 * points.size(), coordinate) +
           "</Points>\n<Cells>\n" +
           vtkArray<std::int32_t>("Int32", "connectivity", 1, 2 * segments.size(), corner) +
           vtkArray<std::int32_t>(
               "Int32", "offsets", 1, segments.size(), [](std::size_t i) { return 2 * (i + 1); }
           ) +
           vtkArray<std::uint8_t>(
               "UInt8", "types", 1, segments.size(), [](std::size_t) { return kVtkLine; }
           ) +
           "</Cells>\n" + kVtuEnd;
}

}  // namespace bspline_curve
