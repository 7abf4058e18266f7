// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "io/curve_formats.h"
#include "text/json_text.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Parts of curve files in JSON. Readers throw InputError (UnreadableFile) naming the file.
namespace bspline_curve {

/// [[x, y, z], …], without loss.
[[nodiscard]] Json pointsJson(const std::vector<Vec3>& points);

/// {"points", "faces", "barycentrics"}: points of a surface.
[[nodiscard]] Json surfacePointsJson(
    const std::vector<Vec3>& positions, const std::vector<SurfacePoint>& points
);

/// {"closed", "polyline", "spline"}, and "tangents" where picks have any.
[[nodiscard]] Json contentJson(const CurveContent& content);

/// Writes "tangents" of picks into a curve: [{"pick", "direction"}, …], of corners with two
/// directions {"pick", "before", "after"}, or one of these; nothing where there are none.
void addTangents(const std::vector<std::pair<int, PickTangent>>& tangents, Json& curve);

/// {"vertices", "faces", "crc32"}.
[[nodiscard]] Json meshJson(const MeshChecksum& mesh);

/// The "mesh" of a document; none where it names none.
[[nodiscard]] std::optional<MeshChecksum> meshOfJson(
    const std::filesystem::path& file, const nlohmann::json& document
);

/// The surface point of a face and of barycentric coordinates, which are in [0, 1] with the sum 1;
/// `name` says in messages what that is. Any face that is not negative.
[[nodiscard]] SurfacePoint surfacePointOfJson(
    const std::filesystem::path& file,
    const nlohmann::json& face,
    const nlohmann::json& barycentric,
    const std::string& name
);

/// What surfacePointsJson() wrote.
struct PointsOfJson {
    std::vector<Vec3> positions;
    std::vector<SurfacePoint> points;
};

/// In messages `list` is what they are called, and `nameOf` names the one with an index.
[[nodiscard]] PointsOfJson surfacePointsOfJson(
    const std::filesystem::path& file,
    const nlohmann::json& value,
    const std::string& list,
    std::string (*nameOf)(std::size_t index)
);

/// "closed" and "polyline" of a document. Without "t" the parameters are even. Whether it lies on a
/// mesh is not checked.
[[nodiscard]] SurfacePolyline polylineOfJson(
    const std::filesystem::path& file, const nlohmann::json& document
);

/// The value of "spline".
[[nodiscard]] SplineData splineOfJson(
    const std::filesystem::path& file, const nlohmann::json& value
);

/// The value of a key: true or false. Throws where there is none.
[[nodiscard]] bool flagOfJson(
    const std::filesystem::path& file, const nlohmann::json& object, const char* key
);

}  // namespace bspline_curve
