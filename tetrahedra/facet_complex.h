// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"
#include "shell/shell.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

class tetgenio;  // NOLINT(readability-identifier-naming): of TetGen

namespace bspline_curve {

/// Triangles that meet in common corners and edges alone, as TetGen wants them. Points are told
/// apart by their coordinates, so that vertices of the surface which are middles of pillars are one
/// point.
class FacetComplex {
public:
    /// The point at these coordinates; made where there is none.
    int pointAt(const Vec3& position);

    /// A point of its own number, which later ones at the same coordinates become; of several such
    /// points the first.
    void reservePoint(const Vec3& position);

    /// Its corners counter-clockwise where it is oriented. Returns its points.
    Triangle add(const std::array<Vec3, 3>& corners);

    [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

    /// Infinite where there is no triangle.
    [[nodiscard]] double shortestEdge() const;

    /// Runs TetGen with these switches; facet i has the marker i + 1. Returns the error that it
    /// stopped with, 0 for none. Not in two threads at once.
    [[nodiscard]] int runTetgen(std::string switches, tetgenio& output) const;

private:
    std::map<std::array<double, 3>, int> numbers_;
    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
};

/// Edges of a complex that are shorter than this, where its diagonal is about 1, are too much for
/// TetGen 1.5: it merges their ends, or crashes.
inline constexpr double kLeastTetgenEdge = 1e-6;

enum class BoundaryPart : std::uint8_t { Top, Bottom, Wall };

/// Adds top and bottom of a shell and the walls where it ends, counter-clockwise seen from outside;
/// returns what each triangle is part of.
std::vector<BoundaryPart> addShellBoundary(const Shell& shell, FacetComplex& complex);

/// Adds the faces of the surface that are not blocked, without ghosts; returns them.
std::vector<int> addSurfaceFaces(
    const ExtendedSurface& extended, std::span<const int> blockedFaces, FacetComplex& complex
);

}  // namespace bspline_curve
