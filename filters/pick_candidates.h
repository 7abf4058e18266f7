// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"
#include "bspline_curve/mesh.h"

#include <optional>
#include <string>
#include <vector>

// What hosts hand over besides a mesh, as plain arrays.
namespace bspline_curve {

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
