// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/node_spread.h"

#include "design/path_turn.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspline_curve {
namespace {

struct SpreadConstants {
    /// Where the normal turns by more than this from point to point (radians),
    /// each further `turnOfSegment` counts as a segment: points are denser at sharp edges.
    double freeTurn = 0.17, turnOfSegment = 0.26;
};

constexpr SpreadConstants kSpread;

class NodeSpreader {
public:
    NodeSpreader(std::span<const FairingNode> nodes, bool closed, int segments)
        : nodes_(nodes), measure_(nodes.size() - (closed ? 0 : 1)) {
        double length = 0.0;
        for (std::size_t i = 0; i < measure_.size(); ++i) {
            measure_[i] = segment(i).norm();
            length += measure_[i];
        }
        for (std::size_t i = 0; i < measure_.size(); ++i) {
            const Vec3& a = nodes_[i].normal;
            const Vec3& b = nodes_[after(i)].normal;
            const double turn =
                std::max(0.0, turnOf(a.cross(b).norm(), a.dot(b)).value - kSpread.freeTurn);
            measure_[i] += turn / kSpread.turnOfSegment * length / segments;
        }
        whole_ = std::accumulate(measure_.begin(), measure_.end(), 0.0);
    }

    [[nodiscard]] std::size_t segmentCount() const { return measure_.size(); }

    void addStop(const NodeStop& stop, const Vec3& target) {
        placement_.stops.push_back({placement_.nodes.size(), stop.pick});
        placement_.nodes.push_back(nodes_[stop.node]);
        placement_.targets.push_back(target);
        placement_.places.push_back(static_cast<double>(stop.node));
    }

    // The points inside of a leg, from the node `first` to the end.
    void addLeg(std::size_t first, std::size_t end, int segments, int least) {
        const auto at = [&](std::size_t node) {
            return measure_.begin() + static_cast<std::ptrdiff_t>(node);
        };
        const double length = std::accumulate(at(first), at(end), 0.0);
        const auto share = std::lround(segments * length / whole_);
        const int count = std::max(least, static_cast<int>(share));
        const double step = length / count;
        std::size_t i = first;
        double passed = 0.0;
        for (int k = 1; k < count; ++k) {
            const double goal = step * k;
            while (i + 1 < end && passed + measure_[i] < goal) {
                passed += measure_[i++];
            }
            const double way =
                measure_[i] > 0.0 ? std::min(1.0, (goal - passed) / measure_[i]) : 0.0;
            placement_.nodes.push_back(nodes_[i]);
            placement_.targets.emplace_back(nodes_[i].position + way * segment(i));
            placement_.places.push_back(static_cast<double>(i) + way);
        }
    }

    [[nodiscard]] NodePlacement take() { return std::move(placement_); }

private:
    [[nodiscard]] std::size_t after(std::size_t i) const {
        return i + 1 < nodes_.size() ? i + 1 : 0;
    }

    [[nodiscard]] Vec3 segment(std::size_t i) const {
        return nodes_[after(i)].position - nodes_[i].position;
    }

    std::span<const FairingNode> nodes_;
    std::vector<double> measure_;  // by segment: its length, and more where the surface turns
    double whole_ = 0.0;
    NodePlacement placement_;
};

}  // namespace

NodePlacement spreadNodes(
    std::span<const FairingNode> nodes,
    bool closed,
    std::span<const NodeStop> stops,
    std::span<const PickConstraint> picks,
    int segments,
    int leastOfLeg
) {
    NodeSpreader spreader(nodes, closed, segments);
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const auto [first, pick] = stops[i];
        spreader.addStop(stops[i], pick >= 0 ? picks[pick].position : nodes[first].position);
        const std::size_t end = i + 1 < stops.size() ? stops[i + 1].node : spreader.segmentCount();
        if (first < end) {  // not the last stop of an open path
            spreader.addLeg(first, end, segments, leastOfLeg);
        }
    }
    return spreader.take();
}

void bendToTangents(NodePlacement& placement, std::span<const PickConstraint> picks) {
    std::vector<Vec3>& targets = placement.targets;
    const std::vector<Vec3> before = targets;
    const std::size_t count = before.size();
    const auto at = [&](std::size_t node) -> const Vec3& { return before[node % count]; };
    const auto tangentAt = [&](const NodeStop& stop) {
        return stop.pick >= 0 ? picks[stop.pick].tangent : Vec3(Vec3::Zero());
    };
    const std::vector<NodeStop>& stops = placement.stops;
    for (std::size_t j = 0; j < stops.size(); ++j) {
        const std::size_t first = stops[j].node;
        const NodeStop& next = stops[(j + 1) % stops.size()];
        const std::size_t end = j + 1 < stops.size() ? next.node : count;
        const Vec3 tangentAtFirst = tangentAt(stops[j]);
        const Vec3 tangentAtEnd = tangentAt(next);
        if (end <= first + 1 || (tangentAtFirst.isZero(0.0) && tangentAtEnd.isZero(0.0))) {
            continue;
        }
        double length = 0.0;
        for (std::size_t i = first; i < end; ++i) {
            length += (at(i + 1) - at(i)).norm();
        }
        const auto missing = [length](const Vec3& tangent, const Vec3& way) {
            return tangent.isZero(0.0) ? tangent : Vec3(length * (tangent - way.normalized()));
        };
        const Vec3 slopeAtFirst = missing(tangentAtFirst, at(first + 1) - at(first));
        const Vec3 slopeAtEnd = missing(tangentAtEnd, at(end) - at(end - 1));
        for (std::size_t i = first + 1; i < end; ++i) {
            const double s = static_cast<double>(i - first) / static_cast<double>(end - first);
            targets[i] += s * (1.0 - s) * ((1.0 - s) * slopeAtFirst - s * slopeAtEnd);
        }
    }
}

}  // namespace bspline_curve
