// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <vector>

namespace bspline_curve {

/// The validated surface that a designer draws on; as long as the designer.
[[nodiscard]] const Surface& surfaceOf(const CurveDesigner& designer);
/// The tree over its faces, likewise.
[[nodiscard]] const TriangleTree& treeOf(const CurveDesigner& designer);

/// Lets a designer on a mended mesh join other faces for picks that lie on different components,
/// see RejoinedDesigners.
void letRejoin(CurveDesigner& designer, std::vector<int> vertexOrigins);

}  // namespace bspline_curve
