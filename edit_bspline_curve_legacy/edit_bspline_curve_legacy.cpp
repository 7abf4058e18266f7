// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve_legacy/edit_bspline_curve_legacy.h"

#include "edit_bspline_curve/common/reopen.h"
#include "edit_bspline_curve/common/tool_icon.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filters/filter_description.h"

#include <common/filterscript.h>

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <exception>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

using namespace bspline_curve;

namespace {

// MeshLab makes the view's context current before it calls a tool.
QGLWidget* currentView() {
    const QGLContext* const context = QGLContext::currentContext();
    return context == nullptr ? nullptr : dynamic_cast<QGLWidget*>(context->device());
}

// The filter for curves, which is a plugin of its own.
QAction& filterOf(const QWidget& window) {
    const QString name = QString::fromStdString(curveFilter().name);
    for (const QMenu* const menu : window.findChildren<QMenu*>()) {
        for (QAction* const action : menu->actions()) {
            if (action->text() == name &&
                qobject_cast<MeshFilterInterface*>(action->parent()) != nullptr) {
                return *action;
            }
        }
    }
    throw std::runtime_error(
        "the filter \"" + curveFilter().name + "\" is not there: install its plugin as well"
    );
}

QString picksText(const SketchCurve& curve) {
    QString text;
    for (const SketchPick& pick : curve.picks) {
        for (int axis = 0; axis < 3; ++axis) {
            text += QString::number(pick.position[axis], 'g', 17) + ' ';
        }
        text += '\n';
    }
    return text;
}

RichParameterList parametersOf(const SketchCurve& curve, MeshDocument& document, int surface) {
    RichParameterList parameters = dialogParameters(curveFilter(), document, Offered::Usual);
    const SolverOptions& options = curve.options.solver;
    parameters.setValue("surface_layer", MeshValue(document.getMesh(surface)));
    parameters.setValue("picks", StringValue(picksText(curve)));
    parameters.setValue("closed", BoolValue(options.closed));
    parameters.setValue("replace", BoolValue(false));  // each curve has a layer of its own
    // Curves are drawn without a field.
    const std::size_t none = curveFilter().parameter("field").indexOf("none").value_or(0);
    parameters.setValue("field", EnumValue(static_cast<int>(none)));
    parameters.setValue("degree", IntValue(options.degree));
    parameters.setValue("tension", DynamicFloatValue(static_cast<float>(options.tension)));
    return parameters;
}

}  // namespace

bool EditBsplineCurveLegacy::StartEdit(
    MeshDocument& document, GLArea* /*area*/, MLSceneGLSharedDataContext* shared
) {
    view_ = currentView();
    const MeshModel* const surface = defaultSurface(document);
    if (surface == nullptr || view_ == nullptr) {
        return false;
    }
    document_ = &document;
    shared_ = shared;
    surface_ = surface->id();
    try {
        LayerArrays arrays = arraysOf(*surface);
        std::optional<DrawnCurve> curve = reopened(*document.mm(), *surface, arrays);
        reopened_ = curve ? document.mm()->id() : -1;
        tool_ = std::make_unique<CurveTool>(
            *view_,
            std::move(arrays.input.mesh),
            std::move(curve),
            [this](const CurveTool::Curves& curves) { makeLayers(curves); }
        );
        if (reopened_ >= 0) {
            setCurveVisible(document, reopened_, false);
        }
    } catch (const std::exception& error) {
        document.Log.Log(GLLogStream::WARNING, error.what());
        return false;
    }
    return true;
}

void EditBsplineCurveLegacy::EndEdit(
    MeshDocument& document, GLArea* /*area*/, MLSceneGLSharedDataContext* /*shared*/
) {
    tool_.reset();
    if (reopened_ >= 0) {
        setCurveVisible(document, std::exchange(reopened_, -1), true);
    }
}

void EditBsplineCurveLegacy::LayerChanged(
    MeshDocument& document, MeshModel& /*before*/, GLArea* area, MLSceneGLSharedDataContext* shared
) {
    if (tool_ && document.getMesh(surface_) == nullptr) {
        EndEdit(document, area, shared);
        StartEdit(document, area, shared);
    }
}

void EditBsplineCurveLegacy::
    Decorate(MeshModel& /*layer*/, GLArea* /*area*/, QPainter* /*painter*/) {
    if (tool_) {
        tool_->draw();
    }
}

void EditBsplineCurveLegacy::
    mousePressEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (tool_) {
        tool_->mousePress(*event);
    }
}

void EditBsplineCurveLegacy::
    mouseMoveEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (tool_) {
        tool_->mouseMove(*event);
    }
}

void EditBsplineCurveLegacy::mouseReleaseEvent(
    QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/
) {
    if (tool_) {
        tool_->mouseRelease(*event);
    }
}

void EditBsplineCurveLegacy::
    keyPressEvent(QKeyEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (tool_) {
        tool_->keyPress(*event);
    }
}

void EditBsplineCurveLegacy::
    wheelEvent(QWheelEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (tool_) {
        tool_->wheel(*event);
    }
}

void EditBsplineCurveLegacy::makeLayers(const CurveTool::Curves& curves) {
    QAction& filter = filterOf(*view_->window());
    for (const std::shared_ptr<const SketchCurve>& curve : curves) {
        makeLayer(*curve, filter);
    }
    if (reopened_ >= 0 && !curves.empty()) {
        removeCurve(*document_, std::exchange(reopened_, -1));
    }
    document_->setCurrentMesh(surface_);
    document_->setVisible(surface_, true);  // lets the list of layers see it
}

// By the filter, so that log and history show it.
void EditBsplineCurveLegacy::makeLayer(const SketchCurve& curve, QAction& filter) {
    auto& interface = *qobject_cast<MeshFilterInterface*>(filter.parent());
    std::set<int> before;
    for (const MeshModel* const layer : document_->meshList) {
        before.insert(layer->id());
    }
    const RichParameterList parameters = parametersOf(curve, *document_, surface_);
    interface.setLog(&document_->Log);
    if (!interface.applyFilter(&filter, *document_, parameters, nullptr)) {
        throw std::runtime_error(interface.errorMsg().toStdString());
    }
    FilterNameParameterValuesPair entry;
    entry.first = filter.text();
    entry.second = parameters;
    document_->filterHistory->append(entry);
    for (MeshModel* const layer : document_->meshList) {
        if (!before.contains(layer->id())) {
            MLRenderingData data;
            MLPoliciesStandAloneFunctions::suggestedDefaultPerViewRenderingData(layer, data);
            shared_->setRenderingDataPerMeshView(layer->id(), view_->context(), data);
            shared_->manageBuffers(layer->id());
        }
    }
}

EditBsplineCurveLegacyFactory::EditBsplineCurveLegacyFactory()
    : action_(new QAction(toolIcon(), "Draw B-spline Curves", this)) {
    action_->setCheckable(true);
}

MeshEditInterface* EditBsplineCurveLegacyFactory::getMeshEditInterface(QAction* action) {
    return action == action_ ? new EditBsplineCurveLegacy : nullptr;
}

QString EditBsplineCurveLegacyFactory::getEditToolDescription(QAction* /*action*/) {
    return "Draws smooth B-spline curves on the surface: click points, drag them, and the curve "
           "follows.";
}
