// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/mesh_holes.h"

#include "bspline_curve/error.h"
#include "fill/fill_holes.h"
#include "fill/part_filling.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Rims = std::vector<std::vector<int>>;

double lengthOf(const std::vector<int>& rim, const std::vector<Vec3>& vertices) {
    double length = 0.0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        length += (vertices[rim[(i + 1) % rim.size()]] - vertices[rim[i]]).norm();
    }
    return length;
}

/// The number of the rim that comes nearest to a point.
std::size_t nearestRim(const Rims& rims, const std::vector<Vec3>& vertices, const Vec3& point) {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rims.size(); ++i) {
        for (const int vertex : rims[i]) {
            const double distance = (vertices[vertex] - point).squaredNorm();
            if (distance < least) {
                least = distance;
                nearest = i;
            }
        }
    }
    return nearest;
}

Rims chosenRims(const Rims& rims, const std::vector<Vec3>& vertices, const HoleChoice& choice) {
    Rims chosen;
    const std::size_t seeded = choice.seed ? nearestRim(rims, vertices, *choice.seed) : 0;
    for (std::size_t i = 0; i < rims.size(); ++i) {
        if ((!choice.seed || i == seeded) && std::ssize(rims[i]) <= choice.mostEdges &&
            lengthOf(rims[i], vertices) <= choice.mostLength) {
            chosen.push_back(rims[i]);
        }
    }
    return chosen;
}

[[noreturn]] void refuse(const Rims& rims, const std::vector<Vec3>& vertices) {
    if (rims.empty()) {
        throw InputError(InputErrorCode::NoPath, "the mesh has no hole: it is closed already");
    }
    double shortest = std::numeric_limits<double>::infinity();
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const std::vector<int>& rim : rims) {
        shortest = std::min(shortest, lengthOf(rim, vertices));
        fewest = std::min(fewest, rim.size());
    }
    throw InputError(
        InputErrorCode::NoPath,
        "none of " + describeCount(rims.size(), "hole", "holes") +
            " is as small as that: the shortest rim is " + describeNumber(shortest) +
            " long, the one with the fewest edges has " + std::to_string(fewest)
    );
}

}  // namespace

FilledParts withHolesFilled(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const HoleChoice& choice,
    FillShape shape,
    const Progress& progress
) {
    const TriangleMesh& mesh = imprinted.mesh;
    const Rims rims = rimsOf(mesh.faces);
    FilledParts result = wholeImprint(imprinted, parts);
    result.rims = chosenRims(rims, mesh.vertices, choice);
    if (result.rims.empty()) {
        refuse(rims, mesh.vertices);
    }
    result.openRims = static_cast<int>(rims.size() - result.rims.size());
    FilledMesh filled = fillHoles(mesh, result.rims, shape, {}, progress);
    result.mesh = std::move(filled.mesh);
    result.firstNew = std::move(filled.firstNew);
    result.firstFace = std::move(filled.firstFace);
    result.crossing = std::move(filled.crossing);
    result.endOfNew = static_cast<int>(result.mesh.vertices.size());
    result.source.resize(result.mesh.vertices.size(), -1);
    result.faces.resize(result.mesh.faces.size(), -1);
    result.labels.resize(result.mesh.faces.size(), -1);
    return result;
}

}  // namespace bspline_curve
