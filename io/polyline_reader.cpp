// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "imprint/polyline_chains.h"
#include "io/polyline_formats.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

PolylineGraph graphIn(const std::filesystem::path& file, const std::vector<std::string>& layers) {
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".dxf") {
        return polylinesOfDxf(file, readWholeFile(file), layers);
    }
    for (const auto& [known, parse] :
         {std::pair(".ply", &polylinesOfPly),
          std::pair(".obj", &polylinesOfObj),
          std::pair(".vtu", &polylinesOfVtu),
          std::pair(".csv", &polylinesOfCsv)}) {
        if (extension == known) {
            return parse(file, readWholeFile(file));
        }
    }
    refuseFile(
        file,
        "curves are read from .json, as this program writes them, or from .ply, .obj, .dxf, .vtu "
        "or .csv"
    );
}

}  // namespace

SurfacePoint placeOfNumbers(double face, const Vec3& barycentric) {
    constexpr double kMostFaces = 2147483647.0;
    const bool isIndex = face >= 0.0 && face < kMostFaces && face == std::floor(face);
    return {.face = isIndex ? static_cast<int>(face) : -1, .barycentric = barycentric};
}

PolylineFile readPolylines(
    const std::filesystem::path& file, const std::vector<std::string>& layers
) {
    PolylineGraph graph = graphIn(file, layers);
    if (graph.edges.empty()) {
        refuseFile(file, "has no polyline: no edges between its points");
    }
    PolylineFile result{.lines = {}, .places = {}, .notes = std::move(graph.notes)};
    for (auto& [indices, closed] : chainsOf(static_cast<int>(graph.points.size()), graph.edges)) {
        if (closed) {  // begins where it does in the file
            std::ranges::rotate(indices, std::ranges::min_element(indices));
        }
        SpacePolyline line{.points = {}, .closed = closed};
        std::vector<SurfacePoint> places;
        for (const int index : indices) {
            const Vec3& point = graph.points[index];
            if (!point.allFinite()) {
                refuseFile(file, "vertex " + std::to_string(index) + " is not finite");
            }
            line.points.push_back(point);
            if (!graph.places.empty()) {
                places.push_back(graph.places[index]);
            }
        }
        result.lines.push_back(std::move(line));
        result.places.push_back(std::move(places));
    }
    return result;
}

}  // namespace bspline_curve
