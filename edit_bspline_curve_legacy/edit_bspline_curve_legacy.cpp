// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve_legacy/edit_bspline_curve_legacy.h"

#include "edit_bspline_curve/common/tool_icon.h"
#include "edit_bspline_curve/common/view.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <exception>

using namespace bspline_curve;

bool EditBsplineCurveLegacy::StartEdit(
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

void EditBsplineCurveLegacy::EndEdit(
    MeshDocument& /*document*/, GLArea* /*area*/, MLSceneGLSharedDataContext* /*shared*/
) {
    drawing_.reset();
}

void EditBsplineCurveLegacy::LayerChanged(
    MeshDocument& document, MeshModel& /*before*/, GLArea* area, MLSceneGLSharedDataContext* shared
) {
    if (drawing_ && !drawing_->hasSurface()) {
        EndEdit(document, area, shared);
        StartEdit(document, area, shared);
    }
}

void EditBsplineCurveLegacy::
    Decorate(MeshModel& /*layer*/, GLArea* /*area*/, QPainter* /*painter*/) {
    if (drawing_) {
        drawing_->tool().draw();
    }
}

void EditBsplineCurveLegacy::
    mousePressEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().mousePress(*event);
    }
}

void EditBsplineCurveLegacy::
    mouseMoveEvent(QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().mouseMove(*event);
    }
}

void EditBsplineCurveLegacy::mouseReleaseEvent(
    QMouseEvent* event, MeshModel& /*layer*/, GLArea* /*area*/
) {
    if (drawing_) {
        drawing_->tool().mouseRelease(*event);
    }
}

void EditBsplineCurveLegacy::
    wheelEvent(QWheelEvent* event, MeshModel& /*layer*/, GLArea* /*area*/) {
    if (drawing_) {
        drawing_->tool().wheel(*event);
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
