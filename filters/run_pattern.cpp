// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_pattern.h"

#include "design/designer_surface.h"
#include "design/strict_polyline.h"
#include "filters/layer_ids.h"
#include "filters/utf8_path.h"
#include "io/drawing_reader.h"
#include "io/text_outlines.h"
#include "pattern/draw_pattern.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <iterator>
#include <memory>
#include <utility>

namespace bspline_curve {

namespace {

/// Share of the work, for progress only, up to the end of preparing the surface.
constexpr double kPatternSurfaceShare = 0.3;

DrawingFile drawingOf(const PatternRequest& request) {
    if (request.text.empty()) {
        return readDrawing(utf8Path(request.drawingFile));
    }
    return {.drawing = textOutlines(request.text, utf8Path(request.fontFile)), .notes = {}};
}

std::shared_ptr<const CurveDesigner> designerOfSurface(
    const LayerInput& layer, DesignerCache& designers, const Progress& progress
) {
    return madeFrom(layer, [&] {
        const auto make = [&] {
            // Faces must stay those of the layer.
            return makeMended(layer.mesh, {.strict = true}, [&](TriangleMesh mesh) {
                return CurveDesigner(std::move(mesh), {}, progress);
            });
        };
        const DesignerCache::Found found = designers.findOrMake(layer.mesh, {}, make);
        if (found.mending && found.mending->refusal) {
            throw InputError(*found.mending->refusal);
        }
        return found.designer;
    });
}

/// Adds what was drawn along another curve.
void take(Pattern& all, Pattern&& more) {
    if (all.curves.empty()) {
        all = std::move(more);
        return;
    }
    std::ranges::move(more.curves, std::back_inserter(all.curves));
    all.largestDeviation = std::max(all.largestDeviation, more.largestDeviation);
    if (more.shortest.ratio < all.shortest.ratio) {
        all.shortest = more.shortest;
    }
    if (more.longest.ratio > all.longest.ratio) {
        all.longest = more.longest;
    }
}

}  // namespace

PatternResult runPatternFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const PatternRequest& request,
    DesignerCache& designers,
    const Progress& progress
) {
    Stopwatch watch;
    report(progress, 0.0, "drawing");
    const DrawingFile file = drawingOf(request);
    const std::shared_ptr<const CurveDesigner> designer =
        designerOfSurface(input.surface, designers, partOf(progress, 0.0, kPatternSurfaceShare));
    const Progress drawing = partOf(progress, kPatternSurfaceShare, 1.0);
    PatternResult result;
    result.log.warnings = file.notes;
    Pattern pattern;
    if (request.place == PatternPlace::Point) {
        pattern = patternRoundPoint(
            *designer,
            file.drawing,
            patternCentre(request, toolPoints),
            patternUp(request),
            request.row.scale,
            request.pattern,
            drawing
        );
    } else {
        const PlacedCurves placed = placedCurves(surfaceOf(*designer), input, request.use.placing);
        for (const PlacedCurve& curve : placed.curves) {
            take(
                pattern,
                patternAlongCurve(
                    *designer, file.drawing, curve.line, request.row, request.pattern, drawing
                )
            );
        }
        for (const std::string& warning : leftOutWarnings(placed, input.surface)) {
            result.log.warnings.push_back(warning);
        }
    }
    double length = 0.0;
    for (const PatternCurve& curve : pattern.curves) {
        length += lengthOf(curve.curve.polyline);
    }
    result.curves = std::move(pattern.curves);
    result.figures = {
        {"curves", static_cast<int>(result.curves.size())},
        {"length", length},
        {"tolerance", pattern.tolerance},
        {"largest_deviation", pattern.largestDeviation},
        {"shortest_ratio", pattern.shortest.ratio},
        {"longest_ratio", pattern.longest.ratio},
        {"seconds", watch.lap()},
    };
    result.log.figures = keyValueText(result.figures);
    return result;
}

}  // namespace bspline_curve
