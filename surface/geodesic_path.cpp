// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

#include "surface/strip_route.h"
#include "surface/surface_point.h"

#include <utility>

namespace bspline_curve {
std::optional<GeodesicPath> GeodesicPathFinder::find(
    const SurfacePoint& start, const SurfacePoint& goal, int mostPatches
) {
    std::optional<StripSearch::Way> way = search_.find(start, goal, mostPatches);
    if (!way) {
        return std::nullopt;
    }
    GeodesicPath result;
    result.isOverPatches = way->strip.empty();
    if (result.isOverPatches) {
        result.points = std::move(way->overPatches);
        result.points.insert(result.points.begin(), start);
        result.points.push_back(goal);
    } else {
        result.points = straightened(std::move(way->strip), start, goal);
    }
    for (const SurfacePoint& point : result.points) {
        result.positions.push_back(surface_.position(point));
        if (result.positions.size() > 1) {
            result.length += (result.positions.back() - *(result.positions.end() - 2)).norm();
        }
    }
    return result;
}

std::vector<SurfacePoint> GeodesicPathFinder::straightened(
    std::vector<int> strip, const SurfacePoint& start, const SurfacePoint& goal
) {
    StripRoute route(surface_, search_.costs(), std::move(strip), start, goal);
    route.straighten();
    const StripPath& path = route.path();
    std::vector<SurfacePoint> points{inFace(surface_, start, route.strip().front())};
    for (std::size_t i = 0; i + 1 < route.strip().size(); ++i) {
        const Triangle& face = surface_.faces()[route.strip()[i]];
        SurfacePoint point{route.strip()[i], Vec3::Zero()};
        point.barycentric[cornerOf(face, path.lefts[i])] = 1.0 - path.crossings[i];
        point.barycentric[cornerOf(face, path.rights[i])] = path.crossings[i];
        points.push_back(point);
    }
    points.push_back(inFace(surface_, goal, route.strip().back()));
    return points;
}

}  // namespace bspline_curve
