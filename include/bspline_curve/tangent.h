// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

namespace bspline_curve {

/// The direction in which a curve passes a pick, of any length, by its part along the surface: in
/// the plane whose normal is the mean of the faces' normals there. Zero: any. At a corner the curve
/// comes in one and goes on in another; elsewhere both are the same.
struct PickTangent {
    Vec3 before = Vec3::Zero(), after = Vec3::Zero();

    [[nodiscard]] static PickTangent along(const Vec3& direction) { return {direction, direction}; }

    [[nodiscard]] bool isAny() const { return before.isZero(0.0) && after.isZero(0.0); }

    [[nodiscard]] bool isOne() const { return before == after; }

    friend bool operator==(const PickTangent&, const PickTangent&) = default;
};

}  // namespace bspline_curve
