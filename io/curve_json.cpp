// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_json.h"

#include "bspline_curve/spline.h"
#include "io/picks_formats.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace bspline_curve {

namespace {

/// Barycentric coordinates of a file sum to 1 as exactly as rounding allows.
constexpr double kBarycentricTolerance = 1e-9;

Json polylineJson(const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    Json result = surfacePointsJson(polyline.points, polyline.surfacePoints);
    result["t"] = polyline.parameters;
    result["picks"] = polyline.picks;
    if (!content.field.empty()) {
        result["quality"] = std::vector<double>(content.field.begin(), content.field.end());
    }
    return result;
}

void addMesh(Json& document, const std::optional<MeshChecksum>& mesh) {
    if (mesh) {
        document["mesh"] = meshJson(*mesh);
    }
}

// ---- Reading ----

using nlohmann::json;
using std::filesystem::path;

const json& memberOf(const path& file, const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key)) {
        refuseFile(
            file, std::string("has no \"") + key + "\"; write the curve with --output CURVE.json"
        );
    }
    return object.at(key);
}

const json& arrayOf(
    const path& file, const json& object, const char* key, const std::string& name
) {
    if (!object.is_object() || !object.contains(key) || !object.at(key).is_array()) {
        refuseFile(
            file,
            std::string("no list \"") + key + "\" in \"" + name +
                "\"; write the curve with --output CURVE.json"
        );
    }
    return object.at(key);
}

double numberOf(const path& file, const json& value, const std::string& name) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
        refuseFile(file, name + " is not a finite number");
    }
    return value.get<double>();
}

std::vector<double> numbersOf(
    const path& file, const json& object, const char* key, const char* name
) {
    std::vector<double> numbers;
    for (const json& value : arrayOf(file, object, key, name)) {
        numbers.push_back(
            numberOf(file, value, std::string(key) + " " + std::to_string(numbers.size()))
        );
    }
    return numbers;
}

/// A whole number in [0, most].
int indexOf(const path& file, const json& value, std::size_t most, const std::string& name) {
    if (!value.is_number_integer()) {
        refuseFile(file, name + " is not a whole number");
    }
    const auto index = value.get<std::int64_t>();
    if (index < 0 || static_cast<std::uint64_t>(index) > most) {
        refuseFile(
            file,
            name + " is " + std::to_string(index) + ", not in [0, " + std::to_string(most) + "]"
        );
    }
    return static_cast<int>(index);
}

}  // namespace

// ---- Writing ----

Json pointsJson(const std::vector<Vec3>& points) {
    Json result = Json::array();
    for (const Vec3& p : points) {
        result.push_back({p.x(), p.y(), p.z()});
    }
    return result;
}

Json surfacePointsJson(
    const std::vector<Vec3>& positions, const std::vector<SurfacePoint>& points
) {
    Json faces = Json::array();
    std::vector<Vec3> barycentrics;
    for (const SurfacePoint& point : points) {
        faces.push_back(point.face);
        barycentrics.push_back(point.barycentric);
    }
    return {
        {"points", pointsJson(positions)},
        {"faces", std::move(faces)},
        {"barycentrics", pointsJson(barycentrics)},
    };
}

Json contentJson(const CurveContent& content) {
    const SplineData& spline = content.curve.spline;
    Json result = {
        {"closed", content.curve.polyline.closed},
        {"polyline", polylineJson(content)},
        {"spline",
         {{"degree", spline.degree},
          {"closed", spline.closed},
          {"knots", spline.knots},
          {"control_points", pointsJson(spline.controlPoints)},
          {"pick_parameters", spline.pickParameters}}},
    };
    addTangents(tangentsAtPicks(content.curve), result);
    return result;
}

void addTangents(const std::vector<std::pair<int, PickTangent>>& tangents, Json& curve) {
    for (const auto& [pick, tangent] : tangents) {
        Json entry = {{"pick", pick}};
        const auto add = [&](const char* key, const Vec3& direction) {
            if (!direction.isZero(0.0)) {
                entry[key] = {direction.x(), direction.y(), direction.z()};
            }
        };
        if (tangent.isOne()) {
            add("direction", tangent.after);
        } else {
            add("before", tangent.before);
            add("after", tangent.after);
        }
        curve["tangents"].push_back(std::move(entry));
    }
}

Json meshJson(const MeshChecksum& mesh) {
    return {{"vertices", mesh.vertices}, {"faces", mesh.faces}, {"crc32", mesh.digits()}};
}

std::string curveJson(const CurveContent& content) {
    Json document = contentJson(content);
    addMesh(document, content.mesh);
    return document.dump() + "\n";
}

std::string curvesJson(std::span<const CurveContent> contents) {
    Json curves = Json::array();
    for (const CurveContent& content : contents) {
        curves.push_back(contentJson(content));
    }
    Json document = {{"curves", std::move(curves)}};
    addMesh(document, contents.empty() ? std::nullopt : contents.front().mesh);
    return document.dump() + "\n";
}

// ---- Reading ----

std::optional<MeshChecksum> meshOfJson(const path& file, const json& document) {
    if (!document.is_object() || !document.contains("mesh")) {
        return std::nullopt;
    }
    const json& named = document.at("mesh");
    const auto count = [&](const char* key) {
        if (!named.is_object() || !named.contains(key) || !named.at(key).is_number_integer()) {
            refuseFile(file, std::string("no whole number \"") + key + R"(" in "mesh")");
        }
        return named.at(key).get<std::int64_t>();
    };
    MeshChecksum mesh{.vertices = count("vertices"), .faces = count("faces")};
    constexpr std::size_t kDigits = 8;
    constexpr int kHexadecimal = 16;
    const std::string digits = named.contains("crc32") && named.at("crc32").is_string()
                                   ? named.at("crc32").get<std::string>()
                                   : std::string();
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, mesh.crc32, kHexadecimal);
    if (digits.size() != kDigits || error != std::errc() || stop != end) {
        refuseFile(file, R"(no 8 hexadecimal digits "crc32" in "mesh")");
    }
    return mesh;
}

SurfacePoint surfacePointOfJson(
    const path& file, const json& face, const json& barycentric, const std::string& name
) {
    constexpr int kMost = std::numeric_limits<int>::max();
    const int index = indexOf(file, face, kMost, "the face of " + name);
    const Vec3 coordinates = pointOfJson(file, barycentric, "barycentrics of " + name);
    if (coordinates.minCoeff() < -kBarycentricTolerance ||
        std::abs(coordinates.sum() - 1.0) > kBarycentricTolerance) {
        refuseFile(
            file, "the barycentric coordinates of " + name + " are not in [0, 1] with the sum 1"
        );
    }
    return {.face = index, .barycentric = coordinates};
}

PointsOfJson surfacePointsOfJson(
    const path& file,
    const json& value,
    const std::string& list,
    std::string (*nameOf)(std::size_t index)
) {
    const json& points = arrayOf(file, value, "points", list);
    const json& faces = arrayOf(file, value, "faces", list);
    const json& barycentrics = arrayOf(file, value, "barycentrics", list);
    if (points.size() != faces.size() || points.size() != barycentrics.size()) {
        refuseFile(file, R"("points", "faces" and "barycentrics" must be of one length)");
    }
    PointsOfJson read;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string name = nameOf(i);
        read.points.push_back(surfacePointOfJson(file, faces[i], barycentrics[i], name));
        read.positions.push_back(pointOfJson(file, points[i], "position of " + name));
    }
    return read;
}

bool flagOfJson(const path& file, const json& object, const char* key) {
    const json& value = memberOf(file, object, key);
    if (!value.is_boolean()) {
        refuseFile(file, std::string("\"") + key + "\" must be true or false");
    }
    return value.get<bool>();
}

SurfacePolyline polylineOfJson(const path& file, const json& document) {
    const json& polyline = memberOf(file, document, "polyline");
    SurfacePolyline line;
    line.closed = flagOfJson(file, document, "closed");
    PointsOfJson read = surfacePointsOfJson(file, polyline, "polyline", [](std::size_t index) {
        return "vertex " + std::to_string(index);
    });
    const std::size_t count = read.points.size();
    if (count < 2) {
        refuseFile(file, "a curve of less than 2 points");
    }
    line.points = std::move(read.positions);
    line.surfacePoints = std::move(read.points);
    if (polyline.contains("t") && polyline.at("t").is_array() && polyline.at("t").size() == count) {
        for (const json& t : polyline.at("t")) {
            line.parameters.push_back(
                numberOf(file, t, "t of vertex " + std::to_string(line.parameters.size()))
            );
        }
    } else {
        for (std::size_t i = 0; i < count; ++i) {
            line.parameters.push_back(static_cast<double>(i) / static_cast<double>(count));
        }
    }
    if (polyline.contains("picks")) {
        for (const json& pick : arrayOf(file, polyline, "picks", "polyline")) {
            line.picks.push_back(indexOf(
                file, pick, count - 1, "vertex of " + describePicks({std::ssize(line.picks)})
            ));
        }
    }
    return line;
}

SplineData splineOfJson(const path& file, const json& value) {
    constexpr std::size_t kHighestDegree = 100;
    SplineData spline;
    spline.degree = indexOf(file, memberOf(file, value, "degree"), kHighestDegree, "degree");
    spline.closed = flagOfJson(file, value, "closed");
    spline.knots = numbersOf(file, value, "knots", "spline");
    for (const json& point : arrayOf(file, value, "control_points", "spline")) {
        spline.controlPoints.push_back(
            pointOfJson(file, point, "control point " + std::to_string(spline.controlPoints.size()))
        );
    }
    spline.pickParameters = numbersOf(file, value, "pick_parameters", "spline");
    return spline;
}

}  // namespace bspline_curve
