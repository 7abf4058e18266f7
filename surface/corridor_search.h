// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/patch_levels.h"
#include "surface/surface.h"
#include "surface/travel_costs.h"
#include "utility/sparse_map.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace bspline_curve {

/// In a corridor the rest of a way is taken to be longer by this factor, as it is over midpoints
/// and centres: far fewer of them are looked at, and the path is straightened in the end anyway.
inline constexpr double kCorridorEstimate = 1.25;

/// Finds corridors: the patches around a cheap way between two points. The way is sought among the
/// largest patches, then among the smaller ones that lie in or beside those on the way, and so on:
/// the work grows with the length of the way in faces, not with their number.
class CorridorSearch {
public:
    /// Refers to all of these.
    CorridorSearch(const Surface& surface, const PatchLevels& patches, const TravelCosts& costs);

    enum class Found {
        Nothing,   ///< that patches know of: a way along the surface may exist all the same
        Corridor,  ///< in which none need exist where faces are closed
        LongWay,   ///< over more patches than asked for, and no corridor
    };

    /// Looks for the corridor between two points, each in its face, as far as ways lead over no
    /// more than `mostPatches` patches. The coarsest level where one leads over more ends the
    /// search, so the work for long ways does not depend on the number of faces.
    [[nodiscard]] Found find(
        const SurfacePoint& start,
        const SurfacePoint& goal,
        int mostPatches = std::numeric_limits<int>::max()
    );

    /// The long way that was found last: a face in each patch between the two points.
    [[nodiscard]] std::vector<SurfacePoint> pointsOnWay() const;

    /// Whether a face lies in the corridor that was found last.
    [[nodiscard]] bool holds(int face) const {
        return corridor_.contains(patches_.levels().front().patchOf[face]);
    }

    /// How many patches all queries so far have looked at.
    [[nodiscard]] std::size_t explored() const { return explored_; }

private:
    struct Arrival {
        double cost;
        int before;  // the patch before, or -1
    };

    // Where a way begins or ends, and the patches that hold it, one of each level.
    struct End {
        Vec3 position;
        std::vector<int> patches;
    };

    [[nodiscard]] End endAt(const SurfacePoint& point) const;
    [[nodiscard]] bool findIn(std::size_t level, const End& start, const End& goal);
    void leave(const Offer& from, std::size_t level, const End& start, const End& goal);
    void keepAround(std::size_t level);
    [[nodiscard]] int centralFace(int patch) const;
    [[nodiscard]] double costOf(std::size_t level, int patch);

    const Surface& surface_;
    const PatchLevels& patches_;
    const TravelCosts& costs_;
    std::vector<SparseMap<double>> known_;  // costs of patches, by level
    SparseMap<char> corridor_;              // patches of the level searched last
    std::vector<int> way_;                  // and those that its way leads over, from the goal on
    std::size_t levelOfWay_ = 0;            // where it is a long one
    SparseMap<Arrival> arrivals_;
    OfferQueue queue_;
    std::size_t explored_ = 0;
};

}  // namespace bspline_curve
