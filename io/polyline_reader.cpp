// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polyline_reader.h"

#include "imprint/polyline_chains.h"
#include "io/polyline_formats.h"
#include "io/text_parsing.h"

#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

PolylineGraph graphIn(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    for (const auto& [known, parse] :
         {std::pair(".ply", &polylinesOfPly),
          std::pair(".obj", &polylinesOfObj),
          std::pair(".dxf", &polylinesOfDxf)}) {
        if (extension == known) {
            return parse(file, readWholeFile(file));
        }
    }
    refuseFile(
        file,
        "curves are read from .json, as this program writes them, or as polylines from .ply, .obj "
        "or .dxf"
    );
}

}  // namespace

std::vector<SpacePolyline> readPolylines(const std::filesystem::path& file) {
    const PolylineGraph graph = graphIn(file);
    if (graph.edges.empty()) {
        refuseFile(file, "has no polyline: no edges between its points");
    }
    std::vector<SpacePolyline> lines;
    for (const auto& [indices, closed] :
         chainsOf(static_cast<int>(graph.points.size()), graph.edges)) {
        SpacePolyline line{.points = {}, .closed = closed};
        for (const int index : indices) {
            const Vec3& point = graph.points[index];
            if (!point.allFinite()) {
                refuseFile(file, "vertex " + std::to_string(index) + " is not finite");
            }
            line.points.push_back(point);
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace bspline_curve
