// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/drawing.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve {

struct DrawingFile {
    Drawing drawing;                 ///< y upwards
    std::vector<std::string> notes;  ///< what of the file was left out
};

/// Reads the paths of a planar drawing: .svg (all shapes and path commands, groups, transforms,
/// viewBox, use; text and images are left out) or .dxf (lines, polylines, arcs, ellipses, splines
/// and inserted blocks, seen along z; curves whose ends meet are one path). The unit is that of the
/// file; of an SVG whose width has a physical unit, millimetres. What cannot be drawn is left out;
/// notes count it. `layers`: of a DXF, those to read; empty: all that are visible. Throws
/// InputError (UnreadableFile) naming file, line and what is wrong where there is no path at all.
[[nodiscard]] DrawingFile readDrawing(
    const std::filesystem::path& file, const std::vector<std::string>& layers = {}
);

}  // namespace bspline_curve
