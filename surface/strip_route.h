// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/strip_unfolding.h"
#include "surface/surface.h"
#include "surface/travel_costs.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A way in a strip of faces between two points, pulled tight: wherever the path bends round a
/// vertex whose other side is cheaper, the strip is moved to that side, until none is left.
class StripRoute {
public:
    /// `strip`: from one of the faces that hold the start to one that holds the goal. Refers to
    /// surface and costs.
    StripRoute(
        const Surface& surface,
        KnownCosts& costs,
        std::vector<int> strip,
        const SurfacePoint& start,
        const SurfacePoint& goal
    );

    /// Moves the strip until no corner of the path has a cheaper side. A corner is judged between
    /// the corners before and after it, and all that are to move and do not touch each other move
    /// at once, so that a try costs as much as the way between three corners is long.
    void straighten();

    [[nodiscard]] const std::vector<int>& strip() const { return strip_; }

    /// The shortest path in the strip.
    [[nodiscard]] const StripPath& path() const { return path_; }

private:
    using Strip = std::vector<int>;

    // Where the way between two corners begins or ends: a corner's vertex, or -1 and the point
    // itself.
    struct End {
        int vertex;
        SurfacePoint point;
        std::vector<int> faces;  // open ones that hold the point
    };

    // A corner, by its vertex and those of its neighbours.
    struct Corner {
        int before, vertex, after;

        friend bool operator==(const Corner&, const Corner&) = default;
    };

    // The part of the way from the corner before a corner to the one after it.
    struct Window {
        std::size_t first, last;  // faces, in the strip
        std::size_t portal;       // of the corner, in the strip
        int vertex;
        End before, after;
    };

    // What a part of the strip is to become.
    struct Move {
        Corner corner;
        std::size_t first, last;
        Strip faces;
    };

    void pullTight();
    [[nodiscard]] std::vector<std::size_t> sharpestFirst() const;
    [[nodiscard]] Window windowAt(std::size_t corner) const;
    [[nodiscard]] std::vector<Move> cheaperSides();
    [[nodiscard]] std::optional<Move> cheaperSide(const Window& window, double bend);
    [[nodiscard]] bool areCheaper(const std::vector<Move>& moves);
    [[nodiscard]] bool rerouteAround(int vertex, std::size_t portal, Strip& strip);
    [[nodiscard]] bool holds(int face, const End& end) const;
    void trim(Strip& strip, const End& from, const End& to) const;
    [[nodiscard]] SurfacePoint pointIn(int face, const End& end) const;
    [[nodiscard]] Vec3 positionOf(const End& end) const;
    [[nodiscard]] double shortestCost(const Strip& strip, const End& from, const End& to);
    [[nodiscard]] double costNow(const Window& window);

    const Surface& surface_;
    KnownCosts& costs_;
    End start_, goal_;
    Strip strip_;
    StripPath path_;
    double cost_ = 0.0;
    std::vector<Corner> settled_;  // whose other sides are not cheaper
};

}  // namespace bspline_curve
