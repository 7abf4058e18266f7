// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

// The faces whose mean value, less the threshold, has the sign of `side`.
Region facesBeside(
    const TriangleMesh& mesh, std::span<const double> field, double threshold, double side
) {
    if (field.size() != mesh.vertices.size()) {
        throw InputError(
            InputErrorCode::BadField,
            "the field has " + std::to_string(field.size()) + " values for " +
                std::to_string(mesh.vertices.size()) + " vertices: give one value per vertex"
        );
    }
    if (std::isnan(threshold)) {
        throw InputError(
            InputErrorCode::BadOption,
            "the threshold of the region to avoid is not a number: give one"
        );
    }
    return indicesWhere<int>(mesh.faces.size(), [&](std::size_t f) {
        const Triangle& face = mesh.faces[f];
        const double mean = (field[face[0]] + field[face[1]] + field[face[2]]) / 3.0;
        return side * mean > side * threshold;
    });
}

}  // namespace

Region makeRegion(const TriangleMesh& mesh, std::span<const std::int64_t> faces) {
    const auto faceCount = static_cast<std::int64_t>(mesh.faces.size());
    Region region;
    region.reserve(faces.size());
    std::vector<std::int64_t> bad;
    for (const std::int64_t face : faces) {
        if (face >= 0 && face < faceCount) {
            region.push_back(static_cast<int>(face));
        } else {
            bad.push_back(face);
        }
    }
    if (!bad.empty()) {
        sortUnique(bad);
        const std::string count =
            describeCount(bad.size(), "id of the region is", "ids of the region are");
        refuseElements(
            InputErrorCode::IndexOutOfRange,
            count + " no face of the mesh",
            "ids",
            std::move(bad),
            "faces are numbered from 0 to " + std::to_string(faceCount - 1)
        );
    }
    sortUnique(region);
    return region;
}

Region facesOfVertices(const TriangleMesh& mesh, std::span<const char> selected) {
    if (selected.size() != mesh.vertices.size()) {
        throw InputError(
            InputErrorCode::IndexOutOfRange,
            "the selection has " + std::to_string(selected.size()) + " flags for " +
                std::to_string(mesh.vertices.size()) + " vertices: give one flag per vertex"
        );
    }
    return indicesWhere<int>(mesh.faces.size(), [&](std::size_t f) {
        return std::ranges::all_of(mesh.faces[f], [&](int v) { return selected[v] != 0; });
    });
}

Region facesUnder(const TriangleMesh& mesh, std::span<const double> field, double threshold) {
    return facesBeside(mesh, field, threshold, -1.0);
}

Region facesOver(const TriangleMesh& mesh, std::span<const double> field, double threshold) {
    return facesBeside(mesh, field, threshold, 1.0);
}

std::vector<char> faceFlags(const TriangleMesh& mesh, const Region& region) {
    std::vector<char> flags(mesh.faces.size(), 0);
    for (const int f : region) {
        flags[f] = 1;
    }
    return flags;
}

}  // namespace bspline_curve
