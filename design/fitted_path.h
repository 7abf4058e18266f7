// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/initial_path.h"
#include "shell/extended_surface.h"
#include "surface/patch_levels.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A line on the surface that is to become smooth, and the points that it is known by.
struct MeasuredLine {
    InitialPath path;  ///< closed: ends where it starts
    bool closed = false;

    struct Point {
        double parameter;  ///< of the path, ascending
        Vec3 position;
        double weight;  ///< > 0
    };

    std::vector<Point> points;
};

/// How smooth, in the shell's frame.
struct FitTarget {
    double spread;      ///< root of the mean square distance of the points to be reached, > 0
    double wavelength;  ///< of waves that are half flattened at first, > 0
    double shortest, longest;  ///< bounds of that
};

struct FittedPath {
    InitialPath path;
    double spread = 0.0;      ///< that was reached
    double wavelength = 0.0;  ///< of waves that are half flattened
};

/// A smooth path near a line: the curve x over the length s of the line with the least
///   sum_k weight_k |x(s_k) - y_k|^2 / sum_k weight_k + (wavelength / 2 pi)^4 / L integral |x''|^2
/// in space (a smoothing spline, Reinsch 1967; an open one ends where the line does), with the
/// wavelength at which the points y_k are as far from it as the target says, and its feet on the
/// surface. The length of the line is L.
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
