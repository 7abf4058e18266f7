// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/curve_formats.h"

#include <cstdint>

namespace bspline_curve {

std::string curvePly(const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    const auto edges = segmentsOf(polyline);
    const std::vector<char> isPick = pickFlags(polyline);
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment B-spline curve on a triangle mesh\n"
        "element vertex " +
        std::to_string(polyline.points.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nproperty double quality\n"
        "property double t\nproperty int face\nproperty double barycentric_0\n"
        "property double barycentric_1\nproperty double barycentric_2\nproperty uchar is_pick\n"
        "element edge " +
        std::to_string(edges.size()) + "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        for (const double x : polyline.points[i]) {
            appendBinary(bytes, x);
        }
        appendBinary(bytes, content.quality()[i]);
        appendBinary(bytes, polyline.parameters[i]);
        appendBinary(bytes, static_cast<std::int32_t>(polyline.surfacePoints[i].face));
        for (const double b : polyline.surfacePoints[i].barycentric) {
            appendBinary(bytes, b);
        }
        appendBinary(bytes, isPick[i]);
    }
    for (const auto& [from, to] : edges) {
        appendBinary(bytes, static_cast<std::int32_t>(from));
        appendBinary(bytes, static_cast<std::int32_t>(to));
    }
    return bytes;
}

}  // namespace bspline_curve
