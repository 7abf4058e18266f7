// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_path.h"

#include "design/taut_path.h"
#include "surface/corridor_search.h"
#include "surface/geodesic_path.h"
#include "surface/input_error.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

[[noreturn]] void throwNoPath(std::size_t from, std::size_t to, const Terrain& terrain) {
    const std::span<const int> blockedFaces = terrain.blockedFaces;
    std::string message = "no way along the surface from pick " + std::to_string(from) +
                          " to pick " + std::to_string(to);
    if (terrain.obstacles != nullptr) {
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
TravelCosts totalCosts(const Surface& surface, const Terrain& terrain) {
    if (terrain.field.empty() && terrain.blockedFaces.empty() && terrain.obstacles == nullptr) {
        return {};
    }
    return {[&surface, &terrain](int face) {
        if (std::ranges::binary_search(terrain.blockedFaces, face)) {
            return std::numeric_limits<double>::infinity();
        }
        const double cost =
            terrain.field.empty() ? 1.0 : terrain.field.costOf(surface.faces()[at(face)]);
        return terrain.obstacles == nullptr ? cost : cost * terrain.obstacles->pathCost(face);
    }};
}

// The point where a path leaves a face for that of the next point, away from the obstacles.
SurfacePoint keptClear(
    const Surface& surface,
    const Obstacles& obstacles,
    const SurfacePoint& point,
    const SurfacePoint& next
) {
    const Triangle& neighbours = surface.faceNeighbours()[at(point.face)];
    for (int k = 0; k < 3; ++k) {
        if (neighbours[at(k)] == next.face && point.barycentric[k] == 0.0) {
            return obstacles.keptClear(point, k);
        }
    }
    return point;
}

// Ways are sought among patches alone where the surface has as many of them, which are then small
// beside all that the first path is for, and the way leads over as many.
constexpr int kFinePatches = 8192;
constexpr int kLongWay = 12;
// Else among faces. Longer strips of these are pulled taut at points of them instead of
// straightened vertex by vertex.
constexpr std::size_t kLongStrip = 64;

// Finds paths from pick to pick.
class PathFinder {
public:
    PathFinder(const Surface& surface, const ShellBase& base, const Terrain& terrain)
        : base_(base),
          terrain_(terrain),
          costs_(totalCosts(surface, terrain)),
          finder_(surface, costs_, terrain.patches) {
        if (isOpen() && terrain.patches != nullptr) {
            ways_.emplace(surface, *terrain.patches, costs_);
        }
    }

    [[nodiscard]] std::optional<std::vector<SurfacePoint>> find(
        const SurfacePoint& start, const SurfacePoint& goal
    ) {
        std::optional<std::vector<SurfacePoint>> path;
        if (ways_) {
            path = ways_->findWay(start, goal, kFinePatches, kLongWay);
            path = path ? pullTaut(base_, terrain_.patches, terrain_.field, *path) : std::nullopt;
        }
        if (!path) {
            path = findOverFaces(start, goal);
        }
        return path;
    }

private:
    // Whether strings may be pulled taut: there is nothing to keep out of.
    [[nodiscard]] bool isOpen() const {
        return terrain_.kind == PathKind::Quick && terrain_.obstacles == nullptr &&
               terrain_.blockedFaces.empty();
    }

    [[nodiscard]] std::optional<std::vector<SurfacePoint>> findOverFaces(
        const SurfacePoint& start, const SurfacePoint& goal
    ) {
        std::optional<GeodesicPath> path =
            isOpen() ? finder_.find(start, goal, kLongStrip) : finder_.find(start, goal);
        if (path && !path->isStraight) {
            std::optional<std::vector<SurfacePoint>> taut =
                pullTaut(base_, terrain_.patches, terrain_.field, path->points);
            if (taut) {
                return taut;
            }
            path = finder_.find(start, goal);
        }
        return path ? std::optional(std::move(path->points)) : std::nullopt;
    }

    const ShellBase& base_;
    const Terrain& terrain_;
    TravelCosts costs_;
    GeodesicPathFinder finder_;
    std::optional<CorridorSearch> ways_;
};

}  // namespace

PickPath makePickPath(
    const Surface& surface,
    const ShellBase& base,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const Terrain& terrain
) {
    PathFinder finder(surface, base, terrain);
    PickPath result;
    double length = 0.0;
    const auto add = [&](const SurfacePoint& point) {
        const Vec3 position = base.position(point);
        if (!result.guide.points.empty()) {
            length += (position - result.guide.points.back().position).norm();
        }
        result.guide.points.push_back({length, point, position});
    };
    const std::size_t intervals = closed ? picks.size() : picks.size() - 1;
    for (std::size_t i = 0; i < intervals; ++i) {
        const std::size_t next = (i + 1) % picks.size();
        const std::optional<std::vector<SurfacePoint>> path = finder.find(picks[i], picks[next]);
        if (!path) {
            throwNoPath(i, next, terrain);
        }
        for (std::size_t k = 0; k < path->size(); ++k) {
            // A path starts where the one before ended, but perhaps in another of the faces that
            // hold the pick.
            const bool isPick = k == 0 || k + 1 == path->size();
            add(terrain.obstacles == nullptr || isPick
                    ? (*path)[k]
                    : keptClear(surface, *terrain.obstacles, (*path)[k], (*path)[k + 1]));
            if (k == 0) {
                result.picks.push_back(
                    {path->front(), result.guide.points.back().position, length}
                );
            }
        }
        if (i + 1 == intervals && !closed) {
            const GuidePath::Point& last = result.guide.points.back();
            result.picks.push_back({last.point, last.position, length});
        }
    }
    for (GuidePath::Point& point : result.guide.points) {
        point.parameter /= length;
    }
    for (PickConstraint& pick : result.picks) {
        pick.parameter /= length;
    }
    result.guide.points.back().parameter = 1.0;
    if (!closed) {
        result.picks.back().parameter = 1.0;
    }
    return result;
}

}  // namespace bspline_curve
