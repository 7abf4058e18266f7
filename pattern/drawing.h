// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/pattern.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace bspline_curve {

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
