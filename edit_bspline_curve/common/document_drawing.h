// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/curve_tool.h"
#include "host_filters.h"

#include <vector>

class QAction;

namespace bspline_curve {

/// The drawing tool on a surface of MeshLab's document: begins where it can, makes layers of what
/// is drawn, and ends.
class DocumentDrawing {
public:
    /// On the layer that a curve would be drawn on (see defaultSurface()). A curve that is the
    /// current layer is taken up again, and its layers are hidden meanwhile. Throws InputError
    /// where there is no surface or it has no faces.
    DocumentDrawing(MeshDocument& document, MLSceneGLSharedDataContext& shared);
    ~DocumentDrawing();
    DocumentDrawing(const DocumentDrawing&) = delete;
    DocumentDrawing& operator=(const DocumentDrawing&) = delete;

    /// Whether the surface is still there.
    [[nodiscard]] bool hasSurface() const;

    [[nodiscard]] CurveTool& tool() { return *tool_; }

private:
    void begin(const MeshModel& surface);
    void makeLayers(const std::vector<DrawnCurve>& curves);
    void makeLayer(const DrawnCurve& curve);
    void useCurves(const FilterDescription& filter);
    [[nodiscard]] std::vector<int> madeCurves() const;
    void run(QAction& filter, const RichParameterList& parameters);

    MeshDocument& document_;
    MLSceneGLSharedDataContext& shared_;
    QGLWidget& view_;
    int surface_ = -1;       ///< id of its layer
    int reopened_ = -1;      ///< id of the layer of the curve that was taken up again
    std::vector<int> made_;  ///< ids of the layers of curves
    std::unique_ptr<CurveTool> tool_;
};

}  // namespace bspline_curve
