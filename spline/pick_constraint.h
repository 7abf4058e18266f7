// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstddef>
#include <span>

namespace bspline_curve {

/// A pick in the shell's frame, with the parameter at which the curve passes it.
struct PickConstraint {
    SurfacePoint point;
    Vec3 position;
    double parameter = 0.0;       ///< t_ki; 0 for the first
    Vec3 tangent = Vec3::Zero();  ///< unit direction in which the curve passes it; zero: any
    double speed = 0.0;           ///< |P'| there, where there is such a direction

    [[nodiscard]] bool hasTangent() const { return !tangent.isZero(0.0); }
};

/// L of (4): the length of the polygon of picks.
[[nodiscard]] inline double polygonLength(std::span<const PickConstraint> picks, bool closed) {
    double length = 0.0;
    for (std::size_t i = 1; i < picks.size(); ++i) {
        length += (picks[i].position - picks[i - 1].position).norm();
    }
    return closed ? length + (picks.front().position - picks.back().position).norm() : length;
}

}  // namespace bspline_curve
