// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/document_drawing.h"

#include "bspline_curve/error.h"
#include "edit_bspline_curve/common/curve_words.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/restore_curves.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <QAction>
#include <QMenu>
#include <algorithm>
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
    : document_(document), view_(currentView()) {
    const RestoredCurves restored = restoreCurves(document);
    const MeshModel* const surface = defaultSurface(document);
    if (surface == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    surface_ = surface->id();
    LayerArrays arrays = arraysOf(*surface);
    layers_ = std::make_unique<SketchLayers>(document, shared, view_, *surface, arrays);
    for (const int layer : restored.layers) {
        layers_->showNew(layer);
    }
    ToolStart start;
    for (const std::string& note : restored.notes) {
        host::log(document, GLLogStream::WARNING, note);
        start.note += QString::fromStdString(note) + "\n";
    }
    int other = 0;
    start.curves = layers_->takeUp(arrays, other);
    if (other > 0) {
        start.note += QObject::tr(
                          "%1 of this surface %2 drawn with options that the tool does not "
                          "offer: they stay as they are."
        )
                          .arg(countText(other, "curve"), other == 1 ? "was" : "were");
    }
    for (std::size_t i = 0; i < start.curves.size(); ++i) {
        if (start.curves[i].layer == document.mm()->id()) {
            start.active = static_cast<int>(i);
        }
    }
    start.surface = std::move(arrays.input);
    if (!restored.layers.empty()) {
        QMetaObject::invokeMethod(&view_, "updateLayerTable", Qt::QueuedConnection);
    }
    tool_ = std::make_unique<CurveTool>(
        view_, std::move(start), *layers_, [this](const FilterDescription& filter) {
            useCurves(filter);
        }
    );
}

DocumentDrawing::~DocumentDrawing() {
    tool_->finish();
}

void DocumentDrawing::useCurves(const FilterDescription& filter) {
    QAction& action = actionOf(filter, *view_.window());
    const std::vector<int> curves = layers_->shownLayers();
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
        if (!before.contains(id)) {
            layers_->showNew(id);
        }
    }
}

}  // namespace bspline_curve
