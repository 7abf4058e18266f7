// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_path.h"

#include "design/taut_path.h"
#include "solver/field_cost.h"
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

double meanOver(const Triangle& face, std::span<const double> vertexCosts) {
    const double sum =
        vertexCosts[at(face[0])] + vertexCosts[at(face[1])] + vertexCosts[at(face[2])];
    return sum / 3.0;
}

// The least of all faces' means. A face below another has a vertex below that, and few are.
double leastMean(const Surface& surface, std::span<const double> vertexCosts) {
    double least = meanOver(surface.faces().front(), vertexCosts);
    for (int v = 0; v < surface.vertexCount(); ++v) {
        if (vertexCosts[at(v)] < least) {
            for (const int f : surface.facesAround(v)) {
                least = std::min(least, meanOver(surface.faces()[at(f)], vertexCosts));
            }
        }
    }
    return least;
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

// What pulls a taut path. The energy E_int of a path is its squared length over the squared
// distance of its ends, so this weight of the field has the minimum of length times cost.
CurveProblem tautProblem(
    const ShellBase& base, const FieldTravel& field, const GeodesicPath& path
) {
    CurveProblem problem;
    problem.base = &base;
    if (!field.empty()) {
        problem.field.assign(field.vertexCosts.begin(), field.vertexCosts.end());
        for (const int origin : base.ghostOrigin) {
            problem.field.push_back(field.vertexCosts[at(origin)]);
        }
        double excess = 0.0;
        for (const SurfacePoint& point : path.points) {
            const double cost = field.costOf(base.faces[at(point.face)]);
            excess += (cost - 1.0) / static_cast<double>(path.points.size());
        }
        const double detour = path.length / (path.positions.back() - path.positions.front()).norm();
        problem.options.fieldWeight = 2.0 * field.weight * detour * detour / (1.0 + excess);
        problem.options.fieldCost = FieldCost::Identity;
        problem.fieldCosts = {.least = field.least, .meanExcess = 1.0};
    }
    return problem;
}

// Longer strips of faces are pulled taut at samples instead of straightened vertex by vertex, where
// there is nothing to keep out of. That depends on roundings a little more than straightening.
constexpr std::size_t kLongStrip = 200;

std::optional<std::vector<SurfacePoint>> findPath(
    GeodesicPathFinder& finder,
    const ShellBase& base,
    const Terrain& terrain,
    const SurfacePoint& start,
    const SurfacePoint& goal
) {
    const bool isOpen = terrain.obstacles == nullptr && terrain.blockedFaces.empty();
    std::optional<GeodesicPath> path =
        isOpen ? finder.find(start, goal, kLongStrip) : finder.find(start, goal);
    if (path && !path->isStraight) {
        std::optional<std::vector<SurfacePoint>> taut =
            pullTaut(tautProblem(base, terrain.field, *path), path->points);
        if (taut) {
            return taut;
        }
        path = finder.find(start, goal);
    }
    return path ? std::optional(std::move(path->points)) : std::nullopt;
}

}  // namespace

PickPath makePickPath(
    const Surface& surface,
    const ShellBase& base,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const Terrain& terrain
) {
    GeodesicPathFinder finder(surface, totalCosts(surface, terrain), terrain.patches);
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
        const std::optional<std::vector<SurfacePoint>> path =
            findPath(finder, base, terrain, picks[i], picks[next]);
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

double FieldTravel::costOf(const Triangle& face) const {
    return 1.0 + weight * (meanOver(face, vertexCosts) - least);
}

FieldTravel fieldTravelOf(
    const Surface& surface,
    std::span<const double> vertexCosts,
    const SolverOptions& options,
    double share
) {
    const double weight = share * options.fieldWeight / kUsualBending;
    if (vertexCosts.empty() || weight == 0.0 || !options.fieldGuidesPath) {
        return {};
    }
    return {vertexCosts, weight, leastMean(surface, vertexCosts)};
}

}  // namespace bspline_curve
