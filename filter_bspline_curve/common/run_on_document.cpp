// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/run_on_document.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "filter_bspline_curve/common/curve_layers.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/face_labels.h"
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
#include "filters/labels.h"
#include "filters/run_curve_uses.h"
#include "filters/run_edit.h"
#include "filters/run_fit.h"
#include "filters/run_pattern.h"
#include "text/sentences.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// What a filter starts with.
struct Run {
    MeshDocument& document;
    ParameterValues values;
    WorkpieceCache& workpieces;
};

/// What a filter answered, in words and for scripts.
struct Answered {
    Figures figures;
    FilterLog log;
};

// The steps of a filter, see startOnDocument().
using Bringing = std::function<Answered()>;
using Computing = std::function<Bringing(const Progress&)>;
using Starter = Computing (*)(const Run& run);

/// A layer as it was when its filter started.
struct TakenLayer {
    MeshDocument& document;
    int id;
    LayerArrays arrays;

    TakenLayer(MeshDocument& from, const MeshModel& layer)
        : document(from), id(layer.id()), arrays(arraysOf(layer)) {}

    /// Throws InputError where it is gone, or has other elements by now.
    [[nodiscard]] MeshModel& layer() const {
        const MeshModel* const found = host::layerWithId(document, id);
        if (found == nullptr || found->cm.VN() != static_cast<int>(arrays.vertexIds.size()) ||
            found->cm.FN() != static_cast<int>(arrays.faceIds.size()) ||
            static_cast<int>(found->cm.vert.size()) <= arrays.vertexIds.back() ||
            static_cast<int>(found->cm.face.size()) <= arrays.faceIds.back()) {
            throw InputError(
                InputErrorCode::BadOption,
                "the layer of the surface was removed or changed before the filter ended"
            );
        }
        return *document.getMesh(id);
    }
};

Computing drawCurve(const Run& run) {
    const CurveRequest request = curveRequest(run.values);
    const MeshModel& surface = surfaceOf(run.document, request);
    const auto taken = std::make_shared<const TakenLayer>(run.document, surface);
    return [taken,
            request,
            candidates = pickCandidates(run.document, surface, request),
            &workpieces = run.workpieces](const Progress& progress) -> Bringing {
        return
            [taken,
             request,
             result =
                 runCurveFilter(taken->arrays.input, candidates, request, workpieces, progress)] {
                showCurve(taken->document, taken->layer(), taken->arrays, request, result);
                return Answered{.figures = result.figures, .log = result.log};
            };
    };
}

Computing computeField(const Run& run) {
    const MeshModel* const layer = run.document.mm();
    if (layer == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    const FieldLayerRequest request = fieldRequest(run.values);
    const auto taken = std::make_shared<const TakenLayer>(run.document, *layer);
    return [taken, request](const Progress& progress) -> Bringing {
        return [taken, result = runFieldFilter(taken->arrays.input, request, progress)] {
            setQuality(taken->layer(), taken->arrays, result);
            return Answered{.figures = result.figures, .log = result.log};
        };
    };
}

/// The surface of a use of curves, and these.
struct TakenCurves : TakenLayer {
    std::vector<PolylineLayer> curves;

    TakenCurves(MeshDocument& from, const CurveUse& use, bool usesCurves = true)
        : TakenLayer(from, layerNamed(from, use.surface, "surface_layer")) {
        if (usesCurves) {
            curves = curvesFor(from, layer(), arrays, use);
        }
    }

    /// What a filter takes; the arrays keep ids alone.
    [[nodiscard]] CurvesOnLayer takeInput() {
        const MeshChecksum checksum = checksumOf(arrays);
        return {
            .surface = std::move(arrays.input), .checksum = checksum, .curves = std::move(curves)
        };
    }
};

constexpr double kMadeShare = 0.7;  // of the work, for progress only

/// What makes meshes of a surface and its curves.
using MeshMaker = std::function<MeshesResult(const CurvesOnLayer&, const Progress&)>;

Computing makeMeshes(
    const Run& run, const CurveUse& use, const MeshMaker& make, bool usesCurves = true
) {
    auto taken = std::make_shared<TakenCurves>(run.document, use, usesCurves);
    LayerData data = dataOf(taken->layer(), taken->arrays);
    return [taken, data = std::move(data), make, coloursParts = hasWindow()](
               const Progress& progress
           ) mutable -> Bringing {
        const CurvesOnLayer input = taken->takeInput();
        MeshesResult result = make(input, partOf(progress, 0.0, kMadeShare));
        std::vector<HostMesh> meshes = hostMeshes(
            result.layers,
            input.surface,
            taken->arrays,
            data,
            coloursParts,
            partOf(progress, kMadeShare, 1.0)
        );
        data = {};  // here, since giving memory back takes time as well
        return [taken,
                meshes = std::move(meshes),
                answer = Answered{std::move(result.figures), std::move(result.log)}]() mutable {
            const std::vector<std::string> names =
                addMadeLayers(taken->document, taken->layer(), meshes);
            if (names.size() > 1) {
                std::vector<std::string>& words = answer.log.tableInWords;
                words.insert(words.begin(), describeLayers(names));
            }
            return answer;
        };
    };
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

Computing imprintCurves(const Run& run) {
    const ImprintRequest request = imprintRequest(run.values);
    return makeMeshes(
        run, request.use, [request](const CurvesOnLayer& input, const Progress& progress) {
            return runImprintFilter(input, request, progress);
        }
    );
}

/// Points of MeshLab's own tool, in world coordinates.
std::vector<Vec3> toolPointsOf(const MeshModel& surface) {
    std::vector<Vec3> points;
    for (const Point3m& point : pickedPointsOf(surface.cm)) {
        points.push_back(toVec3(point));
    }
    return points;
}

Computing cutAlong(const Run& run) {
    const CutRequest request = cutRequest(run.values);
    const CurveUse& use = request.imprint.use;
    return makeMeshes(
        run,
        use,
        [request, points = toolPointsOf(layerNamed(run.document, use.surface, "surface_layer"))](
            const CurvesOnLayer& input, const Progress& progress
        ) { return runCutFilter(input, points, request, progress); }
    );
}

Computing fillHoles(const Run& run) {
    const FillRequest request = fillRequest(run.values);
    return makeMeshes(
        run,
        request.use,
        [request](const CurvesOnLayer& input, const Progress& progress) {
            return runFillFilter(input, request, progress);
        },
        false
    );
}

Computing segmentBy(const Run& run) {
    const SegmentRequest request = segmentRequest(run.values);
    return makeMeshes(
        run, request.imprint.use, [request](const CurvesOnLayer& input, const Progress& progress) {
            return runSegmentFilter(input, request, progress);
        }
    );
}

Computing offsetCurves(const Run& run) {
    const OffsetRequest request = offsetRequest(run.values);
    auto taken = std::make_shared<TakenCurves>(run.document, request.use);
    return [taken, request](const Progress& progress) -> Bringing {
        return [taken, result = runOffsetFilter(taken->takeInput(), request, progress)] {
            addLines(taken->document, [&] {
                addOffsetLayers(taken->document, taken->layer(), taken->arrays, result);
            });
            return Answered{.figures = result.figures, .log = result.log};
        };
    };
}

Computing placePoints(const Run& run) {
    const PointsRequest request = pointsRequest(run.values);
    auto taken = std::make_shared<TakenCurves>(run.document, request.use);
    return [taken, request](const Progress& progress) -> Bringing {
        return [taken, result = runPointsFilter(taken->takeInput(), request, progress)] {
            const MeshModel& surface = taken->layer();
            addLines(taken->document, [&] {
                const QString name = nameOf(surface) + " points";
                addCurvePointsLayer(taken->document, {surface, taken->arrays}, result, name);
            });
            return Answered{.figures = result.figures, .log = result.log};
        };
    };
}

Computing drawPattern(const Run& run) {
    const PatternRequest request = patternRequest(run.values);
    auto taken = std::make_shared<TakenCurves>(
        run.document, request.use, request.place == PatternPlace::Curve
    );
    return [taken, request, points = toolPointsOf(taken->layer()), &workpieces = run.workpieces](
               const Progress& progress
           ) -> Bringing {
        return
            [taken,
             request,
             result = runPatternFilter(taken->takeInput(), points, request, workpieces, progress)] {
                std::vector<const SurfacePolyline*> lines;
                for (const PatternCurve& each : result.curves) {
                    lines.push_back(&each.curve.polyline);
                }
                const MeshModel& surface = taken->layer();
                addLines(taken->document, [&] {
                    const QString name = nameOf(surface) + " pattern";
                    markAsResult(
                        addPolylinesLayer(taken->document, {surface, taken->arrays}, lines, name)
                    );
                });
                if (!request.text.empty()) {
                    keepFont(request.fontFile);
                }
                return Answered{.figures = result.figures, .log = result.log};
            };
    };
}

Computing fitCurves(const Run& run) {
    const FitRequest request = fitRequest(run.values);
    const MeshModel& surface = layerNamed(run.document, request.surface, "surface_layer");
    const auto taken = std::make_shared<const TakenLayer>(run.document, surface);
    return [taken,
            request,
            labels = faceLabels(surface, taken->arrays, request.labels),
            &workpieces = run.workpieces](const Progress& progress) -> Bringing {
        return [taken,
                result = runFitFilter(taken->arrays.input, labels, request, workpieces, progress)] {
            const MeshModel& layer = taken->layer();
            addLines(taken->document, [&] {
                for (const FitResult::FittedCurve& curve : result.curves) {
                    addResultLayers(
                        taken->document, layer, taken->arrays, curve.request, curve.result
                    );
                }
            });
            return Answered{.figures = result.figures, .log = result.log};
        };
    };
}

Computing editCurves(const Run& run) {
    const EditRequest request = editRequest(run.values);
    auto taken = std::make_shared<TakenCurves>(run.document, request.use);
    return [taken, request, &workpieces = run.workpieces](const Progress& progress) -> Bringing {
        return [taken, result = runEditFilter(taken->takeInput(), request, workpieces, progress)] {
            addLines(taken->document, [&] {
                addEditedLayers(taken->document, taken->layer(), taken->arrays, result);
            });
            return Answered{.figures = result.figures, .log = result.log};
        };
    };
}

/// A filter, what starts it, and what it makes, for messages.
struct Entry {
    const FilterDescription* filter;
    Starter start;
    const char* product;
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        {.filter = &curveFilter(), .start = drawCurve, .product = "curve"},
        {.filter = &fieldFilter(), .start = computeField, .product = "field"},
        {.filter = &imprintFilter(), .start = imprintCurves, .product = "imprint"},
        {.filter = &cutFilter(), .start = cutAlong, .product = "cut"},
        {.filter = &segmentFilter(), .start = segmentBy, .product = "segmentation"},
        {.filter = &offsetFilter(), .start = offsetCurves, .product = "offset"},
        {.filter = &patternFilter(), .start = drawPattern, .product = "pattern"},
        {.filter = &fitFilter(), .start = fitCurves, .product = "fit"},
        {.filter = &editFilter(), .start = editCurves, .product = "edit"},
        {.filter = &pointsFilter(), .start = placePoints, .product = "row of points"},
        {.filter = &fillFilter(), .start = fillHoles, .product = "fill"},
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

FilterComputing startOnDocument(
    const FilterDescription& filter,
    MeshDocument& document,
    const RichParameterList& parameters,
    WorkpieceCache& workpieces
) {
    takeUpCurves(document, filter);
    return [&filter,
            compute = entryOf(filter).start(
                {.document = document,
                 .values = valuesOf(parameters, filter),
                 .workpieces = workpieces}
            )](const Progress& progress) -> FilterBringing {
        return [&filter, bring = compute(progress)] {
            const Answered answered = bring();
            return FilterAnswer{
                .figures = answered.figures,
                .log = hasWindow() ? windowLog(answered.log, filter) : scriptLog(answered.log)
            };
        };
    };
}

FilterAnswer runOnDocument(
    const FilterDescription& filter,
    MeshDocument& document,
    const RichParameterList& parameters,
    WorkpieceCache& workpieces,
    const Progress& progress
) {
    return startOnDocument(filter, document, parameters, workpieces)(progress)();
}

std::string failureOf(const FilterDescription& filter, const std::exception& error) {
    const std::string message = describeFailure(entryOf(filter).product, error);
    return hasWindow() ? withLabels(message, filter) : message;
}

}  // namespace bspline_curve
