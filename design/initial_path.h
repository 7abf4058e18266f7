// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/field_travel.h"
#include "shell/extended_surface.h"
#include "solver/initial_curve.h"
#include "solver/obstacles.h"
#include "surface/patch_levels.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

class WorkerThread;

struct PickPath {
    InitialPath path;
    std::vector<PickConstraint> picks;  ///< with parameters by length along the initial path

    /// Makes parameters that are lengths shares of the whole one.
    void divideParameters(double length, bool closed);
};

/// How a path lies on the surface.
enum class PathKind {
    Quick,      ///< long ways are points far apart, whose chords may leave the surface
    Close,      ///< the same with chords within a distance of the surface
    OnSurface,  ///< consecutive points share a face; takes a time that grows with the faces passed
};

/// What paths meet on the surface. Refers to what it is made from.
struct PathConstraints {
    std::span<const int> blockedFaces;  ///< where no shell is: no path enters them; ascending
    FieldTravel field{};
    const Obstacles* obstacles = nullptr;  ///< what paths keep clear of; null: nothing
    /// Of the surface, to find paths in a time that hardly depends on its number of faces; null:
    /// faces all over the surface are searched.
    const PatchLevels* patches = nullptr;
    PathKind kind = PathKind::Quick;
    double chordDistance = 0.0;    ///< of close ones, in the shell's frame
    WorkerThread* side = nullptr;  ///< to share the search with; null: none
    /// Of each pick its index among those that users gave, for messages; empty: the same.
    std::span<const int> pickNumbers{};
};

/// Paths from pick to pick, parametrised by length: geodesics where all faces cost the same.
/// Where there are obstacles they go round them, farther away where there is room.
/// Throws InputError (NoPath, SelfIntersection) naming the two picks.
[[nodiscard]] PickPath makePickPath(
    const Surface& surface,
    const ExtendedSurface& extended,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const PathConstraints& constraints
);

}  // namespace bspline_curve
