// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <utility>

/// Which side of a mesh is its outside.
namespace bspline_curve::test_support {

/// Every face turned over.
[[nodiscard]] inline TriangleMesh insideOut(TriangleMesh mesh) {
    for (Triangle& face : mesh.faces) {
        std::swap(face[1], face[2]);
    }
    return mesh;
}

/// Positive for closed meshes that are oriented outwards.
[[nodiscard]] inline double volumeOf(const TriangleMesh& mesh) {
    double sixfold = 0.0;
    for (const auto& [a, b, c] : mesh.faces) {
        sixfold += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    }
    return sixfold / 6.0;
}

}  // namespace bspline_curve::test_support
