// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_fit.h"

#include "bspline_curve/error.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/progress.h"
#include "filters/summaries.h"
#include "surface/strict_line.h"
#include "text/sentences.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kReadyToFitShare = 0.4;  // of the work, for progress only

}  // namespace

FitResult runFitFilter(
    const LayerInput& layer,
    std::span<const int> labels,
    const FitRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress
) {
    Stopwatch watch;
    const bool ofSelection = request.labels == FaceLabels::Selection;
    if (ofSelection && std::ranges::find_if(labels, [](int l) { return l != 0; }) == labels.end()) {
        throw InputError(
            InputErrorCode::BadOption,
            "no face is selected: select some, or choose other boundaries by the option boundaries"
        );
    }
    const WorkpieceCache::Found found =
        workpieces.ready(layer, request.curve, partOf(progress, 0.0, kReadyToFitShare));
    const std::vector<LineToFit> lines = linesBetween(layer.mesh, labels);
    FittedLines fitted = fitLines(
        *found.workpiece, lines, request.fit, request.curve, partOf(progress, kReadyToFitShare, 1.0)
    );

    FitResult result;
    double length = 0.0;
    double farthest = 0.0;
    int closed = 0;
    int corners = 0;
    for (DesignedCurve& drawn : fitted.curves) {
        drawn.notes.clear();  // they are among those of all, with the names of their lines
        const bool isKept = found.isKept || !result.curves.empty();
        CurveRequest own = request.curve;
        own.solver.closed = drawn.curve.polyline.closed;
        length += lengthOf(drawn.curve.polyline);
        farthest = std::max(farthest, drawn.curve.report.lineDistance.value_or(0.0));
        closed += own.solver.closed ? 1 : 0;
        corners += static_cast<int>(drawn.curve.report.cornerTurns.size());
        CurveResult made = curveResult(std::move(drawn), {found.workpiece, isKept}, own);
        result.curves.push_back({std::move(own), std::move(made)});
    }
    result.figures = {
        {"curves", static_cast<int>(result.curves.size())},
        {"closed_curves", closed},
        {"corners", corners},
        {"length", length},
        {"largest_deviation", farthest},
        {"left_out", static_cast<int>(lines.size() - result.curves.size())},
        {"seconds", watch.lap()},
    };
    result.log.figures = keyValueText(result.figures);
    result.log.summary = fitSummary(result.figures);
    result.log.warnings = layerNotes(*found.workpiece);
    addSentences(result.log.warnings, fitted.notes);
    return result;
}

}  // namespace bspline_curve
