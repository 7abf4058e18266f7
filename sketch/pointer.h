// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <Eigen/Geometry>

namespace bspline_curve {

/// Where the mouse is: the ray into the scene through its pixel, in the mesh's unit.
struct Pointer {
    Vec3 start = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();  ///< unit length, away from the viewer
    /// The width of a pixel: at distance 1 from the start, or anywhere if the view is
    /// orthographic.
    double pixel = 1e-3;
    bool isOrthographic = false;
    bool snaps = false;    ///< the key that snaps picks to features is held
    bool removes = false;  ///< the key that turns clicks on picks into their removal is held

    [[nodiscard]] double pixelAt(double distance) const {
        return isOrthographic ? pixel : pixel * distance;
    }
};

/// Keys of the drawing session; hosts say which of theirs they are.
enum class SketchKey {
    Add,        ///< a pick where the pointer is, as a click does
    Move,       ///< the selected pick to where the pointer is, as a drag does
    Next,       ///< select the next pick, or the first
    Previous,   ///< select the pick before, or the last
    NextCurve,  ///< make the next curve the active one
    Remove,     ///< the selected pick, or the active curve where none is selected
    Close,      ///< close the active curve, or open it
    NewCurve,   ///< the next pick begins a curve
    Undo,
    Redo,
    Cancel,  ///< the drag that goes on; else the selection
};

}  // namespace bspline_curve
