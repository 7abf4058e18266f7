// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/part_sheet.h"

#include "surface/half_edges.h"
#include "utility/index_sets.h"

#include <span>

namespace bspline_curve {

std::vector<int> PartSheet::rimVertices() const {
    std::vector<int> vertices;
    for (const RimEdge& edge : rim) {
        vertices.push_back(edge.from);
    }
    sortUnique(vertices);
    return vertices;
}

PartSheet sheetOf(
    const ImprintedMesh& imprinted, const MeshParts& parts, const std::vector<int>& chosen
) {
    const CutMesh cut = cutAlongEdges(imprinted.mesh, edgesAround(imprinted, parts, chosen));
    PartSheet sheet{.parts = openParts(cut, parts, chosen), .rim = {}, .first = {}};
    std::vector<int> firstOf(imprinted.mesh.vertices.size(), -1);
    for (const int source : sheet.parts.source) {
        int& first = firstOf[source];
        first = first < 0 ? static_cast<int>(sheet.first.size()) : first;
        sheet.first.push_back(first);
    }
    const std::vector<Triangle>& faces = sheet.parts.mesh.faces;
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            const auto& [low, high, face, k] = sides[0];
            sheet.rim.push_back(
                {.from = faces[face][(k + 1) % 3],
                 .to = faces[face][(k + 2) % 3],
                 .face = sheet.parts.faces[face]}
            );
        }
    });
    return sheet;
}

void addWall(FilledParts& solid, const RimEdge& edge, int movedFrom, int movedTo) {
    solid.mesh.faces.push_back({edge.to, edge.from, movedFrom});
    solid.mesh.faces.push_back({edge.to, movedFrom, movedTo});
    solid.walls.resize(solid.walls.size() + 2, {edge.face, edge.face, edge.face});
}

void endSolid(FilledParts& solid) {
    solid.faces.resize(solid.mesh.faces.size(), -1);
    solid.labels.resize(solid.mesh.faces.size(), -1);
}

}  // namespace bspline_curve
