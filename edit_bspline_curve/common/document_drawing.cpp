// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/document_drawing.h"

#include "bspline_curve/error.h"
#include "edit_bspline_curve/common/reopen.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <QAction>
#include <QMenu>
#include <QStringList>
#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace bspline_curve {

namespace {

// MeshLab makes the view's context current before it calls a tool.
QGLWidget& currentView() {
    const QGLContext* const context = QGLContext::currentContext();
    auto* const view = context == nullptr ? nullptr : dynamic_cast<QGLWidget*>(context->device());
    if (view == nullptr) {
        throw std::runtime_error("there is no view to draw in");
    }
    return *view;
}

// A filter of ours, which is in a plugin of its own.
QAction& actionOf(const FilterDescription& filter, const QWidget& window) {
    const QString name = QString::fromStdString(filter.name);
    for (const QMenu* const menu : window.findChildren<QMenu*>()) {
        for (QAction* const action : menu->actions()) {
            if (action->text() == name && host::isFilter(*action)) {
                return *action;
            }
        }
    }
    throw std::runtime_error(
        "the filter \"" + filter.name + "\" is not there: install its plugin as well"
    );
}

std::string picksText(const DrawnCurve& curve) {
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

std::set<int> layerIds(const MeshDocument& document) {
    std::set<int> ids;
    for (const MeshModel* const layer : host::layersOf(document)) {
        ids.insert(layer->id());
    }
    return ids;
}

/// Hides the polylines that are not meant, for a filter that uses all that are visible.
class OtherPolylines {
public:
    OtherPolylines(MeshDocument& document, const std::vector<int>& meant) : document_(document) {
        for (const MeshModel* const layer : host::layersOf(document)) {
            const bool isPolyline = layer->cm.FN() == 0 && layer->cm.EN() > 0;
            if (isPolyline && layer->isVisible() &&
                std::ranges::find(meant, layer->id()) == meant.end()) {
                hidden_.push_back(layer->id());
            }
        }
        setVisible(false);
    }

    ~OtherPolylines() { setVisible(true); }

    OtherPolylines(const OtherPolylines&) = delete;
    OtherPolylines& operator=(const OtherPolylines&) = delete;

private:
    void setVisible(bool isVisible) {
        for (const int layer : hidden_) {
            document_.setVisible(layer, isVisible);
        }
    }

    MeshDocument& document_;
    std::vector<int> hidden_;
};

}  // namespace

DocumentDrawing::DocumentDrawing(MeshDocument& document, MLSceneGLSharedDataContext& shared)
    : document_(document), shared_(shared), view_(currentView()) {
    const MeshModel* const surface = defaultSurface(document);
    if (surface == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    begin(*surface);
}

void DocumentDrawing::begin(const MeshModel& surface) {
    surface_ = surface.id();
    LayerArrays arrays = arraysOf(surface);
    const int current = document_.mm()->id();
    std::optional<DrawnCurve> curve = reopened(*document_.mm(), surface, arrays);
    const bool isReopened = curve.has_value();
    tool_ = std::make_unique<CurveTool>(
        view_,
        std::move(arrays.input),
        std::move(curve),
        ToolHost{
            .makeLayers = [this](const std::vector<DrawnCurve>& curves) { makeLayers(curves); },
            .useCurves = [this](const FilterDescription& filter) { useCurves(filter); }
        }
    );
    if (isReopened) {
        reopened_ = current;
        setCurveVisible(document_, reopened_, false);
    }
}

DocumentDrawing::~DocumentDrawing() {
    tool_.reset();
    if (reopened_ >= 0) {
        setCurveVisible(document_, reopened_, true);
    }
}

bool DocumentDrawing::hasSurface() const {
    return host::layerWithId(document_, surface_) != nullptr;
}

void DocumentDrawing::makeLayers(const std::vector<DrawnCurve>& curves) {
    for (const DrawnCurve& curve : curves) {
        makeLayer(curve);
    }
    if (reopened_ >= 0 && !curves.empty()) {
        removeCurve(document_, std::exchange(reopened_, -1));
    }
    document_.setCurrentMesh(surface_);
    document_.setVisible(surface_, true);  // lets the list of layers see it
}

void DocumentDrawing::makeLayer(const DrawnCurve& curve) {
    const FilterDescription& filter = curveFilter();
    QAction& action = actionOf(filter, *view_.window());
    RichParameterList parameters =
        dialogParameters(filter, document_, host::offeredToScripts(filter));
    const auto set = [&](const std::string& id, const ParameterValue& value) {
        setParameter(parameters, filter.parameter(id), value, document_);
    };
    const ParameterValues values = valuesOf(curve.options);
    for (const std::string& id : drawnParameters()) {
        set(id, values.value(id));
    }
    set("surface_layer", LayerId{surface_});
    set("picks", picksText(curve));
    if (parameters.hasParameter("replace")) {  // each curve has a layer of its own
        set("replace", false);
    }
    run(action, parameters);
}

std::vector<int> DocumentDrawing::madeCurves() const {
    std::vector<int> curves;
    for (const int layer : made_) {
        if (host::layerWithId(document_, layer) != nullptr) {
            curves.push_back(layer);
        }
    }
    return curves;
}

void DocumentDrawing::useCurves(const FilterDescription& filter) {
    QAction& action = actionOf(filter, *view_.window());
    const std::vector<int> curves = madeCurves();
    if (curves.empty()) {
        throw std::runtime_error("there is no curve: draw one first");
    }
    RichParameterList parameters =
        dialogParameters(filter, document_, host::offeredToScripts(filter));
    // Its own surface stands for all polylines that are visible.
    const int layer = curves.size() == 1 ? curves.front() : surface_;
    setParameter(parameters, filter.parameter("surface_layer"), LayerId{surface_}, document_);
    setParameter(parameters, filter.parameter("curve_layer"), LayerId{layer}, document_);
    const OtherPolylines hidden(document_, curves);
    run(action, parameters);
    // What it made is the current layer now, the surface is hidden, and the drawing is over.
    QMetaObject::invokeMethod(&view_, "updateLayerTable", Qt::QueuedConnection);
    QMetaObject::invokeMethod(&view_, "endEdit", Qt::QueuedConnection);
}

// As if it were applied in its dialog, so that log and history show it.
void DocumentDrawing::run(QAction& filter, const RichParameterList& parameters) {
    const std::set<int> before = layerIds(document_);
    host::runFilter(filter, document_, parameters);
    FilterNameParameterValuesPair entry;
    entry.first = filter.text();
    entry.second = parameters;
    host::historyOf(document_).append(entry);
    for (const int id : layerIds(document_)) {
        if (before.contains(id)) {
            continue;
        }
        MeshModel* const layer = document_.getMesh(id);
        if (sourceOf(*layer) != nullptr) {
            made_.push_back(id);
        }
        MLRenderingData data;
        MLPoliciesStandAloneFunctions::suggestedDefaultPerViewRenderingData(layer, data);
        shared_.setRenderingDataPerMeshView(id, view_.context(), data);
        shared_.manageBuffers(id);
    }
}

}  // namespace bspline_curve
