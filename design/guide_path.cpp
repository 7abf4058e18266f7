// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/guide_path.h"

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
    const std::vector<int>& blockedFaces = terrain.blockedFaces;
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

// What a unit of length costs in each face, all told.
std::vector<double> totalCosts(const Surface& surface, const Terrain& terrain) {
    std::vector<double> costs = terrain.faceCosts;
    if (costs.empty() && (terrain.obstacles != nullptr || !terrain.blockedFaces.empty())) {
        costs.assign(at(surface.faceCount()), 1.0);
    }
    for (const int f : terrain.blockedFaces) {
        costs[at(f)] = std::numeric_limits<double>::infinity();
    }
    if (terrain.obstacles != nullptr) {
        for (int f = 0; f < surface.faceCount(); ++f) {
            costs[at(f)] *= terrain.obstacles->pathCost(f);
        }
    }
    return costs;
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

}  // namespace

PickPath makePickPath(
    const Surface& surface,
    const ShellBase& base,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const Terrain& terrain
) {
    GeodesicPathFinder finder(surface, totalCosts(surface, terrain));
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
        const std::optional<GeodesicPath> path = finder.find(picks[i], picks[next]);
        if (!path) {
            throwNoPath(i, next, terrain);
        }
        for (std::size_t k = 0; k < path->points.size(); ++k) {
            // A path starts where the one before ended, but perhaps in another of the faces that
            // hold the pick.
            const bool isPick = k == 0 || k + 1 == path->points.size();
            add(terrain.obstacles == nullptr || isPick
                    ? path->points[k]
                    : keptClear(surface, *terrain.obstacles, path->points[k], path->points[k + 1]));
            if (k == 0) {
                result.picks.push_back(
                    {path->points[0], result.guide.points.back().position, length}
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

std::vector<double> faceCostsOf(
    const Surface& surface,
    std::span<const double> vertexCosts,
    const SolverOptions& options,
    double share
) {
    const double weight = share * options.fieldWeight / kUsualBending;
    if (vertexCosts.empty() || weight == 0.0 || !options.fieldGuidesPath) {
        return {};
    }
    std::vector<double> costs;
    costs.reserve(surface.faces().size());
    for (const Triangle& face : surface.faces()) {
        const double sum =
            vertexCosts[at(face[0])] + vertexCosts[at(face[1])] + vertexCosts[at(face[2])];
        costs.push_back(sum / 3.0);
    }
    const double least = std::ranges::min(costs);
    for (double& cost : costs) {
        cost = 1.0 + weight * (cost - least);
    }
    return costs;
}

}  // namespace bspline_curve
