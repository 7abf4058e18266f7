// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/initial_path.h"

#include "bspline_curve/error.h"
#include "design/close_chords.h"
#include "design/shortened_path.h"
#include "surface/error_messages.h"
#include "surface/geodesic_path.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace bspline_curve {
namespace {

[[noreturn]] void throwNoPath(
    std::size_t from, std::size_t to, const PathConstraints& constraints
) {
    const std::span<const int> blockedFaces = constraints.blockedFaces;
    std::string message = "no way along the surface from pick " + std::to_string(from) +
                          " to pick " + std::to_string(to);
    if (constraints.obstacles != nullptr) {
        throw InputError(
            InputErrorCode::NoPath,
            message + " that goes round the faces to avoid" +
                (blockedFaces.empty() ? ""
                                      : " and those where the surface crosses itself or folds") +
                ": avoid fewer faces, or move a pick",
            {static_cast<std::int64_t>(from), static_cast<std::int64_t>(to)}
        );
    }
    std::vector<std::int64_t> elements(blockedFaces.begin(), blockedFaces.end());
    if (blockedFaces.empty()) {
        throw InputError(InputErrorCode::NoPath, message + ": move a pick", std::move(elements));
    }
    message += " that avoids the " + std::to_string(blockedFaces.size()) +
               " faces where the surface crosses itself or folds (faces " +
               describeElements(elements) +
               "): repair them (in MeshLab: Select Self Intersecting Faces, delete, Close Holes), "
               "or move a pick";
    throw InputError(InputErrorCode::SelfIntersection, message, std::move(elements));
}

// What a unit of length costs in each face, all told. Refers to both.
TravelCosts totalCosts(const Surface& surface, const PathConstraints& constraints) {
    if (constraints.blockedFaces.empty() && constraints.obstacles == nullptr) {
        if (constraints.field.empty()) {
            return {};
        }
        return {[&surface, &constraints](int face) {
            return constraints.field.costOf(surface.faces()[face]);
        }};
    }
    return {[&surface, &constraints](int face) {
        if (std::ranges::binary_search(constraints.blockedFaces, face)) {
            return std::numeric_limits<double>::infinity();
        }
        const double cost =
            constraints.field.empty() ? 1.0 : constraints.field.costOf(surface.faces()[face]);
        return constraints.obstacles == nullptr ? cost
                                                : cost * constraints.obstacles->pathCost(face);
    }};
}

// The point where a path leaves a face for that of the next point, away from the obstacles.
SurfacePoint keptClear(
    const Surface& surface,
    const Obstacles& obstacles,
    const SurfacePoint& point,
    const SurfacePoint& next
) {
    const Triangle& neighbours = surface.faceNeighbours()[point.face];
    for (int k = 0; k < 3; ++k) {
        if (neighbours[k] == next.face && point.barycentric[k] == 0.0) {
            return obstacles.keptClear(point, k);
        }
    }
    return point;
}

// Ways over more patches are pulled taut at points of them, instead of straightened vertex by
// vertex in a strip of faces. Under a field, which the cost of each face is asked of, fewer pay.
constexpr int kMostPatches = 16;
constexpr int kMostFieldPatches = 11;
// By which the way over the surface may be longer than a gap of the string: that over the edge of a
// wedge of sixty degrees.
constexpr double kMostDetour = 2.0;

// Finds paths from pick to pick.
class PathFinder {
public:
    PathFinder(
        const Surface& surface, const ExtendedSurface& extended, const PathConstraints& constraints
    )
        : extended_(extended),
          constraints_(constraints),
          finder_(surface, totalCosts(surface, constraints), constraints.patches) {}

    [[nodiscard]] std::optional<std::vector<SurfacePoint>> find(
        const SurfacePoint& start, const SurfacePoint& goal
    ) {
        std::optional<GeodesicPath> path = finder_.find(start, goal, mostPatches());
        if (path && path->isOverPatches) {
            if (std::optional<std::vector<SurfacePoint>> points = string(path->points)) {
                return points;
            }
            path = finder_.find(start, goal);
        }
        return path ? std::optional(std::move(path->points)) : std::nullopt;
    }

private:
    // Strings do not see blocked faces, and leave the surface between their points.
    [[nodiscard]] int mostPatches() const {
        if (!constraints_.blockedFaces.empty() || constraints_.kind == PathKind::OnSurface) {
            return std::numeric_limits<int>::max();
        }
        return constraints_.field.empty() ? kMostPatches : kMostFieldPatches;
    }

    // Along a way over patches; nothing where none is of use.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> string(
        std::span<const SurfacePoint> path
    ) {
        const std::optional<ShortenedPath> taut =
            shortenPath(extended_, constraints_.patches, constraints_.field, path);
        std::optional<std::vector<SurfacePoint>> points = taut ? laid(*taut) : std::nullopt;
        return points && constraints_.kind == PathKind::Close
                   ? withCloseChords(
                         extended_, constraints_.patches, *points, constraints_.chordDistance
                     )
                   : points;
    }

    // Strings do not see obstacles either.
    [[nodiscard]] bool isClear(const ShortenedPath& string) const {
        return constraints_.obstacles == nullptr ||
               std::ranges::all_of(string.points, [this](const SurfacePoint& point) {
                   return constraints_.obstacles->isFar(point.face);
               });
    }

    // Its points, with paths over its gaps; nothing where one is much longer than its gap, so that
    // the string passes through the surface, or near obstacles.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> laid(const ShortenedPath& string) {
        if (!isClear(string)) {
            return std::nullopt;
        }
        std::vector<SurfacePoint> points;
        auto gap = string.gaps.begin();
        for (std::size_t i = 0; i < string.points.size(); ++i) {
            points.push_back(string.points[i]);
            if (gap == string.gaps.end() || *gap != i) {
                continue;
            }
            ++gap;
            const std::optional<GeodesicPath> path =
                finder_.find(string.points[i], string.points[i + 1]);
            if (!path) {
                return std::nullopt;
            }
            const double straight = (path->positions.back() - path->positions.front()).norm();
            if (path->length > kMostDetour * straight) {
                return std::nullopt;
            }
            points.insert(points.end(), path->points.begin() + 1, path->points.end() - 1);
        }
        return points;
    }

    const ExtendedSurface& extended_;
    const PathConstraints& constraints_;
    GeodesicPathFinder finder_;
};

// The points from a pick to the next; nothing where there is no way.
using Leg = std::optional<std::vector<SurfacePoint>>;

std::vector<Leg> findLegs(
    const Surface& surface,
    const ExtendedSurface& extended,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const PathConstraints& constraints
) {
    std::vector<Leg> legs(closed ? picks.size() : picks.size() - 1);
    // One finder of each thread, for as many legs as it comes to.
    std::atomic<std::size_t> next = 0;
    forEach(constraints.side, 2, 1, [&](int) {
        PathFinder finder(surface, extended, constraints);
        for (std::size_t leg = next++; leg < legs.size(); leg = next++) {
            legs[leg] = finder.find(picks[leg], picks[(leg + 1) % picks.size()]);
        }
    });
    return legs;
}

}  // namespace

PickPath makePickPath(
    const Surface& surface,
    const ExtendedSurface& extended,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const PathConstraints& constraints
) {
    const std::vector<Leg> legs = findLegs(surface, extended, picks, closed, constraints);
    PickPath result;
    double length = 0.0;
    const auto add = [&](const SurfacePoint& point) {
        const Vec3 position = extended.position(point);
        if (!result.path.points.empty()) {
            length += (position - result.path.points.back().position).norm();
        }
        result.path.points.push_back({length, point, position});
    };
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const Leg& path = legs[i];
        if (!path) {
            throwNoPath(i, (i + 1) % picks.size(), constraints);
        }
        for (std::size_t k = 0; k < path->size(); ++k) {
            // A path starts where the one before ended, but perhaps in another of the faces that
            // hold the pick.
            const bool isPick = k == 0 || k + 1 == path->size();
            add(constraints.obstacles == nullptr || isPick
                    ? (*path)[k]
                    : keptClear(surface, *constraints.obstacles, (*path)[k], (*path)[k + 1]));
            if (k == 0) {
                result.picks.push_back({path->front(), result.path.points.back().position, length});
            }
        }
        if (i + 1 == legs.size() && !closed) {
            const InitialPath::Point& last = result.path.points.back();
            result.picks.push_back({last.point, last.position, length});
        }
    }
    for (InitialPath::Point& point : result.path.points) {
        point.parameter /= length;
    }
    for (PickConstraint& pick : result.picks) {
        pick.parameter /= length;
    }
    result.path.points.back().parameter = 1.0;
    if (!closed) {
        result.picks.back().parameter = 1.0;
    }
    return result;
}

}  // namespace bspline_curve
