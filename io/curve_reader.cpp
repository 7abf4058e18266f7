// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_reader.h"

#include "bspline_curve/error.h"
#include "design/strict_polyline.h"
#include "io/json_reader.h"
#include "io/picks_formats.h"
#include "io/text_parsing.h"
#include "surface/points_on_mended.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Positions that differ by more are those of another mesh (relative to the diagonal).
constexpr double kSamePositionRelative = 1e-6;
/// Barycentric coordinates of a file sum to 1 as exactly as rounding allows.
constexpr double kBarycentricTolerance = 1e-9;

const nlohmann::json& arrayIn(
    const std::filesystem::path& file, const nlohmann::json& object, const char* key
) {
    if (!object.is_object() || !object.contains(key) || !object.at(key).is_array()) {
        refuseFile(
            file,
            std::string("no list \"") + key +
                "\" in \"polyline\"; write the curve with --output "
                "CURVE.json"
        );
    }
    return object.at(key);
}

[[noreturn]] void refuseMesh(
    const std::filesystem::path& file, std::size_t vertex, const std::string& reason
) {
    throw InputError(
        InputErrorCode::NoPath,
        file.string() + ": the curve does not lie on this mesh: vertex " + std::to_string(vertex) +
            " of it " + reason + "; give the mesh that it was drawn on, or draw it again",
        {static_cast<std::int64_t>(vertex)}
    );
}

/// What the curves of a file are to lie on.
struct FileMesh {
    const Surface& surface;
    std::int64_t givenFaces;
    std::optional<PointsOnMended> mended{};  ///< where the surface is not the mesh as it was given
};

SurfacePoint pointOf(
    const std::filesystem::path& file,
    const nlohmann::json& face,
    const nlohmann::json& barycentric,
    std::size_t vertex,
    const FileMesh& mesh
) {
    const std::string name = "vertex " + std::to_string(vertex);
    if (!face.is_number_integer()) {
        refuseFile(file, "the face of " + name + " is not a whole number");
    }
    const auto index = face.get<std::int64_t>();
    if (index < 0 || index >= mesh.givenFaces) {
        refuseMesh(
            file,
            vertex,
            "is in face " + std::to_string(index) + " of " + std::to_string(mesh.givenFaces)
        );
    }
    const Vec3 coordinates = pointOfJson(file, barycentric, "barycentrics of " + name);
    if (coordinates.minCoeff() < -kBarycentricTolerance ||
        std::abs(coordinates.sum() - 1.0) > kBarycentricTolerance) {
        refuseFile(
            file, "the barycentric coordinates of " + name + " are not in [0, 1] with the sum 1"
        );
    }
    std::optional<SurfacePoint> point{
        {.face = static_cast<int>(index), .barycentric = coordinates}
    };
    if (mesh.mended) {
        point = mesh.mended->pointAt(*point);
    }
    if (!point) {
        refuseMesh(
            file, vertex, "is in face " + std::to_string(index) + ", which the mended mesh has not"
        );
    }
    return *point;
}

/// Refuses a curve of another mesh, where the file names its own.
void checkMesh(
    const std::filesystem::path& file, const nlohmann::json& document, const MeshChecksum& mesh
) {
    if (!document.contains("mesh")) {
        return;
    }
    const nlohmann::json& named = document.at("mesh");
    const auto count = [&](const char* key) {
        if (!named.is_object() || !named.contains(key) || !named.at(key).is_number_integer()) {
            refuseFile(file, std::string("no whole number \"") + key + R"(" in "mesh")");
        }
        return named.at(key).get<std::int64_t>();
    };
    const MeshChecksum then{
        .vertices = count("vertices"), .faces = count("faces"), .crc32 = mesh.crc32
    };
    if (!named.contains("crc32") || !named.at("crc32").is_string()) {
        refuseFile(file, R"(no text "crc32" in "mesh")");
    }
    if (then == mesh && named.at("crc32").get<std::string>() == mesh.digits()) {
        return;
    }
    throw InputError(
        InputErrorCode::NoPath,
        file.string() + ": the mesh changed since the curve was drawn: " +
            describeChange(then, mesh) + "; give the mesh that it was drawn on, or draw it again"
    );
}

/// `file`: as messages name it.
SurfacePolyline curveOf(
    const std::filesystem::path& file, const nlohmann::json& document, const FileMesh& mesh
) {
    const Surface& surface = mesh.surface;
    if (!document.is_object() || !document.contains("polyline") || !document.contains("closed") ||
        !document.at("closed").is_boolean()) {
        refuseFile(
            file,
            "has no \"polyline\" and \"closed\"; write the curve with --output "
            "CURVE.json"
        );
    }
    const nlohmann::json& polyline = document.at("polyline");
    const nlohmann::json& points = arrayIn(file, polyline, "points");
    const nlohmann::json& faces = arrayIn(file, polyline, "faces");
    const nlohmann::json& barycentrics = arrayIn(file, polyline, "barycentrics");
    if (points.size() != faces.size() || points.size() != barycentrics.size() ||
        points.size() < 2) {
        refuseFile(
            file, R"("points", "faces" and "barycentrics" must be of one length, at least 2)"
        );
    }
    SurfacePolyline line;
    line.closed = document.at("closed").get<bool>();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint point = pointOf(file, faces[i], barycentrics[i], i, mesh);
        const Vec3 position = pointOfJson(file, points[i], "point " + std::to_string(i));
        const double gap = (surface.position(point) - position).norm();
        if (gap > kSamePositionRelative * surface.diagonal()) {
            refuseMesh(file, i, "has moved by " + std::to_string(gap));
        }
        line.surfacePoints.push_back(point);
        line.points.push_back(position);
        line.parameters.push_back(static_cast<double>(i) / static_cast<double>(points.size()));
    }
    if (polyline.contains("t") && polyline.at("t").is_array() &&
        polyline.at("t").size() == points.size()) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!polyline.at("t")[i].is_number()) {
                refuseFile(file, "t of vertex " + std::to_string(i) + " is not a number");
            }
            line.parameters[i] = polyline.at("t")[i].get<double>();
        }
    }
    if (mesh.mended) {
        checkUnparted(surface, line, file.string());
    } else if (!isStrict(surface, line)) {
        throw InputError(
            InputErrorCode::NoPath,
            file.string() +
                ": a segment of the curve is not in one face of this mesh; give the mesh that it "
                "was drawn on, or draw it again"
        );
    }
    return line;
}

}  // namespace

std::vector<SurfacePolyline> readCurves(
    const std::filesystem::path& file,
    const Surface& surface,
    const MeshChecksum& mesh,
    const MeshRepair* repair
) {
    if (lowerCaseExtension(file) != ".json") {
        refuseFile(file, "curves are read from .json; write the curve with --output CURVE.json");
    }
    const nlohmann::json document = jsonOfBytes(file, readWholeFile(file));
    if (document.is_object()) {
        checkMesh(file, document, mesh);
    }
    FileMesh on{.surface = surface, .givenFaces = mesh.faces};
    if (repair != nullptr) {
        on.mended.emplace(*repair);
    }
    if (!document.is_object() || !document.contains("curves")) {
        return {curveOf(file, document, on)};
    }
    const nlohmann::json& list = document.at("curves");
    if (!list.is_array() || list.empty()) {
        refuseFile(file, R"("curves" is no list of curves)");
    }
    std::vector<SurfacePolyline> curves;
    for (const nlohmann::json& curve : list) {
        const std::string name = file.string() + ", curve " + std::to_string(curves.size());
        curves.push_back(curveOf(name, curve, on));
    }
    return curves;
}

SurfacePolyline readCurve(
    const std::filesystem::path& file,
    const Surface& surface,
    const MeshChecksum& mesh,
    const MeshRepair* repair
) {
    std::vector<SurfacePolyline> curves = readCurves(file, surface, mesh, repair);
    if (curves.size() != 1) {
        refuseFile(
            file, "has " + std::to_string(curves.size()) + " curves, and one is needed here"
        );
    }
    return std::move(curves.front());
}

}  // namespace bspline_curve
