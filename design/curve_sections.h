// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

#include <span>
#include <vector>

namespace bspline_curve {

// A curve with corners is drawn section by section: from one corner, or an end, to the next. The
// sides of a corner know of each other by that point alone.

/// The points of each section, in order, as indices of those of the whole curve; empty where it has
/// no corner that parts it. The first section of a closed curve begins at point 0, or passes it.
/// `corners`: ascending, in [0, count).
[[nodiscard]] std::vector<std::vector<int>> pointsOfSections(
    int count, std::span<const int> corners, bool closed
);

struct DrawnSection {
    std::vector<int> points;  ///< as above
    Curve curve;              ///< open, through them
};

/// The whole curve: sections have parameters by their lengths, corners are one vertex and one
/// control point, and the report is that of the worst section, with sums of what was done. O(n).
[[nodiscard]] Curve joinedCurve(std::span<const DrawnSection> sections, bool closed);

/// The sections of a curve as curves of their own, as others may start from: polyline, spline, and
/// of the report what a start is asked for. None where it has other corners. `pointsOfEach`: see
/// pointsOfSections(), for the curve's picks.
[[nodiscard]] std::vector<Curve> sectionsOfCurve(
    const Curve& whole, std::span<const std::vector<int>> pointsOfEach
);

}  // namespace bspline_curve
