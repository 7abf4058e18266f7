// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/surface.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

// Polylines that pass from sheet to sheet, over edges where mending has parted the faces.
namespace bspline_curve {

/// Throws InputError (NoPath) as strictLine(), but not where a polyline of the surface's input
/// passes from sheet to sheet. `name`: of the curve.
void checkLine(const Surface& surface, const SurfacePolyline& line, const std::string& name);

/// Polylines of the input of a surface on which they are strict.
struct JoinedLines {
    std::shared_ptr<const Surface> surface;
    std::vector<SurfacePolyline> lines;
};

/// The surface itself, or one of the same input that is joined anew where lines pass from sheet to
/// sheet. There lines have further points where they pass from one part of a divided face to
/// another, and no parameters. Lines that are in no faces, or that need more than can be joined at
/// once, are left to strictLine(). O(n log n).
[[nodiscard]] JoinedLines joinedFor(
    const std::shared_ptr<const Surface>& surface, std::span<const SurfacePolyline> lines
);

}  // namespace bspline_curve
