// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_filters.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "filters/choose_picks.h"
#include "filters/curve_extras.h"
#include "filters/curve_figures.h"
#include "filters/labels.h"
#include "filters/summaries.h"
#include "text/error_messages.h"
#include "text/sentences.h"
#include "utility/stopwatch.h"
#include "workpiece/layer_ids.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <numeric>
#include <utility>

namespace bspline_curve {

namespace {

// Shares of the work, for progress only.
constexpr double kCurveSurfaceShare = 0.5;

std::vector<std::string> warningsOf(
    const DesignedCurve& drawn, const WorkpieceCache::Found& found
) {
    std::vector<std::string> warnings;
    if (!found.isKept) {
        warnings = found->shell().notes;
    }
    std::ranges::move(layerNotes(*found.workpiece), std::back_inserter(warnings));
    addSentences(warnings, drawn.notes);
    return warnings;
}

}  // namespace

std::vector<std::string> layerNotes(const Workpiece& workpiece) {
    std::vector<std::string> notes;
    for (const std::string& note : workpiece.notes()) {
        notes.push_back(
            asSentence(note) + " This is done on a copy in memory; the layer is unchanged."
        );
    }
    return notes;
}

CurveResult runCurveFilter(
    const LayerInput& layer,
    const PickCandidates& picks,
    const CurveRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress
) {
    Stopwatch watch;
    checkSaveFile(request);
    const PicksFile chosen = choosePicks(request, picks);
    CurveOptions options = static_cast<const CurveOptions&>(request);
    options.solver.closed = options.solver.closed || chosen.closed.value_or(false);
    if (options.corners == PickChoice()) {
        options.corners.ids = chosen.corners;
    }
    if (options.tangents.entries.empty()) {
        options.tangents = chosen.tangents;
    }
    if (options.pickTolerances.entries.empty() && options.solver.pickTolerance == MeshLength()) {
        options.pickTolerances = chosen.tolerances;
    }
    const WorkpieceCache::Found found =
        workpieces.ready(layer, request, partOf(progress, 0.0, kCurveSurfaceShare));
    checkTube(request, *found.workpiece);
    DesignedCurve drawn =
        found->draw(chosen.picks, options, layer, partOf(progress, kCurveSurfaceShare, 1.0));
    drawn.seconds = watch.lap();
    return curveResult(std::move(drawn), found, request);
}

CurveResult curveResult(
    DesignedCurve drawn, const WorkpieceCache::Found& found, const CurveRequest& request
) {
    CurveResult result;
    result.followsField = !drawn.field.empty();
    result.quality = result.followsField ? drawn.along : drawn.curve.polyline.parameters;
    result.log.warnings = warningsOf(drawn, found);
    result.curve = std::move(drawn.curve);
    result.figures = curveFigures(result.curve, found, drawn.seconds);
    // Names are no figures, since pymeshlab warns of texts.
    result.log.figures =
        std::string("shell=") + shellName(result.curve) + " field=" +
        (result.followsField && request.field ? name(request.field->options.kind) : "none") + " " +
        keyValueText(result.figures);
    result.log.summary = curveSummary(
        result.curve,
        request,
        {.followsField = result.followsField,
         .isSurfaceKept = found.isKept,
         .seconds = drawn.seconds}
    );
    addExtras(request, *found.workpiece, drawn.along, result);
    return result;
}

FieldResult runFieldFilter(
    const LayerInput& layer, const FieldLayerRequest& request, const Progress& progress
) {
    FieldResult result;
    const auto workpiece = workpieceOf(layer, {.mending = request.mending});
    result.log.warnings = layerNotes(*workpiece);
    result.values = workpiece->field(layer, request, progress).values();
    const auto [minimum, maximum] = std::ranges::minmax(result.values);
    const double sum = std::accumulate(result.values.begin(), result.values.end(), 0.0);
    result.figures = {
        {"minimum", minimum},
        {"mean", sum / static_cast<double>(result.values.size())},
        {"maximum", maximum},
    };
    result.log.figures = keyValueText(result.figures);
    result.log.summary = fieldSummary(request.options.kind, result.values.size(), result.figures);
    return result;
}

LogLines scriptLog(const FilterLog& log) {
    LogLines written{.lines = {log.figures}, .warnings = log.warnings};
    written.lines.insert(written.lines.end(), log.table.begin(), log.table.end());
    return written;
}

LogLines windowLog(const FilterLog& log, const FilterDescription& filter) {
    LogLines shown{.lines = {log.summary}, .warnings = {}};
    shown.lines.insert(shown.lines.end(), log.tableInWords.begin(), log.tableInWords.end());
    for (const std::string& warning : log.warnings) {
        shown.warnings.push_back(withLabels(warning, filter));
    }
    return shown;
}

std::string describeFailure(const char* what, const std::exception& error) {
    const std::string subject = std::string("The ") + what;
    if (const auto* const refused = dynamic_cast<const InputError*>(&error)) {
        constexpr RemedyWords kWords{
            .mend = "without the option strict the mesh is mended",
            .weld = "the option weld (%) joins these components"
        };
        return withRemedy(error.what(), refused->remedy(), kWords);
    }
    if (dynamic_cast<const Cancelled*>(&error) != nullptr) {
        return subject + " was cancelled.";
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        return std::string("There is not enough memory for a ") + what + " on this mesh.";
    }
    return subject + " could not be made: " + error.what();
}

}  // namespace bspline_curve
