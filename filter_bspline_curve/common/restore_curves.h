// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "host_document.h"

#include <string>
#include <vector>

namespace bspline_curve {

struct RestoredCurves {
    std::vector<int> layers;         ///< ids of those that are curves again
    std::vector<std::string> notes;  ///< sentences for the log
};

/// Makes curves again of the layers that were read from files beside which writeSideFile() has
/// left another: with picks, options and edges, in the coordinates and under the matrix of their
/// surface's layer. That is the layer with the mesh of then, where the curve is exactly as it was;
/// else one that all picks are near to, onto which they are projected. What cannot be restored
/// stays as it is, which a note tells once. Does not throw. Nothing is read for layers that are
/// curves already, or have faces.
RestoredCurves restoreCurves(MeshDocument& document);

}  // namespace bspline_curve
