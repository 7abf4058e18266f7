// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace bspline_curve {

/// A part of a planar path: a Bézier curve of any degree, rational where it has weights. Lines have
/// 2 points; elliptical arcs are rational of degree 2.
struct DrawingArc {
    using Vec2 = Eigen::Vector2d;

    std::vector<Vec2> points;     ///< control points, at least 2
    std::vector<double> weights;  ///< one for each, > 0; empty: all are 1

    /// The point at a parameter in [0, 1].
    [[nodiscard]] Vec2 at(double t) const;
    /// Unit directions at the ends; zero where all points are one.
    [[nodiscard]] Vec2 startDirection() const;
    [[nodiscard]] Vec2 endDirection() const;

    [[nodiscard]] bool isLine() const { return points.size() == 2; }
};

/// Arcs that follow each other: each begins where the one before ends.
struct DrawingPath {
    std::vector<DrawingArc> arcs;
    bool closed = false;  ///< the last arc ends where the first begins
    int number = 0;       ///< in its drawing, from 0
    int copy = 0;         ///< of the drawing, from 0
};

/// What is to be carried to a surface: x to the right, y upwards.
struct Drawing {
    std::vector<DrawingPath> paths;
    /// Where a line of text stands, y; none: the drawing has no such line.
    std::optional<double> baseline{};

    /// The least box that holds all paths, to 1e-9 of its size. Empty where there are none.
    [[nodiscard]] Eigen::AlignedBox2d box() const;
};

/// How large a drawing becomes. At most one of the two is > 0; both 0: see the functions.
struct DrawingScale {
    double size = 0.0;   ///< the longer side of the drawing's box, user's unit
    double scale = 0.0;  ///< user's units for one unit of the drawing

    /// Throws InputError (BadOption).
    void validate() const;
};

/// The size round a point if none is given, relative to the diagonal of the surface.
inline constexpr double kDrawingSizeRelative = 0.1;

/// Copies of a drawing along a curve.
struct RowLayout {
    DrawingScale scale;    ///< none: as large as lets the copies touch
    int repeat = 0;        ///< copies, evenly spaced; 0: as many as `spacing` says, or one
    double spacing = 0.0;  ///< from one copy to the next, user's unit; 0: as `repeat` says
    double start = 0.0;    ///< where on the curve the first copy begins, user's unit, >= 0
    double shift = 0.0;    ///< of the drawing to the left of the curve, user's unit

    /// Throws InputError (BadOption).
    void validate() const;
};

struct PatternOptions {
    double cornerAngle = 20.0;  ///< degrees, in (0, 179]: paths that turn more have a corner there
    /// How far a curve may be from the carried drawing, user's unit; 0: kPatternToleranceRelative.
    double tolerance = 0.0;

    /// Passes of smoothing over a copy of the surface on which the ways of the drawing are
    /// found, in [0, 1000]: on rough scans the drawing comes out more evenly.
    int smoothing = 0;

    /// Throws InputError (BadOption).
    void validate() const;
};

/// The tolerance if none is given, in the mean diagonal of the boxes of paths.
inline constexpr double kPatternToleranceRelative = 1e-3;

/// A smooth piece of a path of a drawing, as a curve on the surface.
struct PatternCurve {
    Curve curve;
    int path = 0;  ///< DrawingPath::number
    int copy = 0;  ///< DrawingPath::copy
};

/// The length of a part of a curve, between two picks, relative to what was drawn.
struct Distortion {
    double ratio = 1.0;
    int path = 0, copy = 0;  ///< of the drawing
    Vec3 position = Vec3::Zero();
};

struct Pattern {
    std::vector<PatternCurve> curves;  ///< in the order of the paths, and along them
    double tolerance = 0.0;
    /// Largest distance of a carried point to its curve, user's unit. More than the tolerance only
    /// where the surface's faces bend the drawing within an edge's length.
    double largestDeviation = 0.0;
    Distortion shortest, longest;
};

/// Draws every path of a drawing round a point near the surface, where the middle of its box comes
/// to lie, as curves on the surface: one for each part without a corner, closed where the path is
/// closed and has none. Curves that meet in a corner end in the same point. They are drawn through
/// points of the drawing, carried along straight ways from the middle; they get more of them until
/// all of it is within the tolerance. `up`: where the drawing's y leads at the point; none: the
/// mesh's z, or where the surface is level its y. Throws InputError (BadOption; NoPath where paths
/// cannot be carried, whose numbers are elements(); PickTooFar where the point is farther than 1 %
/// of the diagonal from the surface), Cancelled.
[[nodiscard]] Pattern patternRoundPoint(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const Vec3& centre,
    const std::optional<Vec3>& up = {},
    const DrawingScale& scale = {},
    const PatternOptions& options = {},
    const Progress& progress = {}
);

/// Likewise copies of the drawing in a row along a curve, whose baseline or middle follows it.
/// Directions across the curve are taken over a mean edge length to both sides. Throws likewise,
/// and InputError (BadOption) where the copies are longer than the curve.
[[nodiscard]] Pattern patternAlongCurve(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const SurfacePolyline& curve,
    const RowLayout& layout = {},
    const PatternOptions& options = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
