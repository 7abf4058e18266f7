// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_reader.h"

#include "bspline_curve/error.h"
#include "design/strict_polyline.h"
#include "io/curve_json.h"
#include "io/json_reader.h"
#include "io/text_parsing.h"
#include "surface/points_on_mended.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Positions that differ by more are those of another mesh (relative to the diagonal).
constexpr double kSamePositionRelative = 1e-6;

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

/// A vertex of a curve on what it is to lie on.
SurfacePoint pointOf(
    const std::filesystem::path& file,
    const SurfacePoint& given,
    std::size_t vertex,
    const FileMesh& mesh
) {
    const auto face = [&] { return "is in face " + std::to_string(given.face); };
    if (given.face >= mesh.givenFaces) {
        refuseMesh(file, vertex, face() + " of " + std::to_string(mesh.givenFaces));
    }
    const std::optional<SurfacePoint> point = mesh.mended ? mesh.mended->pointAt(given) : given;
    if (!point) {
        refuseMesh(file, vertex, face() + ", which the mended mesh has not");
    }
    return *point;
}

/// Refuses a curve of another mesh, where the file names its own.
void checkMesh(
    const std::filesystem::path& file, const nlohmann::json& document, const MeshChecksum& mesh
) {
    const std::optional<MeshChecksum> then = meshOfJson(file, document);
    if (!then || *then == mesh) {
        return;
    }
    throw InputError(
        InputErrorCode::NoPath,
        file.string() + ": the mesh changed since the curve was drawn: " +
            describeChange(*then, mesh) + "; give the mesh that it was drawn on, or draw it again"
    );
}

/// `file`: as messages name it.
SurfacePolyline curveOf(
    const std::filesystem::path& file, const nlohmann::json& document, const FileMesh& mesh
) {
    const Surface& surface = mesh.surface;
    SurfacePolyline line = polylineOfJson(file, document);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        line.surfacePoints[i] = pointOf(file, line.surfacePoints[i], i, mesh);
        const double gap = (surface.position(line.surfacePoints[i]) - line.points[i]).norm();
        if (gap > kSamePositionRelative * surface.diagonal()) {
            refuseMesh(file, i, "has moved by " + std::to_string(gap));
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
