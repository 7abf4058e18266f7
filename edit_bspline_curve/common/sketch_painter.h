// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sketch/drawing_session.h"

namespace bspline_curve {

/// Draws a sketch into the current context of OpenGL, over the surface: what the surface hides is
/// dimmed, and picks have the same size on the screen at any distance. `ratio`: device pixels per
/// logical pixel. Restores the state of OpenGL.
void paintSketch(const DrawingSession& session, double ratio);

}  // namespace bspline_curve
