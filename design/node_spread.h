// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/fairing_node.h"
#include "spline/pick_constraint.h"

#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

/// A node from which a path goes on in even steps.
struct NodeStop {
    std::size_t node;
    int pick;  ///< that it stays at; -1: none
};

/// Nodes that are to go somewhere, each near the node before it on the polyline.
struct NodePlacement {
    std::vector<FairingNode> nodes;
    std::vector<Vec3> targets;
    std::vector<double> places;  ///< by segments of the polyline before
    std::vector<NodeStop> stops;
};

/// Spreads about so many points along a polyline, from stop to stop at even steps, closer where the
/// surface turns. `leastOfLeg`: between two stops.
[[nodiscard]] NodePlacement spreadNodes(
    std::span<const FairingNode> nodes,
    bool closed,
    std::span<const NodeStop> stops,
    std::span<const PickConstraint> picks,
    int segments,
    int leastOfLeg
);

/// Moves targets between picks by the cubic that turns the ends of the path there into the picks'
/// tangents: from a path that leaves a pick backwards no small step leads to one that does not.
void bendToTangents(NodePlacement& placement, std::span<const PickConstraint> picks);

}  // namespace bspline_curve
