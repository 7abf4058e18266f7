// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/projected_polyline.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve {

struct PolylineFile {
    std::vector<SpacePolyline> lines;
    /// For each line where its points are on the mesh that the file is of, as the file says; empty:
    /// it does not say so.
    std::vector<std::vector<SurfacePoint>> places;
    std::vector<std::string> notes;  ///< what of the file was left out
};

/// The curves of a file as polylines, in its order: .ply (elements vertex and edge), .obj
/// (statements l, and curv of B-splines), .dxf (all that drawings are read from, in space), .vtu
/// (lines) or .csv (points in order). Edges that share a vertex are chained, and chains cut where
/// more than two meet. At least one. `layers`: of a DXF, those to read; empty: all that are
/// visible. Throws InputError (UnreadableFile) naming file and place: another format, a damaged
/// file, one without edges, a point that is not finite.
[[nodiscard]] PolylineFile readPolylines(
    const std::filesystem::path& file, const std::vector<std::string>& layers = {}
);

}  // namespace bspline_curve
