// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/corridor_search.h"
#include "surface/patch_levels.h"
#include "surface/surface.h"
#include "surface/travel_costs.h"
#include "utility/sparse_map.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Finds strips of faces, each joined to the next by an edge, along which the way from one point to
/// another over midpoints of edges costs least (A*). Its memory is in proportion to what it has
/// looked at, and is used again, so keep one for many queries.
class StripSearch {
public:
    /// `patches`: of the surface; null, or no levels: the strips are those of least cost. Else they
    /// are sought along the way of least cost among patches, in work that grows with the length
    /// of the way instead of the number of faces, and everywhere only where that leads to none.
    /// Refers to both.
    StripSearch(const Surface& surface, TravelCosts costs, const PatchLevels* patches = nullptr);
    StripSearch(const StripSearch&) = delete;
    StripSearch& operator=(const StripSearch&) = delete;

    /// Exactly one of them has elements.
    struct Way {
        std::vector<int> strip;  ///< from a face that holds the start to one that holds the goal
        std::vector<SurfacePoint> overPatches;  ///< see CorridorSearch::pointsOnWay
    };

    /// The way from one point to another, or nothing if there is none: a strip, unless it leads
    /// over more than `mostPatches` patches. O(k log k), k the faces nearer to the start than the
    /// goal is.
    [[nodiscard]] std::optional<Way> find(
        const SurfacePoint& start,
        const SurfacePoint& goal,
        int mostPatches = std::numeric_limits<int>::max()
    );

    [[nodiscard]] KnownCosts& costs() { return costs_; }

    /// How many edges and patches all queries so far have looked at.
    [[nodiscard]] std::size_t explored() const {
        return explored_ + arrivals_.size() + (corridor_ ? corridor_->explored() : 0);
    }

private:
    // A crossing 3 f + k leaves face f over the edge opposite to its corner k; the places of offers
    // are crossings.
    struct Arrival {
        double cost;
        int crossing;  // by which the way arrives
        int before;    // the crossing before that, or -1
    };

    // The points of one query, and the open faces that hold them.
    struct Ends {
        const SurfacePoint& start;
        const SurfacePoint& goal;
        std::vector<int> startFaces, goalFaces;
    };

    // Where a search may go.
    enum class Extent : char { Corridor, Everywhere };

    [[nodiscard]] std::optional<Way> search(const Ends& ends, Extent extent);
    [[nodiscard]] bool mayEnter(int face);
    [[nodiscard]] Vec3 middle(int crossing) const;
    [[nodiscard]] int faceBehind(int crossing) const;
    [[nodiscard]] int edgeOf(int crossing) const;
    void leave(int face, const Vec3& from, double cost, int before);
    [[nodiscard]] std::vector<int> stripTo(int crossing) const;

    const Surface& surface_;
    KnownCosts costs_;
    std::optional<CorridorSearch> corridor_;
    Extent extent_ = Extent::Everywhere;
    SparseMap<Arrival> arrivals_;  // at an edge
    std::size_t explored_ = 0;
    OfferQueue queue_;
    Vec3 goal_ = Vec3::Zero();
};

}  // namespace bspline_curve
