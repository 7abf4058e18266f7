// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/surface_walk.h"

namespace bspline_curve {

/// A point of a path that is faired.
struct FairingNode : SurfaceNode {
    Vec3 normal = Vec3::Zero();  ///< of the faces around, unit
};

}  // namespace bspline_curve
