// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/view.h"
#include "sketch/drawing_session.h"

namespace bspline_curve {

/// Draws a sketch into the current context of OpenGL, over the surface: what the surface hides is
/// dimmed, and picks have the same size on the screen at any distance. Restores the state of
/// OpenGL.
void paintSketch(const DrawingSession& session, const View& view);

}  // namespace bspline_curve
