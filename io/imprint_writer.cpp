// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/imprint_writer.h"

#include <nlohmann/json.hpp>

namespace bspline_curve {

namespace {

using Json = nlohmann::ordered_json;

Json triple(const Vec3& values) {
    return {values[0], values[1], values[2]};
}

}  // namespace

std::string imprintMapBytes(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    std::span<const double> inputQuality,
    std::span<const double> quality
) {
    Json newVertices = Json::array();
    for (const SurfacePoint& point : imprinted.newVertices) {
        newVertices.push_back({{"face", point.face}, {"barycentric", triple(point.barycentric)}});
    }
    Json curves = Json::array();
    for (const ImprintedCurve& curve : imprinted.curves) {
        curves.push_back({{"vertices", curve.vertices}, {"closed", curve.closed}});
    }
    Json values = nullptr;
    if (!quality.empty()) {
        values = {
            {"input", std::vector(inputQuality.begin(), inputQuality.end())},
            {"output", std::vector(quality.begin(), quality.end())},
        };
    }
    const Json map{
        {"parents", imprinted.parents},
        {"new_vertices", std::move(newVertices)},
        {"curves", std::move(curves)},
        {"crossings", imprinted.crossings},
        {"regions", parts.labels},
        {"quality", std::move(values)},
    };
    return map.dump() + "\n";
}

std::string imprintReportBytes(
    const ImprintedMesh& imprinted, const MeshParts& parts, const ImprintFigures& figures
) {
    Json list = Json::array();
    for (const MeshPart& part : parts.parts) {
        list.push_back({
            {"faces", part.faces},
            {"area", part.area},
            {"perimeter", part.perimeter},
            {"centroid", triple(part.centroid)},
            {"euler", part.euler},
        });
    }
    const Json report{
        {"curves", imprinted.curves.size()},
        {"vertices", imprinted.mesh.vertices.size()},
        {"new_vertices", imprinted.newVertices.size()},
        {"faces", imprinted.mesh.faces.size()},
        {"divided_faces", imprinted.dividedFaces},
        {"crossings", imprinted.crossings.size()},
        {"snap", figures.snap},
        {"largest_move", imprinted.largestMove},
        {"parts", std::move(list)},
        {"seconds",
         {{"read", figures.readSeconds},
          {"surface", figures.surfaceSeconds},
          {"imprint", figures.imprintSeconds}}},
    };
    constexpr int kIndent = 2;
    return report.dump(kIndent) + "\n";
}

}  // namespace bspline_curve
