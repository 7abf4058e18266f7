// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/polyline_formats.h"
#include "pattern/spline_arcs.h"

#include <array>
#include <map>
#include <vector>

// Curves of files in space, and the polylines along them.
namespace bspline_curve {

/// Arcs that follow each other.
struct SpacePath {
    std::vector<SpaceArc> arcs;
    bool closed = false;  ///< the last arc ends where the first begins
};

/// Closes a path whose ends meet but for rounding. Expects an arc.
void closeWhereEndsMeet(SpacePath& path);

/// Makes polylines of paths: chords are within 1e-5 of the size of a path from it, and equal points
/// of all paths are one.
class PathLines {
public:
    void add(const SpacePath& path);

    [[nodiscard]] PolylineGraph take();

private:
    void addEdge(const Vec3& from, const Vec3& to);
    int indexOf(const Vec3& point);

    std::map<std::array<double, 3>, int> indices_;
    PolylineGraph graph_;
};

}  // namespace bspline_curve
