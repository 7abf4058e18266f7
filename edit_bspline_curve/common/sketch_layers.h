// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/drawn_curve.h"
#include "filters/run_filters.h"
#include "host_filters.h"

#include <QGLWidget>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve {

/// A curve that the document has of a surface, with which the tool goes on.
struct TakenUp {
    DrawnCurve curve;
    int layer = -1;  ///< its id; -1: it is no layer yet
    bool isHidden = false;
};

/// Makes of a curve what its filter would make: of the tool, which has solved it already.
struct CurveMaker {
    std::function<DrawnCurve(const SketchCurve&)> drawn;  ///< what it is drawn from
    std::function<CurveResult(const SketchCurve&, const CurveRequest&)> result;
};

/// The layers of the curves of a sketch on one surface of the document. A layer is shown while its
/// curve is as it was when the layer was made; a curve that changed gets a new one in its place.
class SketchLayers {
public:
    /// `surface`: a layer that `arrays` are of.
    SketchLayers(
        MeshDocument& document,
        MLSceneGLSharedDataContext& shared,
        QGLWidget& view,
        const MeshModel& surface,
        const LayerArrays& arrays
    );

    /// The curves that the document has of the surface: layers that the tool can go on with, and
    /// what was not yet a curve when the tool ended. `other`: how many it cannot go on with.
    [[nodiscard]] std::vector<TakenUp> takeUp(const LayerArrays& arrays, int& other);

    /// Tells which curves of the sketch those are, in their order, and the checksum of the
    /// surface's layer. To be called before layers are made.
    void begin(
        const std::vector<TakenUp>& taken, const Sketch& sketch, const MeshChecksum& surface
    );

    /// Shows the layers of curves that are as they were, and hides the others; when the drawing is
    /// over, also those of curves that were changed into some that cannot be drawn.
    void show(const Sketch& sketch, bool isOver = false);

    /// Makes layers of all settled curves that are new or changed, and removes those of curves that
    /// are no more. How many were made. Throws what making one throws; the others are in line.
    int bring(const Sketch& sketch, const CurveMaker& maker);

    /// Keeps with the surface what is no layer yet, for the next start of the tool. How many curves
    /// these are.
    int keepUnfinished(const Sketch& sketch, const CurveMaker& maker);

    /// Whether a curve's layer is as the curve is.
    [[nodiscard]] bool isLayer(const SketchCurve& curve) const;
    /// Whether it is, and was saved to a file.
    [[nodiscard]] bool isSaved(const SketchCurve& curve) const;

    /// Ids of the layers of curves that are shown.
    [[nodiscard]] std::vector<int> shownLayers() const;

    [[nodiscard]] bool hasSurface() const;

    /// Draws a new layer in the view, as the host does its own.
    void showNew(int layer);

    /// Lets log and history of the document show a filter, as if it were applied in its dialog.
    void tellOfFilter(
        const FilterDescription& filter, const RichParameterList& parameters, const LogLines& said
    );

    /// A line in the document's log.
    void say(const std::string& text) { host::log(document_, GLLogStream::WARNING, text); }

private:
    struct Made {
        int layer = -1;
        std::shared_ptr<const SketchCurve> curve;  ///< as it was then
        bool isVisible = true;
    };

    [[nodiscard]] bool isSurfaceSame() const;
    [[nodiscard]] RichParameterList parametersOf(
        const SketchCurve& curve, const DrawnOptions& options
    ) const;
    void take(const std::shared_ptr<const SketchCurve>& curve, int layer);
    int makeOnSurface(const SketchCurve& curve, const CurveMaker& maker);
    int makeAlone(const SketchCurve& curve);
    void setVisible(Made& made, bool isVisible);
    bool removeLost(const Sketch& sketch);  ///< whether there were any

    MeshDocument& document_;
    MLSceneGLSharedDataContext& shared_;
    QGLWidget& view_;
    int surface_;                         ///< id
    LayerArrays ids_;                     ///< without input
    Matrix44m matrix_;                    ///< of the surface, as it was
    std::map<std::uint64_t, Made> made_;  ///< by the ids of their curves
};

}  // namespace bspline_curve
