// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_reader.h"

#include "bspline_curve/error.h"
#include "io/curve_json.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/surface_point.h"
#include "text/json_reader.h"
#include "text/text_parsing.h"

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
    const std::filesystem::path& file, const nlohmann::json& document, const Surface& surface
) {
    const TriangleMesh& mesh = surface.input();
    SurfacePolyline line = polylineOfJson(file, document);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const SurfacePoint& point = line.surfacePoints[i];
        if (point.face >= static_cast<int>(mesh.faces.size())) {
            refuseMesh(
                file,
                i,
                "is in face " + std::to_string(point.face) + " of " +
                    std::to_string(mesh.faces.size())
            );
        }
        const double gap = (positionOf(mesh, point) - line.points[i]).norm();
        if (gap > kSamePositionRelative * surface.diagonal()) {
            refuseMesh(file, i, "has moved by " + std::to_string(gap));
        }
    }
    checkLine(surface, line, file.string());
    return line;
}

}  // namespace

std::vector<SurfacePolyline> readCurves(
    const std::filesystem::path& file, const Surface& surface, const MeshChecksum& mesh
) {
    if (lowerCaseExtension(file) != ".json") {
        refuseFile(file, "curves are read from .json; write the curve with --output CURVE.json");
    }
    const nlohmann::json document = jsonOfBytes(file, readWholeFile(file));
    if (document.is_object()) {
        checkMesh(file, document, mesh);
    }
    if (!document.is_object() || !document.contains("curves")) {
        return {curveOf(file, document, surface)};
    }
    const nlohmann::json& list = document.at("curves");
    if (!list.is_array() || list.empty()) {
        refuseFile(file, R"("curves" is no list of curves)");
    }
    std::vector<SurfacePolyline> curves;
    for (const nlohmann::json& curve : list) {
        const std::string name = file.string() + ", curve " + std::to_string(curves.size());
        curves.push_back(curveOf(name, curve, surface));
    }
    return curves;
}

std::vector<std::optional<SplineData>> readSplines(const std::filesystem::path& file) {
    const nlohmann::json document = jsonOfBytes(file, readWholeFile(file));
    const auto splineIn = [&](const nlohmann::json& curve) {
        return curve.is_object() && curve.contains("spline")
                   ? std::optional(splineOfJson(file, curve.at("spline")))
                   : std::nullopt;
    };
    std::vector<std::optional<SplineData>> splines;
    if (document.is_object() && document.contains("curves")) {
        for (const nlohmann::json& curve : document.at("curves")) {
            splines.push_back(splineIn(curve));
        }
    } else {
        splines.push_back(splineIn(document));
    }
    return splines;
}

SurfacePolyline readCurve(
    const std::filesystem::path& file, const Surface& surface, const MeshChecksum& mesh
) {
    std::vector<SurfacePolyline> curves = readCurves(file, surface, mesh);
    if (curves.size() != 1) {
        refuseFile(
            file, "has " + std::to_string(curves.size()) + " curves, and one is needed here"
        );
    }
    return std::move(curves.front());
}

}  // namespace bspline_curve
