// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A polyline on the surface from one point to another: consecutive points share a face.
struct GeodesicPath {
    std::vector<SurfacePoint> points;  ///< start, a point on each edge crossed, goal
    std::vector<Vec3> positions;
    double length = 0.0;
};

/// Finds locally shortest paths. Holds work arrays of O(#F), so keep one for many queries.
///
/// A search (A*) over the midpoints of edges gives a strip of faces; the shortest path in the strip
/// is straightened by unfolding it into the plane (funnel algorithm); wherever the path bends round
/// a vertex whose other side is shorter, the strip is moved to that side, until none is left. The
/// result is a geodesic: it turns only at vertices with more than 2 pi of angle, at boundaries and
/// at blocked faces. Not always the globally shortest one.
class GeodesicPathFinder {
public:
    /// `blocked`, one flag per face or empty: faces that a path may not enter.
    GeodesicPathFinder(const Surface& surface, std::vector<char> blocked);

    /// The path, or nothing if there is none. O(k log k), k the faces nearer to the start than the
    /// goal is.
    [[nodiscard]] std::optional<GeodesicPath> find(
        const SurfacePoint& start, const SurfacePoint& goal
    );

private:
    using Strip = std::vector<int>;

    [[nodiscard]] std::vector<int> openFacesHolding(const SurfacePoint& point) const;
    [[nodiscard]] bool isBlocked(int face) const;
    [[nodiscard]] std::optional<Strip> findStrip(
        const SurfacePoint& start, const SurfacePoint& goal
    );
    [[nodiscard]] bool rerouteAround(int vertex, std::size_t portal, Strip& strip) const;

    const Surface& surface_;
    std::vector<char> blocked_;
    std::vector<double> cost_;
    std::vector<int> parent_;
    std::vector<int> touched_;
};

}  // namespace bspline_curve
