// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"

#include <nlohmann/json.hpp>

namespace bspline_curve {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

std::string curveJson(const CurveContent& content) {
    const SplineData& spline = content.curve.spline;
    Json document = {
        {"closed", content.curve.polyline.closed},
        {"polyline", polylineJson(content)},
        {"spline",
         {{"degree", spline.degree},
          {"closed", spline.closed},
          {"knots", spline.knots},
          {"control_points", pointsJson(spline.controlPoints)},
          {"pick_parameters", spline.pickParameters}}},
    };
    if (const auto& mesh = content.mesh) {
        document["mesh"] = {
            {"vertices", mesh->vertices}, {"faces", mesh->faces}, {"crc32", mesh->digits()}
        };
    }
    return document.dump() + "\n";
}

}  // namespace bspline_curve
