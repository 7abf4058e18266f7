// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_on_given_mesh.h"

#include "utility/index_sets.h"

#include <optional>

namespace bspline_curve {

void bringBack(SurfacePolyline& line, const MeshRepair* repair) {
    if (repair == nullptr) {
        return;
    }
    for (SurfacePoint& point : line.surfacePoints) {
        point = repair->toOrigin(point);
    }
}

void bringBack(Curve& curve, const MeshRepair* repair) {
    if (repair == nullptr) {
        return;
    }
    bringBack(curve.polyline, repair);
    if (std::optional<FarPart>& part = curve.report.farPart) {
        for (int& face : part->faces) {
            face = repair->faceOrigins[face];
        }
        sortUnique(part->faces);
    }
}

std::vector<char> flagsOfGiven(
    std::vector<char> flags, std::size_t givenFaces, const MeshRepair* repair
) {
    if (repair == nullptr) {
        return flags;
    }
    std::vector<char> given(givenFaces, 0);
    for (std::size_t f = 0; f < flags.size(); ++f) {
        if (flags[f] != 0) {
            given[repair->faceOrigins[f]] = 1;
        }
    }
    return given;
}

std::vector<int> facesOfMended(std::span<const int> faces, const MeshRepair& repair) {
    std::vector<int> wanted(faces.begin(), faces.end());
    sortUnique(wanted);
    return indicesWhere<int>(repair.faceOrigins.size(), [&](std::size_t f) {
        return indexIn(wanted, repair.faceOrigins[f]) >= 0;
    });
}

}  // namespace bspline_curve
