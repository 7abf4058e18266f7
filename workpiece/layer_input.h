// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <optional>
#include <string>
#include <vector>

// What hosts hand over, as plain arrays.
namespace bspline_curve {

/// A layer with a triangle mesh, without the elements that the host has deleted; or a file with
/// one.
struct LayerInput {
    std::string label;                   ///< for messages
    TriangleMesh mesh;                   ///< in world coordinates
    std::vector<double> quality;         ///< one per vertex; empty: the layer has none
    std::vector<char> selectedVertices;  ///< one flag per vertex; empty: nothing is selected
    std::vector<char> selectedFaces;     ///< one flag per face; likewise
    /// Nothing was deleted: the arrays' indices are the layer's.
    bool hasLayersIds = true;
    bool isFile = false;

    /// As messages name it.
    [[nodiscard]] std::string name() const {
        return isFile ? label + ":" : "layer \"" + label + "\"";
    }
};

/// A layer whose vertices are picks, in their order.
struct PicksLayer {
    std::string label;         ///< for messages
    std::vector<Vec3> points;  ///< in world coordinates
    bool hasFaces = false;
    bool isOffered = false;  ///< the host offers it by default, so perhaps nobody chose it
};

/// The picks that a host has, for a request to choose from.
struct PickCandidates {
    std::vector<Vec3> tool;  ///< of the host's own tool on the surface, in world coordinates
    std::optional<PicksLayer> layer;  ///< that the request names
};

}  // namespace bspline_curve
