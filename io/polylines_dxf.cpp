// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of DXF files as polylines in space.
#include "io/dxf_curves.h"
#include "io/polyline_formats.h"

#include <utility>

namespace bspline_curve {

PolylineGraph polylinesOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
) {
    DxfCurves curves = curvesOfDxf(file, bytes, layers);
    PathLines lines;
    for (const SpacePath& path : curves.paths) {
        lines.add(path);
    }
    PolylineGraph graph = lines.take();
    graph.notes = std::move(curves.notes);
    return graph;
}

}  // namespace bspline_curve
