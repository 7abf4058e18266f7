// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/strip_search.h"
#include "surface/surface.h"
#include "surface/window_search.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A path that is longer than another by this factor is a detour. The promise is 1.05; with 1.02
/// the search takes twice as long. Of 330 paths on scans none was longer than 1.02 times the
/// shortest.
inline constexpr double kDetour = 1.04;

/// The longest side of a face that is at least 8 times as long as its height over that side; else
/// 0.
[[nodiscard]] double needleLength(const Surface& surface, int face);

/// A polyline on the surface from one point to another: consecutive points share a face.
struct GeodesicPath {
    std::vector<SurfacePoint> points;  ///< start, a point on each edge crossed, goal
    std::vector<Vec3> positions;
    double length = 0.0;
    double cost = 0.0;           ///< the length, where all faces cost the same
    bool isOverPatches = false;  ///< of GeodesicPathFinder::find: consecutive points lie apart
};

/// Finds locally shortest paths, or where faces cost differently, cheap ones.
///
/// A search over the midpoints of edges gives a strip of faces (StripSearch); the shortest path in
/// the strip is straightened by unfolding it into the plane (funnel algorithm); wherever the path
/// bends round a vertex whose other side is cheaper, the strip is moved to that side, until none is
/// left. Where all faces cost the same the result is a geodesic: it turns only at
/// vertices with more than 2 pi of angle, at boundaries and at faces that may not be entered. Where
/// another is shorter by kDetour or more, WindowSearch finds it.
class GeodesicPathFinder {
public:
    /// `patches`: see StripSearch.
    GeodesicPathFinder(
        const Surface& surface, TravelCosts costs, const PatchLevels* patches = nullptr
    )
        : surface_(surface),
          search_(surface, std::move(costs), patches),
          windows_(surface, search_.costs()) {}

    /// The path, or nothing if there is none. Where it would lead over more than `mostPatches`
    /// patches: a point in each of these, since to straighten a path costs about as much as all
    /// faces between it and the geodesic. Cost of the search: see StripSearch::find.
    [[nodiscard]] std::optional<GeodesicPath> find(
        const SurfacePoint& start,
        const SurfacePoint& goal,
        int mostPatches = std::numeric_limits<int>::max()
    );

    /// The shortest path, up to rounding, where all faces cost the same, or nothing if there is
    /// none. Where that takes more than half a second to tell, the shortest one found so far: not
    /// longer than that of find().
    [[nodiscard]] std::optional<GeodesicPath> findShortest(
        const SurfacePoint& start, const SurfacePoint& goal
    );

    /// See StripSearch.
    [[nodiscard]] std::size_t explored() const { return search_.explored(); }

private:
    /// The best path that is shorter than `path` by a factor, or `path`.
    [[nodiscard]] GeodesicPath shorterBy(
        double factor,
        GeodesicPath path,
        const SurfacePoint& start,
        const SurfacePoint& goal,
        std::size_t mostWindows
    );
    [[nodiscard]] GeodesicPath pathOver(std::vector<SurfacePoint> points, bool isOverPatches) const;

    const Surface& surface_;
    StripSearch search_;
    WindowSearch windows_;
};

}  // namespace bspline_curve
