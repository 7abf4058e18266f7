// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/document_drawing.h"

#include <common/interfaces.h>
#include <common/ml_shared_data_context.h>

#include <QAction>
#include <memory>

/// The tool *Draw B-spline Curves* of MeshLab 2020.09: a drawing session in the view.
class EditBsplineCurveLegacy : public QObject, public MeshEditInterface {
    Q_OBJECT
    Q_INTERFACES(MeshEditInterface)

public:
    bool StartEdit(
        MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* shared
    ) override;
    void EndEdit(MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* shared) override;

    [[nodiscard]] bool isSingleMeshEdit() const override { return false; }

    /// Goes on with the same surface while it is there.
    void LayerChanged(
        MeshDocument& document, MeshModel& before, GLArea* area, MLSceneGLSharedDataContext* shared
    ) override;
    void Decorate(MeshModel& layer, GLArea* area, QPainter* painter) override;
    void mousePressEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void mouseMoveEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void mouseReleaseEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
    void wheelEvent(QWheelEvent* event, MeshModel& layer, GLArea* area) override;

private:
    std::unique_ptr<bspline_curve::DocumentDrawing> drawing_;
};

class EditBsplineCurveLegacyFactory : public QObject, public MeshEditInterfaceFactory {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_EDIT_INTERFACE_FACTORY_IID)
    Q_INTERFACES(MeshEditInterfaceFactory)

public:
    EditBsplineCurveLegacyFactory();

    [[nodiscard]] QList<QAction*> actions() const override { return {action_}; }

    MeshEditInterface* getMeshEditInterface(QAction* action) override;
    QString getEditToolDescription(QAction* action) override;

private:
    QAction* action_;
};
