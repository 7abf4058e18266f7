// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/line_smoother.h"
#include "shell/extended_surface.h"
#include "surface/patch_levels.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// How smooth, in the shell's frame.
struct FitTarget {
    double spread;      ///< root of the mean square distance of the points to be reached, > 0
    double wavelength;  ///< of waves that are half flattened at first, > 0
    double shortest, longest;  ///< bounds of that
    LineSmoother::Stiffness stiffness;
    double cornerAngle;    ///< radians; pi: there are none
    double cornerWave;     ///< corners are looked for with waves so long flattened, or longer ones
    double chordDistance;  ///< of the path's chords from the surface, > 0
};

/// From one corner of a line to the next, or to its ends; the first of a closed line with corners
/// begins at a corner.
struct FittedPath {
    std::vector<InitialPath> sections;  ///< parameters of each from 0 to 1 by length
    std::vector<double> turns;          ///< of the line at its corners, radians
    double spread = 0.0;                ///< that was reached
    double wavelength = 0.0;            ///< of waves that are half flattened
};

/// A smooth path near a line (see LineSmoother), with the wavelength at which the points are as far
/// from it as the target says, corners where it turns by the target's angle and more, and its feet
/// on the surface.
///
/// O(n), about 10 microseconds a point. Nothing where the path leaves the surface over its boundary
/// or does not hold together.
[[nodiscard]] std::optional<FittedPath> fittedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const MeasuredLine& line,
    const FitTarget& target
);

}  // namespace bspline_curve
