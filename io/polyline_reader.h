// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/projected_polyline.h"

#include <filesystem>
#include <vector>

namespace bspline_curve {

/// The polylines of a file, in its order: .ply (elements vertex and edge), .obj (statements l) or
/// .dxf (LINE, POLYLINE and LWPOLYLINE of a text file). Edges that share a vertex are chained, and
/// chains cut where more than two meet. At least one. Throws InputError (UnreadableFile) naming
/// file and place: another format, a damaged file, one without edges, a point that is not finite,
/// an entity of DXF that is a curve and no polyline.
[[nodiscard]] std::vector<SpacePolyline> readPolylines(const std::filesystem::path& file);

}  // namespace bspline_curve
