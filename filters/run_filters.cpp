// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_filters.h"

#include "bspline_curve/error.h"
#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "filters/choose_picks.h"
#include "filters/curve_extras.h"
#include "filters/curve_figures.h"
#include "filters/curve_guides.h"
#include "filters/curve_notes.h"
#include "filters/find_designer.h"
#include "filters/labels.h"
#include "filters/layer_ids.h"
#include "filters/mended_layer.h"
#include "filters/summaries.h"
#include "io/curve_writer.h"
#include "io/report_writer.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <new>
#include <numeric>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

// Shares of the work, for progress only.
constexpr double kCurveSurfaceShare = 0.5;
constexpr double kCurveFieldShare = 0.6;

std::vector<std::string> warningsOf(const Curve& curve, const DesignerCache::Found& found) {
    std::vector<std::string> warnings;
    if (!found.isKept) {
        warnings = found.designer->shell().notes;
    }
    if (found.mending) {
        warnings.push_back(describeMending(*found.mending));
    }
    if (!curve.report.repeatedPicks.empty()) {
        warnings.push_back(asSentence(describeRepeatedPicks(curve.report)));
    }
    if (curve.report.fieldShare < 1.0) {
        warnings.push_back(asSentence(describeWeakenedField(curve.report)));
    }
    if (!curve.report.fieldAtRest) {
        warnings.emplace_back(
            "The field could still be lowered where the iterations ended: it pulls the curve into "
            "bends that are sharper than its knots. Smooth the field, or lower its weight."
        );
    }
    if (!curve.report.usable) {
        warnings.push_back(asSentence(describeUnusable(curve.report)));
    }
    return warnings;
}

}  // namespace

CurveResult runCurveFilter(
    const LayerInput& layer,
    const PickCandidates& picks,
    const CurveRequest& request,
    DesignerCache& designers,
    const Progress& progress
) {
    Stopwatch watch;
    checkSaveFile(request);
    const PicksFile chosen = choosePicks(request, picks);
    SolverOptions options = request.solver;
    options.closed = options.closed || chosen.closed.value_or(false);
    const DesignerCache::Found found = designerFor(
        layer, request.shell, request.mending, designers, partOf(progress, 0.0, kCurveSurfaceShare)
    );
    const CurveDesigner& designer = *found.designer;
    const MeshRepair* const repair = found.repair();
    const std::optional<LayerInput> carried =
        repair == nullptr ? std::nullopt : std::optional(carriedOver(layer, *repair));
    const LayerInput& inputs = carried ? *carried : layer;
    checkTube(request, surfaceOf(designer));
    const CurveGuides guides = curveGuides(
        inputs, surfaceOf(designer), request, partOf(progress, kCurveSurfaceShare, kCurveFieldShare)
    );
    const std::vector<double>& field = guides.field;
    Curve curve = designer.design(
        chosen.picks,
        options,
        request.sampling,
        {.field = field, .avoid = guides.avoid},
        partOf(progress, kCurveFieldShare, 1.0)
    );
    return curveResult(layer.mesh, std::move(curve), field, watch.lap(), found, request);
}

CurveResult curveResult(
    const TriangleMesh& given,
    Curve curve,
    std::span<const double> field,
    double seconds,
    const DesignerCache::Found& found,
    const CurveRequest& request
) {
    CurveResult result;
    result.followsField = !field.empty();
    result.curve = std::move(curve);
    const std::vector<double> along =
        field.empty() ? std::vector<double>()
                      : fieldAlong(result.curve.polyline, found.designer->mesh().faces, field);
    result.quality = field.empty() ? result.curve.polyline.parameters : along;
    bringBack(result.curve, found.repair());
    result.figures = curveFigures(result.curve, found, seconds);
    result.log = {
        // Names are no figures, since pymeshlab warns of texts.
        .figures =
            std::string("shell=") + shellName(result.curve) + " field=" +
            (result.followsField && request.field ? name(request.field->options.kind) : "none") +
            " " + keyValueText(result.figures),
        .warnings = warningsOf(result.curve, found),
        .summary = curveSummary(
            result.curve,
            request,
            {.followsField = result.followsField, .isSurfaceKept = found.isKept, .seconds = seconds}
        )
    };
    addExtras(request, given, *found.designer, along, result);
    return result;
}

FieldResult runFieldFilter(
    const LayerInput& layer, const FieldRequest& request, const Progress& progress
) {
    FieldResult result;
    const auto [surface, mending] = surfaceOf(layer, request.mending);
    result.values = madeFrom(layer, [&] {
        if (!mending) {
            return fieldOf(layer, *surface, request, progress);
        }
        result.log.warnings.push_back(describeMending(*mending));
        const LayerInput carried = carriedOver(layer, mending->repair);
        return mending->toOrigin(fieldOf(carried, *surface, request, progress));
    });
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
    if (dynamic_cast<const InputError*>(&error) != nullptr) {
        return error.what();
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
