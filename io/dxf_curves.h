// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/space_paths.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

struct DxfCurves {
    std::vector<SpacePath> paths;
    std::vector<std::string> notes;  ///< what of the file was left out
};

/// The curves of a DXF text that its author sees in model space: LINE, POLYLINE, LWPOLYLINE, ARC,
/// CIRCLE, ELLIPSE, SPLINE (with control points or with fit points alone) and INSERT. Entities of
/// paper space, invisible ones, and those on layers that are off or frozen are left out; so are
/// entities that cannot be drawn; notes count them and name the first. `layers`: only those on one
/// of these, also where it is off; empty: on any. Throws InputError (UnreadableFile) where the file
/// is no DXF text, where nothing is left, and where blocks in blocks come to more than a million
/// parts.
[[nodiscard]] DxfCurves curvesOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers = {}
);

}  // namespace bspline_curve
