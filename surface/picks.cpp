// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/picks.h"

#include "bspline_curve/error.h"
#include "surface/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Elements = std::vector<std::int64_t>;

std::string pickName(std::size_t pick) {
    return "pick " + std::to_string(pick);
}

/// " (all picks concerned: 3, 7)" where there are more than the ones that the message has named.
std::string alsoConcerned(const Elements& picks, std::size_t named) {
    if (picks.size() <= named) {
        return "";
    }
    return " (all picks concerned: " + describeElements(picks) + ")";
}

void requireEnoughPicks(const std::vector<Vec3>& picks, bool closed) {
    const std::size_t needed = closed ? 3 : 2;
    if (picks.size() < needed) {
        throw InputError(
            InputErrorCode::TooFewPicks,
            std::string(closed ? "a closed" : "an open") + " curve needs at least " +
                std::to_string(needed) + " picks, not " + std::to_string(picks.size()) +
                ": pick more points on the mesh"
        );
    }
}

void requireFinitePicks(const std::vector<Vec3>& picks) {
    Elements bad;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (!picks[i].allFinite()) {
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        const auto first = static_cast<std::size_t>(bad.front());
        throw InputError(
            InputErrorCode::NonFiniteCoordinate,
            pickName(first) + " has a coordinate that is not a finite number" +
                alsoConcerned(bad, 1) + ": pick a point on the mesh",
            bad
        );
    }
}

using Projections = std::vector<TriangleTree::Closest>;

void requireNearSurface(const Projections& projections, double diagonal) {
    const double reach = kPickReachRelative * diagonal;
    Elements bad;
    for (std::size_t i = 0; i < projections.size(); ++i) {
        if (!(std::sqrt(projections[i].squaredDistance) <= reach)) {
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        const auto first = static_cast<std::size_t>(bad.front());
        throw InputError(
            InputErrorCode::PickTooFar,
            pickName(first) + " lies " +
                describeNumber(std::sqrt(projections[first].squaredDistance)) +
                " from the surface, more than " + describeNumber(100.0 * kPickReachRelative) +
                " % of the diagonal (" + describeNumber(reach) + ")" + alsoConcerned(bad, 1) +
                ": pick a point on the mesh",
            bad
        );
    }
}

void requireSeparatePicks(const Projections& projections, bool closed, double diagonal) {
    Elements bad;
    std::pair<std::size_t, std::size_t> firstPair;
    for (std::size_t i = closed ? 0 : 1; i < projections.size(); ++i) {
        const std::size_t before = i == 0 ? projections.size() - 1 : i - 1;
        const double distance = (projections[i].position - projections[before].position).norm();
        if (distance < kPickSeparationRelative * diagonal) {
            if (bad.empty()) {
                firstPair = {before, i};
            }
            bad.push_back(static_cast<std::int64_t>(before));
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        sortUnique(bad);
        throw InputError(
            InputErrorCode::CoincidentPicks,
            pickName(firstPair.first) + " and " + pickName(firstPair.second) +
                " follow each other at the same point of the surface" + alsoConcerned(bad, 2) +
                ": remove one of them",
            bad
        );
    }
}

void requireOneComponent(const Projections& projections, const std::vector<int>& faceComponents) {
    const auto componentOf = [&](const TriangleTree::Closest& closest) {
        return faceComponents[closest.point.face];
    };
    Elements bad;
    for (std::size_t i = 1; i < projections.size(); ++i) {
        if (componentOf(projections[i]) != componentOf(projections[0])) {
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        const auto first = static_cast<std::size_t>(bad.front());
        throw InputError(
            InputErrorCode::PicksOnDifferentComponents,
            pickName(first) + " lies on another connected component of the surface than " +
                pickName(0) + alsoConcerned(bad, 1) +
                ": pick points on one component, or join them with MeshLab's filter 'Merge Close "
                "Vertices' if they only look joined",
            bad
        );
    }
}

}  // namespace

std::vector<SurfacePoint> locatePicks(
    const Surface& surface, const TriangleTree& tree, const std::vector<Vec3>& picks, bool closed
) {
    requireEnoughPicks(picks, closed);
    requireFinitePicks(picks);

    Projections projections;
    projections.reserve(picks.size());
    for (const Vec3& pick : picks) {
        projections.push_back(tree.closestPoint(pick));
    }
    requireNearSurface(projections, surface.diagonal());
    requireSeparatePicks(projections, closed, surface.diagonal());
    requireOneComponent(projections, surface.faceComponents());

    std::vector<SurfacePoint> points;
    points.reserve(picks.size());
    for (const TriangleTree::Closest& projection : projections) {
        points.push_back(projection.point);
    }
    return points;
}

}  // namespace bspline_curve
