// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

namespace bspline_curve {

/// A pick in the shell's frame, with the parameter at which the curve passes it.
struct PickConstraint {
    SurfacePoint point;
    Vec3 position;
    double parameter = 0.0;  ///< t_ki; 0 for the first
};

}  // namespace bspline_curve
