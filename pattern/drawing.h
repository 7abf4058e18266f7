// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Coordinates beyond this size are no drawing: their squares and products would overflow.
inline constexpr double kLargestDrawingCoordinate = 1e60;

/// Whether no coordinate of a path is NaN or that large.
[[nodiscard]] bool isUsablePath(const DrawingPath& path);

/// The elliptical arc centre + cos(angle) right + sin(angle) up, from one angle (radians) on by
/// `sweep`, in parts of a quarter turn at most.
[[nodiscard]] std::vector<DrawingArc> ellipticalArc(
    const Eigen::Vector2d& centre,
    const Eigen::Vector2d& right,
    const Eigen::Vector2d& up,
    double from,
    double sweep
);

/// Every point of the drawing mapped.
[[nodiscard]] Drawing mapped(Drawing drawing, const Eigen::Affine2d& map);

/// A part of a path without corners.
struct SmoothPiece {
    std::vector<DrawingArc> arcs;
    bool closed = false;
    int path = 0;  ///< an index into Drawing::paths

    /// The point at a parameter in [0, number of arcs].
    [[nodiscard]] Eigen::Vector2d at(double parameter) const;
};

/// The paths parted where they turn by more than an angle (radians), and without arcs that are
/// shorter than 1e-6 of the drawing's size.
[[nodiscard]] std::vector<SmoothPiece> smoothPieces(const Drawing& drawing, double cornerAngle);

}  // namespace bspline_curve
