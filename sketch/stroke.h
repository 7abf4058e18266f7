// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A line drawn freehand, and where the curve along it goes: alone, or between picks that stay.
struct Stroke {
    std::vector<SketchPick> line;           ///< on the surface, in order
    bool closed = false;                    ///< of the line alone
    std::vector<SketchPick> before, after;  ///< picks of a curve that stay on either side
    /// Whether the ends of the line become picks; else one that stays is there.
    bool hasFirst = true, hasLast = true;

    /// The picks of the whole curve, where these are the ones along the line.
    [[nodiscard]] std::vector<SketchPick> joined(const std::vector<SketchPick>& along) const;

    /// Few points of the line, its ends among them: picks until those of the fitted curve are
    /// known.
    [[nodiscard]] std::vector<SketchPick> thinned() const;
};

/// Those of many picks along a curve by which it is described: a polyline through them alone is
/// within a distance of all others (D. Douglas, T. Peucker, 1973), so that a fair curve through
/// them is nearer. The ends and all corners are among them, and at least four of a closed curve.
[[nodiscard]] std::vector<SketchPick> describing(
    const std::vector<SketchPick>& along, bool closed, double within
);

/// A stroke from curve to curve in place of the stretch between: of a closed curve, of the one that
/// is nearer to the stroke. The ends lie on the curve then, at a pick where one is within `reach`
/// (user's unit). None where the curve is not settled, or both ends are at the same place. O(n m)
/// for n points of the polyline and m of the stroke.
[[nodiscard]] std::optional<Stroke> strokeInto(
    const SketchCurve& curve, std::vector<SketchPick> line, double reach
);

}  // namespace bspline_curve
