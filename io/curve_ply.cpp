// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/curve_formats.h"

#include <cstdint>

namespace bspline_curve {

namespace {

void appendVertices(std::string& bytes, const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    const std::vector<char> isPick = pickFlags(polyline);
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
}

}  // namespace

std::string curvePly(std::span<const CurveContent> contents) {
    std::size_t vertexCount = 0;
    std::size_t edgeCount = 0;
    std::string vertices;
    std::string edges;
    for (const CurveContent& content : contents) {
        appendVertices(vertices, content);
        for (const auto& [from, to] : segmentsOf(content.curve.polyline)) {
            appendBinary(edges, static_cast<std::int32_t>(vertexCount + from));
            appendBinary(edges, static_cast<std::int32_t>(vertexCount + to));
            ++edgeCount;
        }
        vertexCount += content.curve.polyline.points.size();
    }
    return "ply\nformat binary_little_endian 1.0\ncomment B-spline curve on a triangle mesh\n"
           "element vertex " +
           std::to_string(vertexCount) +
           "\nproperty double x\nproperty double y\nproperty double z\nproperty double quality\n"
           "property double t\nproperty int face\nproperty double barycentric_0\n"
           "property double barycentric_1\nproperty double barycentric_2\nproperty uchar is_pick\n"
           "element edge " +
           std::to_string(edgeCount) +
           "\nproperty int vertex1\nproperty int vertex2\nend_header\n" + vertices + edges;
}

}  // namespace bspline_curve
