// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/runs_on_plates.h"

#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::test_support {

/// A plate with a bad spot, mostly a face before all others, so that ids change.
struct BrokenPlate {
    std::string name;
    LayerInput layer;
    std::string said;     ///< of the log
    std::string refused;  ///< where strict
};

inline std::vector<BrokenPlate> brokenPlates() {
    const LayerInput whole = plateLayer();
    const auto count = static_cast<int>(whole.mesh.vertices.size());
    const Triangle& inner = whole.mesh.faces[108];  // no edge of it is on the boundary
    const auto with = [&](std::vector<Vec3> vertices, std::vector<Triangle> before) {
        LayerInput layer = whole;
        TriangleMesh& mesh = layer.mesh;
        mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
        mesh.faces.insert(mesh.faces.begin(), before.begin(), before.end());
        for (const Vec3& vertex : mesh.vertices) {
            layer.quality.push_back(2.0 * vertex.x() + vertex.y());
        }
        return layer;
    };
    LayerInput reversed = with({}, {});
    std::swap(reversed.mesh.faces[0][0], reversed.mesh.faces[0][1]);
    return {
        {.name = "bow tie",
         .layer = with({{-1, 0, 0}, {-1, -1, 0}}, {{0, count, count + 1}}),
         .said = "1 vertex duplicated",
         .refused = "vertices 0"},
        {.name = "three faces on an edge",
         .layer = with({{0, 0, 1}}, {{inner[1], inner[0], count}}),
         .said = "1 edge cut",
         .refused = "more than two faces"},
        {.name = "duplicate face",
         .layer = with({}, {inner}),
         .said = "1 duplicate face removed",
         .refused = "two copies of one face"},
        {.name = "empty face",
         .layer = with({}, {{inner[0], inner[1], inner[1]}}),
         .said = "1 face without area removed",
         .refused = "faces 0"},
        {.name = "reversed face",
         .layer = reversed,
         .said = "1 face turned over",
         .refused = "turned opposite ways"},
    };
}

}  // namespace bspline_curve::test_support
