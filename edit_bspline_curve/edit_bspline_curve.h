// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/document_drawing.h"

#include <common/plugins/interfaces/edit_plugin.h>

#include <QAction>
#include <memory>

/// The tool *Draw B-spline Curves* of MeshLab 2025.07: a drawing session in the view.
class EditBsplineCurve : public QObject, public EditTool {
    Q_OBJECT

public:
    bool startEdit(
        MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* shared
    ) override;
    void endEdit(MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* shared) override;

    [[nodiscard]] bool isSingleMeshEdit() const override { return false; }

    /// Goes on with the same surface while it is there.
    void layerChanged(
        MeshDocument& document, MeshModel& before, GLArea* area, MLSceneGLSharedDataContext* shared
    ) override;
    void decorate(MeshModel& layer, GLArea* area, QPainter* painter) override;
    void mousePressEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void mouseMoveEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void mouseReleaseEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void wheelEvent(QWheelEvent* event, MeshModel& layer, GLArea* area) override;

private:
    std::unique_ptr<bspline_curve::DocumentDrawing> drawing_;
};

class EditBsplineCurvePlugin : public QObject, public EditPlugin {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(EDIT_PLUGIN_IID)
    Q_INTERFACES(EditPlugin)

public:
    EditBsplineCurvePlugin();

    [[nodiscard]] QString pluginName() const override;
    [[nodiscard]] QString vendor() const override;
    EditTool* getEditTool(const QAction* action) override;
    QString getEditToolDescription(const QAction* action) override;

private:
    QAction* action_;
};
