// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/fairing_energy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bspline_curve {

void FairingEnergy::setTangents(std::vector<Vec3> tangents) {
    tangents_ = std::move(tangents);
}

// c and its derivatives by I at each node.
std::vector<FieldCostValue> FairingEnergy::fieldCostsAt(Nodes nodes) const {
    std::vector<FieldCostValue> costs;
    for (const FairingNode& node : nodes) {
        const SurfacePoint point{node.foot.face, node.foot.barycentric()};
        costs.push_back(
            bspline_curve::fieldCost(field_.cost, valueAt(extended_.faces, field_.values, point))
        );
    }
    return costs;
}

// Mean of c along the path, by the trapezoidal rule.
double FairingEnergy::fieldCostOf(
    Nodes nodes, const std::vector<double>& lengths, double length
) const {
    const NodeRow row = rowOf(nodes);
    const std::vector<FieldCostValue> costs = fieldCostsAt(nodes);
    double sum = 0.0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        sum += 0.5 * lengths[i] * (costs[i].value + costs[row.after(i)].value);
    }
    return sum / length;
}

PathEnergy FairingEnergy::valueOf(Nodes nodes, const NearPicks& near, double strength) const {
    const NodeRow row = rowOf(nodes);
    PathEnergy energy;
    std::vector<double> lengths(row.segmentCount());
    for (std::size_t i = 0; i < row.segmentCount(); ++i) {
        lengths[i] = row.segment(nodes, i).norm();
        energy.length += lengths[i];
    }
    Vec3 in = options_.closed ? row.segment(nodes, row.before(0)) : Vec3(Vec3::Zero());
    for (std::size_t i = 0; i < row.size; ++i) {
        const Vec3 out = row.hasAfter(i) ? row.segment(nodes, i) : Vec3(Vec3::Zero());
        if (hasTangent(i)) {
            for (const auto& [other, half] : halfTurnsAt(i, nodes)) {
                energy.bending += half.value * half.value / half.length;
            }
        } else if (row.hasTurn(i)) {
            const double turn = turnOf(nodes[i].normal.dot(in.cross(out)), in.dot(out)).value;
            energy.bending += turn * turn / (0.5 * (lengths[row.before(i)] + lengths[i]));
        }
        in = out;
    }
    const double stretch = energy.length / chord_;
    energy.own = (1.0 - options_.tension) * energy.length * energy.bending +
                 options_.tension * stretch * stretch;
    if (!field_.empty()) {
        energy.fieldCost = fieldCostOf(nodes, lengths, energy.length);
        energy.own += field_.weight * energy.fieldCost;
    }
    energy.total = energy.own + near.energy(nodes, strength);
    return energy;
}

std::vector<std::pair<std::size_t, HalfTurn>> FairingEnergy::halfTurnsAt(
    std::size_t i, Nodes nodes
) const {
    const NodeRow row = rowOf(nodes);
    std::vector<std::pair<std::size_t, HalfTurn>> halves;
    const auto add = [&](std::size_t other, bool isBefore) {
        const Vec3 way = nodes[other].position - nodes[i].position;
        const Vec3 across = other < ways_.size() ? ways_[other].across : Vec3(Vec3::Zero());
        halves.emplace_back(other, halfTurn(way, isBefore, tangents_[i], nodes[i].normal, across));
    };
    if (row.hasBefore(i)) {
        add(row.before(i), true);
    }
    if (row.hasAfter(i)) {
        add(row.after(i), false);
    }
    return halves;
}

void FairingEnergy::addHalfTurn(std::size_t other, const HalfTurn& half, double weight) {
    const double root = std::sqrt(half.length);
    const double slope =
        half.valueBy / root - 0.5 * half.value * half.lengthBy / (root * half.length);
    gradientAt(other) += weight * slope * half.value / root;
    rows_[other][0] += weight * slope * slope;
}

void FairingEnergy::measureSegments(Nodes nodes) {
    const NodeRow row = rowOf(nodes);
    segments_.resize(row.segmentCount());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const Vec3 way = row.segment(nodes, i);
        const double length = way.norm();
        segments_[i] = {way, length > 0.0 ? Vec3(way / length) : Vec3(Vec3::Zero()), length};
    }
}

NodeWay FairingEnergy::wayOf(Nodes nodes, std::size_t i) const {
    const NodeRow row = rowOf(nodes);
    const FairingNode& node = nodes[i];
    Vec3 along = Vec3::Zero();
    if (row.hasBefore(i)) {
        along += segments_[row.before(i)].tangent;
    }
    if (row.hasAfter(i)) {
        along += segments_[i].tangent;
    }
    const Vec3 across = node.normal.cross(along).normalized();
    const Triangle& face = extended_.faces[node.foot.face];
    const Vec3& corner = extended_.vertices[face[0]];
    const double u = node.frame.u.dot(across);
    const double v = node.frame.v.dot(across);
    NodeWay way;
    way.u = u;
    way.v = v;
    way.across =
        u * (extended_.vertices[face[1]] - corner) + v * (extended_.vertices[face[2]] - corner);
    const Vec3 turn = u * node.normalByU + v * node.normalByV;
    way.turn = turn - turn.dot(node.normal) * node.normal;
    if (!field_.empty()) {
        const auto& values = field_.values;
        way.fieldBy =
            u * (values[face[1]] - values[face[0]]) + v * (values[face[2]] - values[face[0]]);
    }
    return way;
}

void FairingEnergy::differentiate(
    Nodes nodes,
    std::span<const char> isFixed,
    const PathEnergy& energy,
    const NearPicks& near,
    double strength
) {
    const NodeRow row = rowOf(nodes);
    measureSegments(nodes);
    ways_.assign(row.size, {});
    for (std::size_t i = 0; i < row.size; ++i) {
        if (isFixed[i] == 0) {
            ways_[i] = wayOf(nodes, i);
        }
    }
    gradient_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(row.size));
    rows_.assign(row.size, {0.0, 0.0, 0.0});
    const double bendingWeight = 2.0 * (1.0 - options_.tension) * energy.length;
    const double lengthWeight = (1.0 - options_.tension) * energy.bending +
                                2.0 * options_.tension * energy.length / (chord_ * chord_);
    for (std::size_t i = 0; i < row.size; ++i) {
        if (hasTangent(i)) {
            for (const auto& [other, half] : halfTurnsAt(i, nodes)) {
                addHalfTurn(other, half, bendingWeight);
            }
        } else if (row.hasTurn(i)) {
            addTurn(nodes, i, bendingWeight);
        }
    }
    const std::vector<FieldCostValue> costs =
        field_.empty() ? std::vector<FieldCostValue>(row.size) : fieldCostsAt(nodes);
    for (std::size_t i = 0; i < row.segmentCount(); ++i) {
        // The derivative of the field's term by the length of a segment.
        const double mean = 0.5 * (costs[i].value + costs[row.after(i)].value);
        const double byField = field_.weight * (mean - energy.fieldCost) / energy.length;
        addSegment(nodes, i, lengthWeight + byField);
    }
    for (std::size_t i = 0; !field_.empty() && i < row.size; ++i) {
        addField(nodes, i, costs[i], energy.length);
    }
    for (const NearPicks::Pick& pick : near.picks()) {
        const NearPicks::Pull pull = near.pullOf(pick, nodes, strength);
        addPull(pull, row.after(pull.segment));
    }
}

void FairingEnergy::addField(
    Nodes nodes, std::size_t i, const FieldCostValue& here, double pathLength
) {
    const NodeRow row = rowOf(nodes);
    double length = 0.0;
    if (row.hasBefore(i)) {
        length += 0.5 * row.segment(nodes, row.before(i)).norm();
    }
    if (row.hasAfter(i)) {
        length += 0.5 * row.segment(nodes, i).norm();
    }
    const double weight = field_.weight * length / pathLength;
    const double by = ways_[i].fieldBy;
    gradientAt(i) += weight * here.slope * by;
    rows_[i][0] += weight * std::max(0.0, here.curvature) * by * by;
}

void FairingEnergy::addPull(const NearPicks::Pull& pull, std::size_t after) {
    const std::size_t i = pull.segment;
    const std::size_t j = after;
    const Vec3 a = (1.0 - pull.share) * ways_[i].across;
    const Vec3 b = pull.share * ways_[j].across;
    const double byA = 2.0 * pull.way.dot(a);  // of the squared distance
    const double byB = 2.0 * pull.way.dot(b);
    gradientAt(i) += pull.slope * byA;
    gradientAt(j) += pull.slope * byB;
    rows_[i][0] += pull.curvature * byA * byA + 2.0 * pull.slope * a.squaredNorm();
    rows_[j][0] += pull.curvature * byB * byB + 2.0 * pull.slope * b.squaredNorm();
    rows_[i][1] += pull.curvature * byA * byB + 2.0 * pull.slope * a.dot(b);
}

void FairingEnergy::addTurn(Nodes nodes, std::size_t i, double weight) {
    const NodeRow row = rowOf(nodes);
    const std::array<std::size_t, 3> at = {row.before(i), i, row.after(i)};
    const PathTurn turn = pathTurn(
        segments_[at[0]].way,
        segments_[i].way,
        nodes[i].normal,
        {&ways_[at[0]], &ways_[i], &ways_[at[2]]}
    );
    const double root = std::sqrt(turn.length);
    std::array<double, 3> slope{};
    for (std::size_t k = 0; k < 3; ++k) {
        slope[k] =
            turn.valueBy[k] / root - 0.5 * turn.value * turn.lengthBy[k] / (root * turn.length);
        gradientAt(at[k]) += weight * slope[k] * turn.value / root;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = k; j < 3; ++j) {
            rows_[at[k]][j - k] += weight * slope[k] * slope[j];
        }
    }
}

void FairingEnergy::addSegment(Nodes nodes, std::size_t i, double weight) {
    const NodeRow row = rowOf(nodes);
    const std::size_t next = row.after(i);
    const double length = segments_[i].length;
    const Vec3& tangent = segments_[i].tangent;
    const Vec3& a = ways_[i].across;
    const Vec3& b = ways_[next].across;
    gradientAt(i) -= weight * tangent.dot(a);
    gradientAt(next) += weight * tangent.dot(b);
    const Vec3 aAside = a - tangent.dot(a) * tangent;
    const Vec3 bAside = b - tangent.dot(b) * tangent;
    const double bent = std::max(0.0, weight) / length;
    rows_[i][0] += bent * aAside.squaredNorm();
    rows_[next][0] += bent * bAside.squaredNorm();
    rows_[i][1] -= bent * aAside.dot(bAside);
}

}  // namespace bspline_curve
