// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "design/fairing_node.h"
#include "design/near_picks.h"
#include "design/path_field.h"
#include "design/path_turn.h"
#include "shell/extended_surface.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// What fairedPath() minimises, and its parts.
struct PathEnergy {
    double bending = 0.0;  ///< the integral of kappa_g^2
    double length = 0.0;
    double fieldCost = 0.0;  ///< mean of c along the path
    double own = 0.0;        ///< without what picks draw
    double total = 0.0;
};

/// The energy of a path by its nodes, and its derivatives by their moves across the path.
class FairingEnergy {
public:
    /// `chord`: length of the polygon of picks, > 0. What is given must outlive this.
    FairingEnergy(
        const ExtendedSurface& extended,
        const SolverOptions& options,
        const PathField& field,
        double chord
    )
        : extended_(extended), options_(options), field_(field), chord_(chord) {}

    /// Of each node the tangent of the pick that it is; zero: none.
    void setTangents(std::vector<Vec3> tangents);

    [[nodiscard]] bool hasTangent(std::size_t i) const { return !tangents_[i].isZero(0.0); }

    [[nodiscard]] const std::vector<Vec3>& tangents() const { return tangents_; }

    /// To and from the tangent of a node, as far as there is a path; and the other node of each.
    /// Derivatives are those of the last ways.
    [[nodiscard]] std::vector<std::pair<std::size_t, HalfTurn>> halfTurnsAt(
        std::size_t i, std::span<const FairingNode> nodes
    ) const;

    /// `strength`: see NearPicks. O(n).
    [[nodiscard]] PathEnergy valueOf(
        std::span<const FairingNode> nodes, const NearPicks& near, double strength
    ) const;

    /// Derivatives at nodes of this energy; those that are fixed do not move. Of Gauss and Newton:
    /// bending as a sum of the squares (turn / sqrt(length))^2, whose own second derivatives are
    /// left out, times the length; and the bending times the second derivatives of the length.
    /// O(n).
    void differentiate(
        std::span<const FairingNode> nodes,
        std::span<const char> isFixed,
        const PathEnergy& energy,
        const NearPicks& near,
        double strength
    );

    /// How each node moves by its unknown; a fixed one does not.
    [[nodiscard]] const std::vector<NodeWay>& ways() const { return ways_; }

    [[nodiscard]] const Eigen::VectorXd& gradient() const { return gradient_; }

    /// Of the Hessian's rows the diagonal and the two entries after it.
    [[nodiscard]] const std::vector<std::array<double, 3>>& rows() const { return rows_; }

private:
    using Nodes = std::span<const FairingNode>;

    struct Segment {
        Vec3 way, tangent;
        double length;
    };

    [[nodiscard]] NodeRow rowOf(Nodes nodes) const { return {nodes.size(), options_.closed}; }

    [[nodiscard]] std::vector<FieldCostValue> fieldCostsAt(Nodes nodes) const;
    [[nodiscard]] double fieldCostOf(
        Nodes nodes, const std::vector<double>& lengths, double length
    ) const;
    [[nodiscard]] NodeWay wayOf(Nodes nodes, std::size_t i) const;
    void measureSegments(Nodes nodes);

    [[nodiscard]] double& gradientAt(std::size_t i) {
        return gradient_[static_cast<Eigen::Index>(i)];
    }

    void addHalfTurn(std::size_t other, const HalfTurn& half, double weight);
    void addTurn(Nodes nodes, std::size_t i, double weight);
    void addSegment(Nodes nodes, std::size_t i, double weight);
    void addField(Nodes nodes, std::size_t i, const FieldCostValue& here, double pathLength);
    void addPull(const NearPicks::Pull& pull, std::size_t after);

    const ExtendedSurface& extended_;
    const SolverOptions& options_;
    const PathField& field_;
    double chord_;
    std::vector<Vec3> tangents_;     // by node
    std::vector<NodeWay> ways_;      // likewise
    std::vector<Segment> segments_;  // after each node, in differentiate()
    Eigen::VectorXd gradient_;
    std::vector<std::array<double, 3>> rows_;
};

}  // namespace bspline_curve
