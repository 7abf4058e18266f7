// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"
#include "io/json_text.h"

#include <utility>

namespace bspline_curve {

namespace {

Json pointsJson(const std::vector<Vec3>& list) {
    Json result = Json::array();
    for (const Vec3& p : list) {
        result.push_back({p.x(), p.y(), p.z()});
    }
    return result;
}

Json polylineJson(const CurveContent& content) {
    const SurfacePolyline& polyline = content.curve.polyline;
    Json faces = Json::array();
    std::vector<Vec3> barycentrics;
    for (const SurfacePoint& point : polyline.surfacePoints) {
        faces.push_back(point.face);
        barycentrics.push_back(point.barycentric);
    }
    Json result = {
        {"points", pointsJson(polyline.points)},
        {"faces", faces},
        {"barycentrics", pointsJson(barycentrics)},
        {"t", polyline.parameters},
        {"picks", polyline.picks},
    };
    if (!content.field.empty()) {
        result["quality"] = std::vector<double>(content.field.begin(), content.field.end());
    }
    return result;
}

Json contentJson(const CurveContent& content) {
    const SplineData& spline = content.curve.spline;
    return {
        {"closed", content.curve.polyline.closed},
        {"polyline", polylineJson(content)},
        {"spline",
         {{"degree", spline.degree},
          {"closed", spline.closed},
          {"knots", spline.knots},
          {"control_points", pointsJson(spline.controlPoints)},
          {"pick_parameters", spline.pickParameters}}},
    };
}

void addMesh(Json& document, const std::optional<MeshChecksum>& mesh) {
    if (mesh) {
        document["mesh"] = {
            {"vertices", mesh->vertices}, {"faces", mesh->faces}, {"crc32", mesh->digits()}
        };
    }
}

}  // namespace

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

}  // namespace bspline_curve
