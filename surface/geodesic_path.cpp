// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

#include "surface/strip_route.h"
#include "surface/surface_point.h"

#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

std::optional<GeodesicPath> GeodesicPathFinder::find(
    const SurfacePoint& start, const SurfacePoint& goal
) {
    std::optional<std::vector<int>> found = search_.find(start, goal);
    if (!found) {
        return std::nullopt;
    }
    StripRoute route(surface_, search_.costs(), std::move(*found), start, goal);
    route.straighten();

    const std::vector<int>& strip = route.strip();
    const StripPath& path = route.path();
    GeodesicPath result;
    result.points.push_back(inFace(surface_, start, strip.front()));
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
        const Triangle& face = surface_.faces()[at(strip[i])];
        SurfacePoint point{strip[i], Vec3::Zero()};
        point.barycentric[cornerOf(face, path.lefts[i])] = 1.0 - path.crossings[i];
        point.barycentric[cornerOf(face, path.rights[i])] = path.crossings[i];
        result.points.push_back(point);
    }
    result.points.push_back(inFace(surface_, goal, strip.back()));
    for (const SurfacePoint& point : result.points) {
        result.positions.push_back(surface_.position(point));
        if (result.positions.size() > 1) {
            result.length += (result.positions.back() - *(result.positions.end() - 2)).norm();
        }
    }
    return result;
}

}  // namespace bspline_curve
