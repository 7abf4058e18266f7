// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/initial_path.h"

#include "bspline_curve/error.h"
#include "design/close_chords.h"
#include "design/shortened_path.h"
#include "surface/geodesic_path.h"
#include "text/error_messages.h"
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
    std::size_t legFrom, std::size_t legTo, const PathConstraints& constraints
) {
    const std::span<const int> blocked = constraints.blockedFaces;
    const auto numberOf = [&](std::size_t pick) {
        const std::span<const int> numbers = constraints.pickNumbers;
        return numbers.empty() ? static_cast<std::int64_t>(pick) : std::int64_t{numbers[pick]};
    };
    const std::int64_t from = numberOf(legFrom);
    const std::int64_t to = numberOf(legTo);
    const std::string what =
        "no way along the surface from " + describePicks({from}) + " to " + describePicks({to});
    const std::vector<std::int64_t> faces(blocked.begin(), blocked.end());
    if (constraints.obstacles != nullptr) {
        throw InputError(
            InputErrorCode::NoPath,
            what + " that goes round the faces to avoid" +
                (blocked.empty() ? "" : " and those where the surface crosses itself or folds") +
                ": avoid fewer faces, or move a pick",
            {std::min(from, to), std::max(from, to)}
        );
    }
    if (blocked.empty()) {
        throw InputError(InputErrorCode::NoPath, what + ": move a pick");
    }
    throw InputError(
        InputErrorCode::SelfIntersection,
        what + " that avoids the " + std::to_string(blocked.size()) +
            " faces where the surface crosses itself or folds (faces " + describeElements(faces) +
            "): mend the mesh there, or move a pick",
        faces
    );
}

// What a unit of length costs in each face, all told. Refers to both.
TravelCosts totalCosts(const Surface& surface, const PathConstraints& constraints) {
    if (constraints.blockedFaces.empty() && constraints.obstacles == nullptr &&
        constraints.field.empty()) {
        return {};
    }
    return {
        [&surface, &constraints](int face) {
            if (std::ranges::binary_search(constraints.blockedFaces, face)) {
                return std::numeric_limits<double>::infinity();
            }
            const FieldTravel& field = constraints.field;
            const double cost = field.empty() ? 1.0 : field.costOf(surface.faces()[face]);
            const Obstacles* const obstacles = constraints.obstacles;
            return obstacles == nullptr ? cost : cost * obstacles->pathCost(face);
        },
        1.0,
        constraints.field.empty()
    };
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

struct InitialPathConstants {
    int mostPatches = 16;       // that a way is over to be straightened in a strip of faces, vertex
                                // by vertex; over more it is shortened at points of it
    int mostFieldPatches = 11;  // likewise under a field, which the cost of each face is asked of
    double mostDetour = 2.0;    // of the way over a gap to its chord, as over a wedge of 60 degrees
    double longNeedle = 0.1;    // of a way over patches: patches of longer needles lead astray
};

constexpr InitialPathConstants kInitialPath;

// Finds paths from pick to pick.
class PathFinder {
public:
    PathFinder(
        const Surface& surface, const ExtendedSurface& extended, const PathConstraints& constraints
    )
        : surface_(surface),
          extended_(extended),
          constraints_(constraints),
          finder_(surface, totalCosts(surface, constraints), constraints.patches) {}

    [[nodiscard]] std::optional<std::vector<SurfacePoint>> find(
        const SurfacePoint& start, const SurfacePoint& goal
    ) {
        std::optional<GeodesicPath> path = finder_.find(start, goal, mostPatches());
        if (path && path->isOverPatches) {
            const std::optional<std::vector<SurfacePoint>> points = shortened(path->points);
            if (points && !mayBeDetour(*points, *path)) {
                return points;
            }
            path = finder_.find(start, goal);
            if (points && path && lengthOf(*points) <= path->length) {
                return points;
            }
        }
        return path ? std::optional(std::move(path->points)) : std::nullopt;
    }

private:
    // Shortened paths do not see blocked faces, and leave the surface between their points.
    [[nodiscard]] int mostPatches() const {
        if (!constraints_.blockedFaces.empty() || constraints_.kind == PathKind::OnSurface) {
            return std::numeric_limits<int>::max();
        }
        return constraints_.field.empty() ? kInitialPath.mostPatches
                                          : kInitialPath.mostFieldPatches;
    }

    // Whether a way over patches deserves a second look. Under a field short ways are not sought.
    [[nodiscard]] bool mayBeDetour(
        std::span<const SurfacePoint> shortened, const GeodesicPath& way
    ) const {
        const auto isLongNeedle = [&](const SurfacePoint& point) {
            return needleLength(surface_, point.face) > kInitialPath.longNeedle * way.length;
        };
        return constraints_.field.empty() &&
               (lengthOf(shortened) > way.length || std::ranges::any_of(way.points, isLongNeedle));
    }

    [[nodiscard]] double lengthOf(std::span<const SurfacePoint> points) const {
        double length = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            length += (surface_.position(points[i]) - surface_.position(points[i - 1])).norm();
        }
        return length;
    }

    // A way over patches, shortened; nothing where that is of no use.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> shortened(
        std::span<const SurfacePoint> way
    ) {
        const std::optional<ShortenedPath> path =
            shortenPath(extended_, constraints_.patches, constraints_.field, way);
        std::optional<std::vector<SurfacePoint>> points;
        if (path && isClear(*path)) {
            points = withGapsClosed(*path);
        }
        return points && constraints_.kind == PathKind::Close
                   ? withCloseChords(
                         extended_, constraints_.patches, *points, constraints_.chordDistance
                     )
                   : points;
    }

    // Shortened paths do not see obstacles either.
    [[nodiscard]] bool isClear(const ShortenedPath& path) const {
        const Obstacles* const obstacles = constraints_.obstacles;
        return obstacles == nullptr ||
               std::ranges::all_of(path.points, [&](const SurfacePoint& point) {
                   return obstacles->isFar(point.face);
               });
    }

    // The points of a path, with ways over its gaps; nothing where one is much longer than its gap,
    // so that the path passes through the surface.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> withGapsClosed(
        const ShortenedPath& path
    ) {
        std::vector<SurfacePoint> points;
        auto begin = path.points.begin();
        for (const std::size_t gap : path.gaps) {
            const auto end = path.points.begin() + static_cast<std::ptrdiff_t>(gap) + 1;
            points.insert(points.end(), begin, end);
            begin = end;
            const std::optional<GeodesicPath> way = finder_.find(*(end - 1), *end);
            if (!way || way->length > kInitialPath.mostDetour *
                                          (way->positions.back() - way->positions.front()).norm()) {
                return std::nullopt;
            }
            points.insert(points.end(), way->points.begin() + 1, way->points.end() - 1);
        }
        points.insert(points.end(), begin, path.points.end());
        return points;
    }

    const Surface& surface_;
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

void PickPath::divideParameters(double length, bool closed) {
    for (InitialPath::Point& point : path.points) {
        point.parameter /= length;
    }
    for (PickConstraint& pick : picks) {
        pick.parameter /= length;
    }
    path.points.back().parameter = 1.0;
    if (!closed) {
        picks.back().parameter = 1.0;
    }
}

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
        if (!legs[i]) {
            throwNoPath(i, (i + 1) % picks.size(), constraints);
        }
        const std::vector<SurfacePoint>& leg = *legs[i];
        for (std::size_t k = 0; k < leg.size(); ++k) {
            // A leg starts where the one before ended, but perhaps in another of the faces that
            // hold the pick.
            const bool isPick = k == 0 || k + 1 == leg.size();
            add(constraints.obstacles == nullptr || isPick
                    ? leg[k]
                    : keptClear(surface, *constraints.obstacles, leg[k], leg[k + 1]));
            if (k == 0 || (k + 1 == leg.size() && i + 1 == legs.size() && !closed)) {
                const InitialPath::Point& pick = result.path.points.back();
                result.picks.push_back({pick.point, pick.position, length});
            }
        }
    }
    result.divideParameters(length, closed);
    return result;
}

}  // namespace bspline_curve
