// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/pattern.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// Makes the paths of a drawing with a pen, as drawing programs tell them.
class DrawingBuilder {
public:
    using Vec2 = Eigen::Vector2d;

    /// Where a path ends this near to its start, in its size, it is closed there.
    static constexpr double kClosedRelative = 1e-5;

    /// Begins a path.
    void moveTo(const Vec2& point);
    void lineTo(const Vec2& point);
    /// A Bézier curve by its control points after the pen's place.
    void curveTo(const std::vector<Vec2>& points, std::vector<double> weights = {});
    /// Arcs of which the first begins at the pen.
    void follow(const std::vector<DrawingArc>& arcs);
    /// Closes the path, with a line where it is not yet at its start; the pen is there then.
    void close();

    [[nodiscard]] const Vec2& pen() const { return pen_; }

    /// The drawing, its paths numbered. Those without arcs that are longer than 0 are left out.
    [[nodiscard]] Drawing take();

private:
    void finish();

    Drawing drawing_;
    Vec2 pen_ = Vec2::Zero(), start_ = Vec2::Zero();
    std::optional<DrawingPath> path_;
};

}  // namespace bspline_curve
