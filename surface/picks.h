// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <vector>

namespace bspline_curve {

/// Picks farther than this from the surface are refused (relative to the diagonal).
inline constexpr double kPickReachRelative = 0.01;
/// Consecutive picks nearer than this coincide (relative to the diagonal).
inline constexpr double kPickSeparationRelative = 1e-9;

/// Picks on the surface. Those that follow each other at the same point (for a closed curve the
/// last and the first too) are one.
struct LocatedPicks {
    std::vector<SurfacePoint> points;
    std::vector<int> pointOf;  ///< for each pick as given, its index in `points`; ascending but for
                               ///< those at the end that coincide with the first of a closed curve

    /// Picks, as given, that coincide with the one before, ascending.
    [[nodiscard]] std::vector<int> repeated() const;

    /// Of each point, the first pick there.
    [[nodiscard]] std::vector<int> firstPicks() const;
};

/// What messages call places that a curve is drawn through, and what to do where they are no good.
struct PlaceWords {
    const char* one;
    const char* many;
    int firstNumber;
    const char* more;      ///< of too few
    const char* nearer;    ///< of one that is too far from the surface
    const char* together;  ///< of ones on several components
};

inline constexpr PlaceWords kPickWords{
    .one = "pick",
    .many = "picks",
    .firstNumber = 1,
    .more = "pick more points on the mesh",
    .nearer = "pick a point on the mesh",
    .together = "pick points on one component"
};

/// Of the vertices of a line that is there already.
inline constexpr PlaceWords kVertexWords{
    .one = "vertex",
    .many = "vertices",
    .firstNumber = 0,
    .more = "give a longer line",
    .nearer = "give the mesh that the line belongs to, or a direction to drape it along",
    .together = "give a line on one component"
};

/// Projects picked points to the surface (closest point), in order. Where connected components lie
/// within 1e-6 diagonals of each other, to one component if all picks are as near to it.
/// `reach`: picks that are farther from the surface are refused; 0: kPickReachRelative. Throws
/// InputError: TooFewPicks (fewer than 2, or 3 when closed), NonFiniteCoordinate,
/// PickTooFar, CoincidentPicks (so few different ones), PicksOnDifferentComponents; each names the
/// picks by their index from 0; messages say it in `words`.
[[nodiscard]] LocatedPicks locatePicks(
    const Surface& surface,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    bool closed,
    double reach = 0.0,
    const PlaceWords& words = kPickWords
);

}  // namespace bspline_curve
