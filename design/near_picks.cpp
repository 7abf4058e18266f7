// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/near_picks.h"

#include "surface/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

/// Share of the squared bound beyond which the barrier is a parabola: steep enough to draw a
/// polyline inside, and finite where a step has led outside.
constexpr double kSteepest = 0.96;

struct Barrier {
    double value, slope, curvature;  // and its derivatives by u = d^2 / bound^2
};

// u / (1 - u).
Barrier barrierAt(double u) {
    const double inside = std::min(u, kSteepest);
    const double inverse = 1.0 / (1.0 - inside);
    const double slope = inverse * inverse;
    const double curvature = 2.0 * slope * inverse;
    const double beyond = u - inside;
    return {
        inside * inverse + beyond * (slope + 0.5 * beyond * curvature),
        slope + beyond * curvature,
        curvature
    };
}

std::size_t after(std::size_t i, std::size_t count) {
    return i + 1 < count ? i + 1 : 0;
}

struct OnSegment {
    double share, squaredDistance;
};

OnSegment nearestOn(const Vec3& from, const Vec3& to, const Vec3& pick) {
    const double share = nearestShare(pick, from, to);
    return {share, (from + share * (to - from) - pick).squaredNorm()};
}

}  // namespace

void NearPicks::follow(std::span<const FairingNode> nodes, bool closed) {
    const std::size_t count = nodes.size();
    const std::size_t segments = closed ? count : count - 1;
    const auto nearest = [&](std::size_t segment, const Vec3& pick) {
        return nearestOn(nodes[segment].position, nodes[after(segment, count)].position, pick);
    };
    // The segment after or before another one; the same at the end of an open polyline.
    const auto next = [&](std::size_t segment, bool isForward) {
        if (!closed && segment == (isForward ? segments - 1 : 0)) {
            return segment;
        }
        const std::size_t before = segment > 0 ? segment - 1 : segments - 1;
        return isForward ? after(segment, segments) : before;
    };
    for (Pick& pick : picks_) {
        if (pick.isAtNode) {
            continue;
        }
        OnSegment best = nearest(pick.segment, pick.position);
        for (const bool isForward : {true, false}) {
            std::size_t segment = next(pick.segment, isForward);
            OnSegment there = nearest(segment, pick.position);
            while (there.squaredDistance < best.squaredDistance) {
                best = there;
                pick.segment = segment;
                segment = next(segment, isForward);
                there = nearest(segment, pick.position);
            }
        }
        pick.share = best.share;
    }
}

NearPicks::Pull NearPicks::pullOf(
    const Pick& pick, std::span<const FairingNode> nodes, double strength
) const {
    const Vec3& from = nodes[pick.segment].position;
    const Vec3& to = nodes[after(pick.segment, nodes.size())].position;
    Pull pull{pick.segment, pick.share, from + pick.share * (to - from) - pick.position, 0, 0, 0};
    // Chords pass beneath or above the surface.
    const Vec3& normal = nodes[pick.segment].normal;
    pull.way -= normal.dot(pull.way) * normal;
    const double squared = pull.way.squaredNorm();
    pull.value = pick.leeway.weight * squared;
    pull.slope = pick.leeway.weight;
    if (strength > 0.0 && std::isfinite(pick.leeway.bound)) {
        const double scale = 1.0 / (pick.leeway.bound * pick.leeway.bound);
        const Barrier barrier = barrierAt(squared * scale);
        pull.value += strength * barrier.value;
        pull.slope += strength * scale * barrier.slope;
        pull.curvature += strength * scale * scale * barrier.curvature;
    }
    return pull;
}

double NearPicks::energy(std::span<const FairingNode> nodes, double strength) const {
    double energy = 0.0;
    for (const Pick& pick : picks_) {
        energy += pullOf(pick, nodes, strength).value;
    }
    return energy;
}

}  // namespace bspline_curve
