// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/strip_search.h"
#include "surface/strip_unfolding.h"
#include "surface/surface.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A polyline on the surface from one point to another: consecutive points share a face.
struct GeodesicPath {
    std::vector<SurfacePoint> points;  ///< start, a point on each edge crossed, goal
    std::vector<Vec3> positions;
    double length = 0.0;
};

/// Finds locally shortest paths, or where faces cost differently, cheap ones.
///
/// A search over the midpoints of edges gives a strip of faces (StripSearch); the shortest path in
/// the strip is straightened by unfolding it into the plane (funnel algorithm); wherever the path
/// bends round a vertex whose other side is cheaper, the strip is moved to that side, until none is
/// left. Where all faces cost the same the result is a geodesic: it turns only at vertices with
/// more than 2 pi of angle, at boundaries and at faces that may not be entered. Not always the
/// globally shortest one.
class GeodesicPathFinder {
public:
    /// `patches`: see StripSearch.
    GeodesicPathFinder(
        const Surface& surface, TravelCosts costs, const PatchLevels* patches = nullptr
    )
        : surface_(surface), search_(surface, std::move(costs), patches) {}

    /// The path, or nothing if there is none. Cost: see StripSearch::find.
    [[nodiscard]] std::optional<GeodesicPath> find(
        const SurfacePoint& start, const SurfacePoint& goal
    );

    /// See StripSearch.
    [[nodiscard]] std::size_t explored() const { return search_.explored(); }

private:
    using Strip = std::vector<int>;

    // A strip, and the shortest path in it.
    struct Route {
        Strip strip;
        StripPath path;
        double cost = 0.0;
    };

    // The picks of one query, and the faces that hold them.
    struct Ends {
        SurfacePoint start, goal;
        std::vector<int> startFaces, goalFaces;
    };

    [[nodiscard]] Route routeIn(Strip strip, const Ends& ends);
    void straighten(Route& route, const Ends& ends);
    [[nodiscard]] std::optional<Route> otherSide(
        const Route& route, const StripPath::Corner& corner, const Ends& ends
    );
    [[nodiscard]] bool rerouteAround(int vertex, std::size_t portal, Strip& strip);
    [[nodiscard]] Vec3 crossingPosition(const Route& route, std::size_t portal) const;

    const Surface& surface_;
    StripSearch search_;
};

}  // namespace bspline_curve
