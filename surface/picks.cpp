// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/picks.h"

#include "bspline_curve/error.h"
#include "surface/closest_point.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Components that vertices within so many diagonals part only look parted.
constexpr double kGapRelative = 1e-6;
/// Projections of a place come to rest, or go round among a few neighbouring doubles, sooner.
constexpr std::size_t kMostSettling = 64;

using Closest = TriangleTree::Closest;

std::string named(const PlaceWords& words, std::vector<std::int64_t> places) {
    for (std::int64_t& place : places) {
        place += words.firstNumber;
    }
    return std::string(places.size() == 1 ? words.one : words.many) + " " +
           describeElements(places);
}

// Refuses the places for which isBad holds, unless there are none. The message names the first one;
// what(first) goes on.
template <class Condition, class What>
void refuseWhere(
    InputErrorCode code,
    std::size_t count,
    const Condition& isBad,
    const What& what,
    const PlaceWords& words,
    const std::string& remedy,
    std::size_t most = 1
) {
    auto bad = indicesWhere<std::int64_t>(count, isBad);
    if (bad.empty()) {
        return;
    }
    std::string message = named(words, {bad.front()}) + what(bad.front());
    if (bad.size() > most) {
        message += " (all that are concerned: " + named(words, bad) + ")";
    }
    throw InputError(code, message + ": " + remedy, std::move(bad));
}

// As many picks as the curve needs, of finite coordinates.
void requireUsable(const std::vector<Vec3>& picks, bool closed, const PlaceWords& words) {
    const std::size_t count = picks.size();
    const std::size_t needed = closed ? 3 : 2;
    if (count < needed) {
        throw InputError(
            InputErrorCode::TooFewPicks,
            std::string(closed ? "a closed" : "an open") + " curve needs at least " +
                std::to_string(needed) + " " + words.many + ", not " + std::to_string(count) +
                ": " + words.more
        );
    }
    refuseWhere(
        InputErrorCode::NonFiniteCoordinate,
        count,
        [&](std::size_t i) { return !picks[i].allFinite(); },
        [](std::size_t) { return " has a coordinate that is not a finite number"; },
        words,
        words.nearer
    );
}

LocatedPicks withoutRepeats(
    const std::vector<Closest>& projections, double separation, bool closed, const PlaceWords& words
) {
    LocatedPicks located;
    std::vector<Vec3> positions;
    const auto meets = [&](const Vec3& position, const Vec3& other) {
        return (position - other).norm() < separation;
    };
    for (const auto& [point, position, squaredDistance] : projections) {
        if (positions.empty() || !meets(position, positions.back())) {
            located.points.push_back(point);
            positions.push_back(position);
        }
        located.pointOf.push_back(static_cast<int>(positions.size()) - 1);
    }
    while (closed && positions.size() > 1 && meets(positions.back(), positions.front())) {
        positions.pop_back();
        located.points.pop_back();
    }
    const auto count = static_cast<int>(positions.size());
    std::ranges::replace_if(located.pointOf, [&](int point) { return point >= count; }, 0);
    refuseWhere(
        InputErrorCode::CoincidentPicks,
        count < (closed ? 3 : 2) ? projections.size() : 0,
        [&](std::size_t i) {
            const std::vector<int> repeated = located.repeated();
            return contains(repeated, static_cast<int>(i)) ||
                   contains(repeated, static_cast<int>(i) + 1);
        },
        [&](std::size_t) {
            return " and others coincide, which leaves " +
                   describeCount(positions.size(), "point", "points") + " of the surface, but " +
                   (closed ? "a closed curve needs 3" : "an open curve needs 2");
        },
        words,
        words.more,
        0
    );
    return located;
}

std::vector<int> componentsOf(const Surface& surface, const std::vector<Closest>& projections) {
    std::vector<int> components;
    for (const Closest& projection : projections) {
        components.push_back(surface.faceComponents()[projection.point.face]);
    }
    return components;
}

bool areEqual(const std::vector<int>& components) {
    return std::ranges::count(components, components.front()) == std::ssize(components);
}

// The closest point of each component that is hardly farther than the closest of all.
std::map<int, Closest> closestOnEach(
    const Surface& surface, const TriangleTree& tree, const Vec3& pick, const Closest& closest
) {
    const double reach = std::sqrt(closest.squaredDistance) + kGapRelative * surface.diagonal();
    std::map<int, Closest> found;
    tree.forEachNear(pick, reach, [&](int face) {
        const auto [barycentric, position, squaredDistance] =
            closestPointOnTriangle(surface.vertices(), surface.faces()[face], pick);
        if (squaredDistance > reach * reach) {
            return;
        }
        const Closest here{{face, barycentric}, position, squaredDistance};
        const auto [at, isFirst] = found.try_emplace(surface.faceComponents()[face], here);
        const auto rank = [](const Closest& one) {
            return std::pair(one.squaredDistance, one.point.face);
        };
        if (!isFirst && rank(here) < rank(at->second)) {
            at->second = here;
        }
    });
    return found;
}

// Where components lie upon each other the closest one may be another for each pick. Those of the
// first component that is as near to all of them; nothing where there is none.
std::optional<std::vector<Closest>> onCommonComponent(
    const Surface& surface,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    const std::vector<Closest>& projections
) {
    std::vector<std::map<int, Closest>> found;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        found.push_back(closestOnEach(surface, tree, picks[i], projections[i]));
    }
    for (const auto& [component, unused] : found.front()) {
        std::vector<Closest> common;
        for (const std::map<int, Closest>& each : found) {
            if (const auto at = each.find(component); at != each.end()) {
                common.push_back(at->second);
            }
        }
        if (common.size() == picks.size()) {
            return common;
        }
    }
    return std::nullopt;
}

// The place in its face that projections from place to place come to, the same bit for bit from
// wherever among them they start: a pick that was saved with its curve leads to that curve again.
void settle(const Surface& surface, Closest& pick) {
    const auto projected = [&](const Vec3& position) {
        return closestPointOnTriangle(
            surface.vertices(), surface.faces()[pick.point.face], position
        );
    };
    std::vector<Vec3> passed{pick.position};
    while (passed.size() < kMostSettling) {
        const Vec3 next = projected(passed.back()).position;
        const auto again = std::ranges::find(passed, next);
        if (again != passed.end()) {
            const auto isLess = [](const Vec3& a, const Vec3& b) {
                return std::ranges::lexicographical_compare(a, b);
            };
            const auto place = projected(*std::ranges::min_element(again, passed.end(), isLess));
            pick.point.barycentric = place.barycentric;
            pick.position = place.position;
            return;
        }
        passed.push_back(next);
    }
}

}  // namespace

LocatedPicks locatePicks(
    const Surface& surface,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    bool closed,
    double reach,
    const PlaceWords& words
) {
    requireUsable(picks, closed, words);
    const std::size_t count = picks.size();
    std::vector<Closest> projections;
    projections.reserve(count);
    for (const Vec3& pick : picks) {
        projections.push_back(tree.closestPoint(pick));
    }
    const auto distance = [&](std::size_t i) { return std::sqrt(projections[i].squaredDistance); };
    const double allowed = reach > 0.0 ? reach : kPickReachRelative * surface.diagonal();
    refuseWhere(
        InputErrorCode::PickTooFar,
        count,
        [&](std::size_t i) { return !(distance(i) <= allowed); },
        [&](std::size_t first) {
            const std::string most =
                reach > 0.0 ? "is allowed"
                            : describeNumber(100.0 * kPickReachRelative) + " % of the diagonal";
            return " lies " + describeNumber(distance(first)) + " from the surface, more than " +
                   most + " (" + describeNumber(allowed) + ")";
        },
        words,
        words.nearer
    );

    std::vector<int> components = componentsOf(surface, projections);
    if (!areEqual(components)) {
        if (auto common = onCommonComponent(surface, tree, picks, projections)) {
            projections = std::move(*common);
            components = componentsOf(surface, projections);
        }
    }
    refuseWhere(
        InputErrorCode::PicksOnDifferentComponents,
        count,
        [&](std::size_t i) { return components[i] != components[0]; },
        [&](std::size_t) {
            return " lies on another connected component of the surface than " + named(words, {0});
        },
        words,
        words.together
    );

    for (Closest& projection : projections) {
        settle(surface, projection);
    }
    return withoutRepeats(projections, kPickSeparationRelative * surface.diagonal(), closed, words);
}

std::vector<int> LocatedPicks::repeated() const {
    return indicesWhere<int>(pointOf.size(), [&](std::size_t i) {
        return i > 0 && (pointOf[i] == pointOf[i - 1] || pointOf[i] < pointOf[i - 1]);
    });
}

std::vector<int> LocatedPicks::firstPicks() const {
    std::vector<int> first;
    for (int pick = 0; pick < static_cast<int>(pointOf.size()); ++pick) {
        if (pointOf[pick] == static_cast<int>(first.size())) {
            first.push_back(pick);
        }
    }
    return first;
}

}  // namespace bspline_curve
