// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "host_document.h"

#include <QString>
#include <string>

// What MeshLab's files cannot hold of a curve stands in a file of curves (JSON) beside them.
namespace bspline_curve {

/// "curve.ply.bspline.json" for "curve.ply".
[[nodiscard]] QString sideFileOf(const QString& file);

/// What to tell about a layer that was saved.
struct SavedLine {
    std::string text;  ///< empty: nothing
    bool isWarning = false;
};

/// Writes picks, options, polyline and spline of a curve's layer into the side file of the file
/// that it was saved in, in the coordinates of the layer, wholly or not at all. A file of that name
/// that is no file of curves stays as it is. Nothing for layers that are no curves. Does not throw.
[[nodiscard]] SavedLine writeSideFile(const MeshDocument& document, const MeshModel& layer);

/// Whether the vertices of a layer are those of a polyline in its coordinates, in order, up to what
/// MeshLab's formats round.
[[nodiscard]] bool isLine(const MeshModel& layer, const SurfacePolyline& line);

}  // namespace bspline_curve
