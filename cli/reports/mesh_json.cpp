// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/mesh_json.h"

namespace bspline_curve::cli {

nlohmann::ordered_json repairJson(const RepairReport* repair) {
    if (repair == nullptr) {
        return nullptr;
    }
    nlohmann::ordered_json duplicated = nlohmann::ordered_json::array();
    for (const auto& [vertex, copies] : repair->duplicatedVertices) {
        duplicated.push_back({{"vertex", vertex}, {"copies", copies}});
    }
    return {
        {"changes", repair->count()},
        {"left_out_faces", repair->leftOutFaces},
        {"merged_vertices", repair->mergedVertices},
        {"removed_degenerate_faces", repair->removedDegenerateFaces},
        {"split_faces", repair->splitFaces},
        {"removed_duplicate_faces", repair->removedDuplicateFaces},
        {"reversed_faces", repair->reversedFaces},
        {"cut_edges", repair->cutEdges},
        {"duplicated_vertices", duplicated},
        {"joined_edges", repair->joinedEdges},
        {"joined_vertices", repair->joinedVertices},
    };
}

nlohmann::ordered_json meshJson(const Workpiece& workpiece, const std::string& file) {
    const TriangleMesh& mesh = workpiece.mendedMesh();
    return {
        {"file", file},
        {"vertices", mesh.vertices.size()},
        {"faces", mesh.faces.size()},
        {"components", workpiece.componentCount()},
        {"diagonal", workpiece.diagonal()},
        {"average_edge_length", workpiece.meanEdgeLength()},
    };
}

}  // namespace bspline_curve::cli
