// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/edit_bspline_curve.h"

#include "edit_bspline_curve/common/tool_icon.h"
#include "edit_bspline_curve/common/view.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <exception>

using namespace bspline_curve;

bool EditBsplineCurve::startEdit(
    MeshDocument& document, GLArea* /*area*/, MLSceneGLSharedDataContext* shared
) {
    try {
        drawing_ = std::make_unique<DocumentDrawing>(document, *shared, currentView());
    } catch (const std::exception& error) {
        host::log(document, GLLogStream::WARNING, error.what());
        return false;
    }
    return true;
}

void EditBsplineCurve::endEdit(
    MeshDocument& /*document*/, GLArea* /*area*/, MLSceneGLSharedDataContext* /*shared*/
) {
    drawing_.reset();
}

void EditBsplineCurve::layerChanged(
    MeshDocument& document, MeshModel& /*before*/, GLArea* area, MLSceneGLSharedDataContext* shared
) {
    if (drawing_ && !drawing_->hasSurface()) {
        endEdit(document, area, shared);
        startEdit(document, area, shared);
    }
}

void EditBsplineCurve::decorate(MeshModel& /*layer*/, GLArea* /*area*/, QPainter* /*painter*/) {
    if (drawing_) {
        drawing_->tool().draw();
    }
}

void EditBsplineCurve::mousePressEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().mousePress(*event);
    }
}

void EditBsplineCurve::mouseMoveEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().mouseMove(*event);
    }
}

void EditBsplineCurve::mouseReleaseEvent(
    QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/
) {
    if (drawing_) {
        drawing_->tool().mouseRelease(*event);
    }
}

void EditBsplineCurve::wheelEvent(QWheelEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().wheel(*event);
    }
}

EditBsplineCurvePlugin::EditBsplineCurvePlugin()
    : action_(new QAction(toolIcon(), "Draw B-spline Curves", this)) {
    action_->setCheckable(true);
    actionList.push_back(action_);
}

QString EditBsplineCurvePlugin::pluginName() const {
    return "EditBsplineCurve";
}

QString EditBsplineCurvePlugin::vendor() const {
    return "bspline_curve";
}

EditTool* EditBsplineCurvePlugin::getEditTool(const QAction* action) {
    return action == action_ ? new EditBsplineCurve : nullptr;
}

QString EditBsplineCurvePlugin::getEditToolDescription(const QAction* /*action*/) {
    return "Draws smooth B-spline curves on the surface: click points, drag them, and the curve "
           "follows.";
}
