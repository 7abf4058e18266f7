// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "edit_bspline_curve/common/view.h"

namespace bspline_curve {

/// Draws a sketch into the current context of OpenGL (the fixed pipeline of version 1.1), over the
/// surface: each curve in its colour, the active one wider, with halos that differ from any
/// surface; the preview as dashes; handles of the active curve and of one under the pointer,
/// numbered from 1 where there is room; what a pick snapped to. What the surface hides is dimmed,
/// and all has the same size on the screen at any distance. Restores the state of OpenGL. Linear in
/// the number of points, but a search of the surface for each handle, and quadratic in the picks of
/// the active curve.
void paintSketch(const DrawingSession& session, const View& view);

}  // namespace bspline_curve
