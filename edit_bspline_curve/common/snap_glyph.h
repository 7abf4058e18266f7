// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "edit_bspline_curve/common/screen_batch.h"

namespace bspline_curve {

/// Marks what a pick snapped to, with a shape for each kind, around the place of the pick's
/// handle: a square for a vertex, a diamond for another pick, two bars for a boundary, two corners
/// for a crease, a triangle that points up for a ridge and one that points down for a valley.
void addSnapGlyph(ScreenBatch& batch, const ScreenNode& place, SnapKind kind, double ratio);

}  // namespace bspline_curve
