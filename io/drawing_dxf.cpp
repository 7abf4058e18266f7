// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of DXF files as paths of the plane z = 0, seen from above.
#include "io/drawing_formats.h"
#include "io/dxf_curves.h"
#include "pattern/drawing_chains.h"

#include <utility>

namespace bspline_curve {

namespace {

void drawFlat(DrawingBuilder& pen, const SpacePath& path) {
    pen.moveTo(path.arcs.front().points.front().head<2>());
    for (const SpaceArc& arc : path.arcs) {
        std::vector<DrawingBuilder::Vec2> points;
        for (auto point = arc.points.begin() + 1; point != arc.points.end(); ++point) {
            points.emplace_back(point->head<2>());
        }
        pen.curveTo(points, arc.weights);
    }
    if (path.closed) {
        pen.close();
    }
}

}  // namespace

DrawingFile drawingOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
) {
    DxfCurves curves = curvesOfDxf(file, bytes, layers);
    DrawingBuilder pen;
    for (const SpacePath& path : curves.paths) {
        drawFlat(pen, path);
    }
    return {.drawing = chained(pen.take()), .notes = std::move(curves.notes)};
}

}  // namespace bspline_curve
