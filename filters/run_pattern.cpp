// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_pattern.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/files.h"
#include "bspline_curve/pattern.h"
#include "bspline_curve/progress.h"
#include "filters/summaries.h"
#include "filters/utf8_path.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

/// Share of the work, for progress only, up to the end of preparing the surface.
constexpr double kPatternSurfaceShare = 0.3;

/// What is to be drawn; `log` is told what of a file was left out, and the font of a text.
Drawing drawingOf(const PatternRequest& request, FilterLog& log) {
    if (request.text.empty()) {
        DrawingFile file = readDrawing(utf8Path(request.drawingFile), patternLayers(request));
        log.warnings = std::move(file.notes);
        return std::move(file.drawing);
    }
    const std::filesystem::path font = fontOrDefault(utf8Path(request.fontFile));
    log.table.push_back("font=" + utf8Text(font));
    log.tableInWords.push_back("The text is set in the font " + utf8Text(font) + ".");
    return textOutlines(request.text, font);
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

/// What is drawn, and what to say of curves that are not followed.
struct DrawnPattern {
    Pattern pattern;
    std::vector<std::string> warnings;
};

DrawnPattern drawnOn(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const PatternRequest& request,
    const Progress& progress
) {
    if (request.place == PatternPlace::Point) {
        return {
            .pattern = patternRoundPoint(
                workpiece,
                drawing,
                patternCentre(request, toolPoints),
                patternUp(request),
                request.row.scale,
                request.pattern,
                progress
            ),
            .warnings = {}
        };
    }
    const PlacedCurves placed = placedCurves(surfaceOf(workpiece), input, request.use.placing);
    DrawnPattern result;
    for (const PlacedCurve& curve : placed.curves) {
        take(
            result.pattern,
            patternAlongCurve(
                workpiece, drawing, curve.line, request.row, request.pattern, progress
            )
        );
    }
    result.warnings = placingWarnings(placed, input.surface);
    return result;
}

}  // namespace

PatternResult runPatternFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const PatternRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress
) {
    Stopwatch watch;
    report(progress, 0.0, "drawing");
    PatternResult result;
    const Drawing drawing = drawingOf(request, result.log);
    const WorkpieceCache::Found found = workpieces.ready(
        input.surface, {.mending = request.use.mending}, partOf(progress, 0.0, kPatternSurfaceShare)
    );
    std::ranges::move(layerNotes(*found.workpiece), std::back_inserter(result.log.warnings));
    auto [pattern, warnings] = drawnOn(
        *found.workpiece,
        drawing,
        input,
        toolPoints,
        request,
        partOf(progress, kPatternSurfaceShare, 1.0)
    );
    std::ranges::move(warnings, std::back_inserter(result.log.warnings));
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
    result.log.summary = patternSummary(result.figures);
    return result;
}

}  // namespace bspline_curve
