// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/face_fibres.h"
#include "shell/polynomial_trace.h"

#include <optional>

namespace bspline_curve {

/// A point of a curve and its foot on one face.
struct FibrePlace {
    Vec3 position = Vec3::Zero();
    Vec3 along = Vec3::Zero();  ///< the derivative of the curve by its parameter
    FootPoint foot;
    FootFrame frame;  ///< but for what FaceFibres::complete() adds
};

/// Where a curve leaves the fibres of a face.
struct FibreExit {
    double tau;  ///< its parameter there
    int wall;    ///< opposite to this corner; -1: nowhere up to 1
};

/// The first place from tau on, up to 1, where the foot of a curve leaves its face, with what is
/// there in `there`. Exact to 1e-11 of the face. Nothing where fibres cross. `here`: at tau. About
/// 800 instructions where the curve is nearly straight over the face, else some times as many.
[[nodiscard]] std::optional<FibreExit> findExit(
    const FaceFibres& fibres,
    const PolynomialCurve& curve,
    double tau,
    const FibrePlace& here,
    FibrePlace& there
);

}  // namespace bspline_curve
