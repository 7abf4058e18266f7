// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/curve_tool.h"
#include "edit_bspline_curve/common/curve_uses.h"
#include "edit_bspline_curve/common/sketch_layers.h"

#include <memory>

namespace bspline_curve {

/// The drawing tool on a surface of MeshLab's document: begins where it can, makes layers of what
/// is drawn, and ends.
class DocumentDrawing {
public:
    /// On the layer that a curve would be drawn on (see defaultSurface()). All curves that the
    /// document has of it are taken up again; the one that is the current layer is the active one.
    /// Throws InputError where there is no surface or it has no faces.
    DocumentDrawing(MeshDocument& document, MLSceneGLSharedDataContext& shared, QGLWidget& view);

    /// Makes layers of what is drawn, and keeps the rest with the surface.
    ~DocumentDrawing();

    DocumentDrawing(const DocumentDrawing&) = delete;
    DocumentDrawing& operator=(const DocumentDrawing&) = delete;

    /// Whether the surface is still there.
    [[nodiscard]] bool hasSurface() const { return layers_->hasSurface(); }

    [[nodiscard]] CurveTool& tool() { return *tool_; }

private:
    std::unique_ptr<SketchLayers> layers_;
    std::unique_ptr<CurveUses> uses_;
    std::unique_ptr<CurveTool> tool_;
};

}  // namespace bspline_curve
