// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "design/curve_designer.h"
#include "sketch/curve_worker.h"
#include "sketch/stroke.h"
#include "surface/triangle_tree.h"

#include <memory>

namespace bspline_curve {

struct DrawingSession::Seen : TriangleTree::Hit {};

struct DrawingSession::Answer : SolveAnswer {};

struct DrawingSession::Request : SolveRequest {};

struct DrawingSession::Freehand : Stroke {};

/// A stroke whose curve is asked for.
struct DrawingSession::AskedStroke {
    std::shared_ptr<SketchCurve> curve;  ///< until then
    Stroke stroke;
    double pixel = 0.0;  ///< width of a pixel there, user's unit
};

struct DrawingSession::Solver {
    std::shared_ptr<const CurveDesigner> designer;
    CurveWorker worker;
};

}  // namespace bspline_curve
