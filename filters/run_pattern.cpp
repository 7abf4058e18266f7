// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_pattern.h"

#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "design/strict_polyline.h"
#include "filters/find_designer.h"
#include "filters/mended_layer.h"
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
    const DesignerCache::Found found = designerFor(
        input.surface,
        {},
        request.use.mending,
        designers,
        partOf(progress, 0.0, kPatternSurfaceShare)
    );
    const CurveDesigner& designer = *found.designer;
    const MeshRepair* const repair = found.mending ? &found.mending->repair : nullptr;
    const Progress drawing = partOf(progress, kPatternSurfaceShare, 1.0);
    PatternResult result;
    result.log.warnings = file.notes;
    if (found.mending) {
        result.log.warnings.push_back(describeMending(*found.mending));
    }
    Pattern pattern;
    if (request.place == PatternPlace::Point) {
        pattern = patternRoundPoint(
            designer,
            file.drawing,
            patternCentre(request, toolPoints),
            patternUp(request),
            request.row.scale,
            request.pattern,
            drawing
        );
    } else {
        const PlacedCurves placed =
            placedCurves(surfaceOf(designer), repair, input, request.use.placing);
        for (const PlacedCurve& curve : placed.curves) {
            take(
                pattern,
                patternAlongCurve(
                    designer, file.drawing, curve.line, request.row, request.pattern, drawing
                )
            );
        }
        for (const std::string& warning : leftOutWarnings(placed, input.surface)) {
            result.log.warnings.push_back(warning);
        }
    }
    double length = 0.0;
    for (PatternCurve& curve : pattern.curves) {
        length += lengthOf(curve.curve.polyline);
        if (repair != nullptr) {
            bringBack(curve.curve, *repair);
        }
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
