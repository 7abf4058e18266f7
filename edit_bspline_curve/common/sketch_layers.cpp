// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/sketch_layers.h"

#include "edit_bspline_curve/common/reopen.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <QStringList>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// Of the surface's layer: curves that were not made layers.
const std::string kUnfinished = "bspline_curve_unfinished";

std::string picksText(const SketchCurve& curve) {
    QStringList picks;
    for (const SketchPick& pick : curve.picks) {
        QStringList numbers;
        for (const double x : pick.position) {
            numbers << QString::number(x, 'g', std::numeric_limits<double>::max_digits10);
        }
        picks << numbers.join(' ');
    }
    return picks.join("; ").toStdString();
}

void setColour(MeshModel& layer, const SketchColour& colour) {
    layer.updateDataMask(MeshModel::MM_VERTCOLOR);
    for (CVertexO& vertex : layer.cm.vert) {
        vertex.C() = vcg::Color4b(colour.red, colour.green, colour.blue, 255);
    }
}

}  // namespace

SketchLayers::SketchLayers(
    MeshDocument& document,
    MLSceneGLSharedDataContext& shared,
    QGLWidget& view,
    const MeshModel& surface,
    const LayerArrays& arrays
)
    : document_(document),
      shared_(shared),
      view_(view),
      surface_(surface.id()),
      ids_{.input = {}, .vertexIds = arrays.vertexIds, .faceIds = arrays.faceIds, .own = {}},
      matrix_(surface.cm.Tr) {}

// ---- What the document has ----

std::vector<TakenUp> SketchLayers::takeUp(const LayerArrays& arrays, int& other) {
    std::vector<TakenUp> taken;
    other = 0;
    const MeshModel& surface = *document_.getMesh(surface_);
    for (const MeshModel* const layer : host::layersOf(document_)) {
        if (std::optional<DrawnCurve> curve = reopened(*layer, surface, arrays)) {
            taken.push_back({*std::move(curve), layer->id(), !layer->isVisible()});
        } else if (const CurveSource* const source = sourceOf(*layer)) {
            other += source->surface == surface_ ? 1 : 0;
        }
    }
    const auto* const unfinished =
        host::perMeshAttribute<std::vector<DrawnCurve>>(surface.cm, kUnfinished);
    if (unfinished != nullptr) {
        for (const DrawnCurve& curve : *unfinished) {
            taken.push_back({curve});
        }
    }
    return taken;
}

void SketchLayers::begin(
    const std::vector<TakenUp>& taken, const Sketch& sketch, const MeshChecksum& surface
) {
    ids_.checksum = surface;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        if (taken[i].layer >= 0) {
            const std::shared_ptr<SketchCurve>& curve = sketch.curves[i];
            made_[curve->id] = {taken[i].layer, curve, !taken[i].isHidden};
        }
    }
}

bool SketchLayers::hasSurface() const {
    return host::layerWithId(document_, surface_) != nullptr;
}

bool SketchLayers::isSurfaceSame() const {
    const MeshModel* const surface = host::layerWithId(document_, surface_);
    return surface != nullptr && surface->cm.Tr == matrix_ && checksumOf(*surface) == ids_.checksum;
}

// ---- Layers and curves ----

void SketchLayers::show(const Sketch& sketch, bool isOver) {
    for (auto& [id, made] : made_) {
        const auto found = std::ranges::find(sketch.curves, id, &SketchCurve::id);
        const bool isThere = found != sketch.curves.end();
        setVisible(
            made,
            isThere && !(*found)->look.isHidden &&
                (isOver || *found == made.curve || (*found)->asksForTheSame(*made.curve))
        );
    }
}

void SketchLayers::setVisible(Made& made, bool isVisible) {
    if (std::exchange(made.isVisible, isVisible) != isVisible) {
        setCurveVisible(document_, made.layer, isVisible);
    }
}

bool SketchLayers::isLayer(const SketchCurve& curve) const {
    const auto found = made_.find(curve.id);
    return found != made_.end() && host::layerWithId(document_, found->second.layer) != nullptr &&
           curve.asksForTheSame(*found->second.curve) &&
           curve.look.colour == found->second.curve->look.colour;
}

bool SketchLayers::isSaved(const SketchCurve& curve) const {
    return isLayer(curve) &&
           !host::layerWithId(document_, made_.at(curve.id).layer)->fullName().isEmpty();
}

std::vector<int> SketchLayers::shownLayers() const {
    std::vector<int> layers;
    for (const auto& [id, made] : made_) {
        if (made.isVisible && host::layerWithId(document_, made.layer) != nullptr) {
            layers.push_back(made.layer);
        }
    }
    return layers;
}

int SketchLayers::bring(const Sketch& sketch, const CurveMaker& maker) {
    int count = 0;
    std::optional<bool> isSame;  // takes time in proportion to the surface
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        if (!isLayer(*curve)) {
            if (curve->settled) {
                if (!isSame) {
                    isSame = isSurfaceSame();
                }
                take(curve, *isSame ? makeOnSurface(*curve, maker) : makeAlone(*curve));
                ++count;
            }
            continue;
        }
        Made& made = made_.at(curve->id);
        if (curve->look.name != made.curve->look.name && !curve->look.name.empty()) {
            document_.getMesh(made.layer)->setLabel(QString::fromStdString(curve->look.name));
        }
        made.curve = curve;
    }
    const bool isLess = removeLost(sketch);
    show(sketch);
    if (hasSurface() && (count > 0 || isLess)) {
        document_.setCurrentMesh(surface_);
        QMetaObject::invokeMethod(&view_, "updateLayerTable", Qt::QueuedConnection);
    }
    return count;
}

// Of curves that were removed.
bool SketchLayers::removeLost(const Sketch& sketch) {
    return std::erase_if(made_, [&](const auto& entry) {
               const bool isLost =
                   std::ranges::find(sketch.curves, entry.first, &SketchCurve::id) ==
                   sketch.curves.end();
               if (isLost) {
                   removeCurve(document_, entry.second.layer);
               }
               return isLost;
           }) > 0;
}

// A new layer for a curve.
void SketchLayers::take(const std::shared_ptr<const SketchCurve>& curve, int layer) {
    const auto before = made_.find(curve->id);
    if (before != made_.end()) {
        removeCurve(document_, before->second.layer);
    }
    made_[curve->id] = {layer, curve, true};
    if (!curve->look.name.empty()) {
        document_.getMesh(layer)->setLabel(QString::fromStdString(curve->look.name));
    }
    for (const int each : layersOfCurve(document_, layer)) {
        MeshModel& made = *document_.getMesh(each);
        setColour(made, curve->look.colour);
        made.setMeshModified();
        showNew(each);
    }
}

RichParameterList SketchLayers::parametersOf(
    const SketchCurve& curve, const DrawnOptions& options
) const {
    const FilterDescription& filter = curveFilter();
    RichParameterList parameters =
        dialogParameters(filter, document_, host::offeredToScripts(filter));
    const auto set = [&](const std::string& id, const ParameterValue& value) {
        setParameter(parameters, filter.parameter(id), value, document_);
    };
    const ParameterValues values = valuesOf(options);
    for (const std::string& id : drawnParameters()) {
        set(id, values.value(id));
    }
    set("surface_layer", LayerId{surface_});
    set("picks", picksText(curve));
    set("corners", describe(PickChoice{.ids = curve.corners()}));
    PickDirections tangents;
    for (std::size_t i = 0; i < curve.picks.size(); ++i) {
        if (!curve.picks[i].tangent.isAny()) {
            tangents.entries.emplace_back(static_cast<int>(i), curve.picks[i].tangent);
        }
    }
    set("tangents", describe(tangents));
    if (parameters.hasParameter("replace")) {  // each curve has a layer of its own
        set("replace", false);
    }
    return parameters;
}

// As if the filter were applied in its dialog, so that log and history show it; but the tool has
// the curve already.
int SketchLayers::makeOnSurface(const SketchCurve& curve, const CurveMaker& maker) {
    const FilterDescription& filter = curveFilter();
    const RichParameterList parameters = parametersOf(curve, maker.drawn(curve).options);
    CurveRequest request = curveRequest(valuesOf(parameters, filter));
    request.solver = curve.options.solver;  // lists of parameters round some numbers
    const CurveResult result = maker.result(curve, request);
    addResultLayers(document_, *document_.getMesh(surface_), ids_, request, result);
    tellOfFilter(filter, parameters, windowLog(result.log, filter));
    return document_.mm()->id();
}

void SketchLayers::tellOfFilter(
    const FilterDescription& filter, const RichParameterList& parameters, const LogLines& said
) {
    FilterNameParameterValuesPair entry;
    entry.first = QString::fromStdString(filter.name);
    entry.second = parameters;
    host::historyOf(document_).append(entry);
    for (const std::string& line : said.lines) {
        host::log(document_, GLLogStream::FILTER, line);
    }
    for (const std::string& warning : said.warnings) {
        host::log(document_, GLLogStream::WARNING, warning);
    }
}

// The surface is gone or was changed: what is seen is kept as a polyline.
int SketchLayers::makeAlone(const SketchCurve& curve) {
    const SurfacePolyline& line = curve.settled->polyline;
    MeshModel& layer = *document_.addNewMesh("", "curve", true);
    Allocator::AddVertices(layer.cm, line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        layer.cm.vert[i].P() = toPoint3m(line.points[i]);
    }
    addEdges(layer.cm, line.closed);
    vcg::tri::UpdateBounding<CMeshO>::Box(layer.cm);
    host::log(
        document_,
        GLLogStream::WARNING,
        "The surface of a curve is gone or was changed while it was drawn: the curve is kept as a "
        "polyline, where it was."
    );
    return layer.id();
}

void SketchLayers::showNew(int layer) {
    MLRenderingData data;
    MLPoliciesStandAloneFunctions::suggestedDefaultPerViewRenderingData(
        document_.getMesh(layer), data
    );
    shared_.setRenderingDataPerMeshView(layer, view_.context(), data);
    shared_.manageBuffers(layer);
}

// ---- What is no layer yet ----

int SketchLayers::keepUnfinished(const Sketch& sketch, const CurveMaker& maker) {
    if (!hasSurface()) {
        return 0;
    }
    std::vector<DrawnCurve> left;
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        if (!isLayer(*curve) && !curve->picks.empty()) {
            left.push_back(maker.drawn(*curve));
        }
    }
    CMeshO& mesh = document_.getMesh(surface_)->cm;
    if (host::perMeshAttribute<std::vector<DrawnCurve>>(mesh, kUnfinished) != nullptr) {
        Allocator::DeletePerMeshAttribute(mesh, kUnfinished);
    }
    const auto count = static_cast<int>(left.size());
    if (count > 0) {
        Allocator::AddPerMeshAttribute<std::vector<DrawnCurve>>(mesh, kUnfinished)() =
            std::move(left);
    }
    return count;
}

}  // namespace bspline_curve
