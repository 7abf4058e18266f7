// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/imprint_report.h"

#include "cli/reports/mesh_json.h"
#include "text/csv.h"
#include "text/json_text.h"
#include "text/number_text.h"

namespace bspline_curve::cli {

namespace {

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

namespace {

Json listOf(const MeshParts& parts) {
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
    return list;
}

Json reportOf(
    const ImprintedMesh& imprinted, const MeshParts& parts, const ImprintFigures& figures
) {
    return {
        {"curves", imprinted.curves.size()},
        {"vertices", imprinted.mesh.vertices.size()},
        {"new_vertices", imprinted.ownPlaces.size()},
        {"faces", imprinted.mesh.faces.size()},
        {"divided_faces", imprinted.dividedFaces},
        {"crossings", imprinted.crossings.size()},
        {"snap", figures.snap},
        {"largest_move", imprinted.largestMove},
        {"parts", listOf(parts)},
        {"repair", repairJson(figures.repair)},
        {"seconds",
         {{"read", figures.readSeconds},
          {"surface", figures.surfaceSeconds},
          {"draw", figures.drawSeconds},
          {"imprint", figures.imprintSeconds}}},
    };
}

}  // namespace

std::string imprintReportBytes(
    const ImprintedMesh& imprinted, const MeshParts& parts, const ImprintFigures& figures
) {
    return jsonText(reportOf(imprinted, parts, figures));
}

std::string cutReportBytes(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const ImprintFigures& figures,
    const CutFigures& cut
) {
    Json report = reportOf(imprinted, parts, figures);
    report["doubled_vertices"] = cut.doubledVertices;
    report["kept"] = cut.kept;
    report["filled_holes"] = cut.filledHoles;
    report["seconds"]["cut"] = cut.cutSeconds;
    return jsonText(report);
}

std::string partsCsv(const MeshParts& parts) {
    std::string text = "part,faces,area,perimeter,centroid_x,centroid_y,centroid_z,euler\n";
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const MeshPart& part = parts.parts[i];
        const std::vector<std::string> fields{
            std::to_string(i),
            std::to_string(part.faces),
            numberText(part.area),
            numberText(part.perimeter),
            numberText(part.centroid.x()),
            numberText(part.centroid.y()),
            numberText(part.centroid.z()),
            std::to_string(part.euler),
        };
        text += csvLine(fields);
    }
    return text;
}

std::string partsJson(const MeshParts& parts) {
    return jsonText(Json{{"parts", listOf(parts)}});
}

}  // namespace bspline_curve::cli
