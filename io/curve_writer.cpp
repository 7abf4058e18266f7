// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_writer.h"

#include "io/append_binary.h"
#include "io/atomic_file.h"
#include "io/text_parsing.h"
#include "surface/input_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace bspline_curve {

namespace {

using Quality = std::span<const double>;
using std::filesystem::path;

/// Segments as pairs of vertices, in order along the curve; the last of a closed one leads back to
/// vertex 0.
std::vector<std::pair<std::size_t, std::size_t>> segments(const SurfacePolyline& polyline) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        result.emplace_back(i, i + 1);
    }
    if (polyline.closed && count > 1) {
        result.emplace_back(count - 1, 0);
    }
    return result;
}

std::string plyBytes(const Curve& curve, Quality quality) {
    const SurfacePolyline& polyline = curve.polyline;
    const auto edges = segments(polyline);
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment B-spline curve on a triangle mesh\n"
        "element vertex " +
        std::to_string(polyline.points.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nproperty double t\n"
        "property int face\nproperty double barycentric_0\nproperty double barycentric_1\n"
        "property double barycentric_2\n" +
        (quality.empty() ? "" : "property double quality\n") + "element edge " +
        std::to_string(edges.size()) + "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        for (const double x : polyline.points[i]) {
            appendBinary(bytes, x);
        }
        appendBinary(bytes, polyline.parameters[i]);
        appendBinary(bytes, static_cast<std::int32_t>(polyline.surfacePoints[i].face));
        for (const double b : polyline.surfacePoints[i].barycentric) {
            appendBinary(bytes, b);
        }
        if (!quality.empty()) {
            appendBinary(bytes, quality[i]);
        }
    }
    for (const auto& [from, to] : edges) {
        appendBinary(bytes, static_cast<std::int32_t>(from));
        appendBinary(bytes, static_cast<std::int32_t>(to));
    }
    return bytes;
}

std::string objBytes(const Curve& curve) {
    std::string bytes = "# B-spline curve on a triangle mesh\n";
    std::array<char, 96> line{};
    for (const Vec3& p : curve.polyline.points) {
        const int length =
            std::snprintf(line.data(), line.size(), "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
        bytes.append(line.data(), static_cast<std::size_t>(length));
    }
    for (const auto& [from, to] : segments(curve.polyline)) {
        bytes += "l " + std::to_string(from + 1) + ' ' + std::to_string(to + 1) + '\n';
    }
    return bytes;
}

nlohmann::json points(const std::vector<Vec3>& list) {
    nlohmann::json result = nlohmann::json::array();
    for (const Vec3& p : list) {
        result.push_back({p.x(), p.y(), p.z()});
    }
    return result;
}

std::string jsonBytes(const Curve& curve, Quality quality) {
    const SurfacePolyline& polyline = curve.polyline;
    nlohmann::json faces = nlohmann::json::array();
    std::vector<Vec3> barycentrics;
    for (const SurfacePoint& point : polyline.surfacePoints) {
        faces.push_back(point.face);
        barycentrics.push_back(point.barycentric);
    }
    nlohmann::ordered_json document;
    document["closed"] = polyline.closed;
    document["polyline"] = {
        {"points", points(polyline.points)},
        {"faces", faces},
        {"barycentrics", points(barycentrics)},
        {"t", polyline.parameters},
    };
    if (!quality.empty()) {
        document["polyline"]["quality"] = std::vector<double>(quality.begin(), quality.end());
    }
    document["spline"] = {
        {"degree", curve.spline.degree},
        {"knots", curve.spline.knots},
        {"control_points", points(curve.spline.controlPoints)},
        {"pick_parameters", curve.spline.pickParameters},
    };
    return document.dump() + "\n";
}

}  // namespace

std::vector<double> fieldAlong(
    const SurfacePolyline& polyline,
    const std::vector<Triangle>& faces,
    std::span<const double> field
) {
    std::vector<double> values;
    values.reserve(polyline.surfacePoints.size());
    for (const SurfacePoint& point : polyline.surfacePoints) {
        const Triangle& face = faces[static_cast<std::size_t>(point.face)];
        double value = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            value += point.barycentric[static_cast<Eigen::Index>(k)] *
                     field[static_cast<std::size_t>(face[k])];
        }
        values.push_back(value);
    }
    return values;
}

void checkCurveExtension(const path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".ply" && extension != ".obj" && extension != ".json") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": the extension " + inQuotes(extension) +
                " of the output is none of .ply, .obj, .json"
        );
    }
}

std::string curveBytes(const path& file, const Curve& curve, Quality quality) {
    checkCurveExtension(file);
    assert(curve.polyline.surfacePoints.size() == curve.polyline.points.size());
    assert(curve.polyline.parameters.size() == curve.polyline.points.size());
    assert(quality.empty() || quality.size() == curve.polyline.points.size());
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".ply") {
        return plyBytes(curve, quality);
    }
    return extension == ".obj" ? objBytes(curve) : jsonBytes(curve, quality);
}

void writeCurve(const path& file, const Curve& curve, Quality quality) {
    AtomicFile(file, curveBytes(file, curve, quality)).commit();
}

}  // namespace bspline_curve
