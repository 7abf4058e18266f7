// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/document_drawing.h"

#include "bspline_curve/error.h"
#include "edit_bspline_curve/common/curve_words.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/restore_curves.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <utility>

namespace bspline_curve {

DocumentDrawing::DocumentDrawing(
    MeshDocument& document, MLSceneGLSharedDataContext& shared, QGLWidget& view
) {
    const RestoredCurves restored = restoreCurves(document);
    const MeshModel* const surface = defaultSurface(document);
    if (surface == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    LayerArrays arrays = arraysOf(*surface);
    layers_ = std::make_unique<SketchLayers>(document, shared, view, *surface, arrays);
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
    start.surface = std::move(arrays);
    if (!restored.layers.empty()) {
        QMetaObject::invokeMethod(&view, "updateLayerTable", Qt::QueuedConnection);
    }
    uses_ = std::make_unique<CurveUses>(document, *layers_, surface->id());
    tool_ = std::make_unique<CurveTool>(view, std::move(start), *layers_, *uses_);
}

DocumentDrawing::~DocumentDrawing() {
    tool_->finish();
}

}  // namespace bspline_curve
