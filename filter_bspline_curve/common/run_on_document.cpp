// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/run_on_document.h"

#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/curve_layers.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/kept_font.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/made_layers.h"
#include "filter_bspline_curve/common/picked_points.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filter_bspline_curve/common/restore_curves.h"
#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/show_curve.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/curve_notes.h"
#include "filters/labels.h"
#include "filters/run_curve_uses.h"
#include "filters/run_pattern.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// What a filter runs with.
struct Run {
    MeshDocument& document;
    ParameterValues values;
    DesignerCache& designers;
    const Progress& progress;
};

/// What a filter answered, in words and for scripts.
struct Answered {
    Figures figures;
    FilterLog log;
};

using Runner = Answered (*)(const Run& run);

Answered drawCurve(const Run& run) {
    const CurveRequest request = curveRequest(run.values);
    const MeshModel& surface = surfaceOf(run.document, request);
    const LayerArrays arrays = arraysOf(surface);
    const CurveResult result = runCurveFilter(
        arrays.input,
        pickCandidates(run.document, surface, request),
        request,
        run.designers,
        run.progress
    );
    showCurve(run.document, surface, arrays, request, result);
    return {.figures = result.figures, .log = result.log};
}

Answered computeField(const Run& run) {
    MeshModel* const layer = run.document.mm();
    if (layer == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    const FieldRequest request = fieldRequest(run.values);
    const LayerArrays arrays = arraysOf(*layer);
    const FieldResult result = runFieldFilter(arrays.input, request, run.progress);
    setQuality(*layer, arrays, result);
    return {.figures = result.figures, .log = result.log};
}

/// The layer of a use of curves, and what it is in arrays.
struct Used {
    MeshModel& surface;
    LayerArrays arrays;
    CurvesOnLayer input;
};

Used usedLayers(const Run& run, const CurveUse& use) {
    const MeshModel& surface = layerNamed(run.document, use.surface, "surface_layer");
    LayerArrays arrays = arraysOf(surface);
    CurvesOnLayer input = curvesOnLayer(run.document, surface, arrays, use);
    return {
        .surface = *run.document.getMesh(surface.id()),
        .arrays = std::move(arrays),
        .input = std::move(input)
    };
}

Answered shown(const Run& run, const Used& used, const MeshesResult& result) {
    const std::vector<std::string> names =
        addMadeLayers(run.document, {used.surface, used.arrays}, result);
    Answered answer{.figures = result.figures, .log = result.log};
    if (names.size() > 1) {
        std::vector<std::string>& words = answer.log.tableInWords;
        words.insert(words.begin(), describeLayers(names));
    }
    return answer;
}

/// In a window the current layer stays: lines that were made are not what the next filter is for.
template <class AddLayers>
void addLines(MeshDocument& document, const AddLayers& addLayers) {
    const MeshModel* const current = document.mm();
    addLayers();
    if (hasWindow() && current != nullptr) {
        document.setCurrentMesh(current->id());
    }
}

Answered imprintCurves(const Run& run) {
    const ImprintRequest request = imprintRequest(run.values);
    const Used used = usedLayers(run, request.use);
    return shown(run, used, runImprintFilter(used.input, request, run.progress));
}

/// Points of MeshLab's own tool, in world coordinates.
std::vector<Vec3> toolPointsOf(const MeshModel& surface) {
    std::vector<Vec3> points;
    for (const Point3m& point : pickedPointsOf(surface.cm)) {
        points.push_back(toVec3(point));
    }
    return points;
}

Answered cutAlong(const Run& run) {
    const CutRequest request = cutRequest(run.values);
    const Used used = usedLayers(run, request.imprint.use);
    return shown(
        run, used, runCutFilter(used.input, toolPointsOf(used.surface), request, run.progress)
    );
}

Answered segmentBy(const Run& run) {
    const SegmentRequest request = segmentRequest(run.values);
    const Used used = usedLayers(run, request.imprint.use);
    return shown(run, used, runSegmentFilter(used.input, request, run.progress));
}

Answered offsetCurves(const Run& run) {
    const OffsetRequest request = offsetRequest(run.values);
    const Used used = usedLayers(run, request.use);
    const OffsetResult result = runOffsetFilter(used.input, request, run.progress);
    addLines(run.document, [&] {
        addOffsetLayers(run.document, used.surface, used.arrays, result);
    });
    return {.figures = result.figures, .log = result.log};
}

Answered drawPattern(const Run& run) {
    const PatternRequest request = patternRequest(run.values);
    const MeshModel& surface = layerNamed(run.document, request.use.surface, "surface_layer");
    const LayerArrays arrays = arraysOf(surface);
    const CurvesOnLayer input =
        request.place == PatternPlace::Curve
            ? curvesOnLayer(run.document, surface, arrays, request.use)
            : CurvesOnLayer{.surface = arrays.input, .checksum = {}, .curves = {}};
    const PatternResult result =
        runPatternFilter(input, toolPointsOf(surface), request, run.designers, run.progress);
    std::vector<const SurfacePolyline*> lines;
    for (const PatternCurve& each : result.curves) {
        lines.push_back(&each.curve.polyline);
    }
    addLines(run.document, [&] {
        const QString name = nameOf(surface) + " pattern";
        markAsResult(addPolylinesLayer(run.document, {surface, arrays}, lines, name));
    });
    if (!request.text.empty()) {
        keepFont(request.fontFile);
    }
    return {.figures = result.figures, .log = result.log};
}

/// A filter, what runs it, and what it makes, for messages.
struct Entry {
    const FilterDescription* filter;
    Runner run;
    const char* product;
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        {.filter = &curveFilter(), .run = drawCurve, .product = "curve"},
        {.filter = &fieldFilter(), .run = computeField, .product = "field"},
        {.filter = &imprintFilter(), .run = imprintCurves, .product = "imprint"},
        {.filter = &cutFilter(), .run = cutAlong, .product = "cut"},
        {.filter = &segmentFilter(), .run = segmentBy, .product = "segmentation"},
        {.filter = &offsetFilter(), .run = offsetCurves, .product = "offset"},
        {.filter = &patternFilter(), .run = drawPattern, .product = "pattern"},
    };
    return all;
}

const Entry& entryOf(const FilterDescription& filter) {
    for (const Entry& entry : entries()) {
        if (entry.filter == &filter) {
            return entry;
        }
    }
    throw std::logic_error("no way to run " + filter.id);
}

/// Curves that were read from files, for filters that use some.
void takeUpCurves(MeshDocument& document, const FilterDescription& filter) {
    const bool usesCurves =
        std::ranges::find(filter.parameters, "curve_layer", &ParameterDescription::id) !=
        filter.parameters.end();
    if (usesCurves) {
        for (const std::string& note : restoreCurves(document).notes) {
            host::log(document, GLLogStream::WARNING, note);
        }
    }
}

}  // namespace

const std::vector<const FilterDescription*>& allFilters() {
    static const std::vector<const FilterDescription*> filters = [] {
        std::vector<const FilterDescription*> all;
        for (const Entry& entry : entries()) {
            all.push_back(entry.filter);
        }
        return all;
    }();
    return filters;
}

bool isField(const FilterDescription& filter) {
    return &filter == &fieldFilter();
}

Menu menuOf(const FilterDescription& filter) {
    if (isField(filter)) {
        return Menu::Quality;
    }
    return filter.categories.front().starts_with("Remeshing") ? Menu::Remeshing : Menu::Creation;
}

int changesOf(const FilterDescription& filter) {
    if (isField(filter)) {
        return MeshModel::MM_VERTQUALITY;
    }
    return &filter == &offsetFilter() ? MeshModel::MM_FACEFLAGSELECT : MeshModel::MM_NONE;
}

FilterAnswer runOnDocument(
    const FilterDescription& filter,
    MeshDocument& document,
    const RichParameterList& parameters,
    DesignerCache& designers,
    const Progress& progress
) {
    takeUpCurves(document, filter);
    const Answered answered = entryOf(filter).run({
        .document = document,
        .values = valuesOf(parameters, filter),
        .designers = designers,
        .progress = progress,
    });
    return {
        .figures = answered.figures,
        .log = hasWindow() ? windowLog(answered.log, filter) : scriptLog(answered.log)
    };
}

std::string failureOf(const FilterDescription& filter, const std::exception& error) {
    const std::string message = describeFailure(entryOf(filter).product, error);
    return hasWindow() ? withLabels(message, filter) : message;
}

}  // namespace bspline_curve
