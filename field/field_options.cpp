// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/field.h"
#include "text/error_messages.h"

#include <cmath>
#include <string>

namespace bspline_curve {

namespace {

void require(bool holds, const char* option, double value, const char* rule) {
    if (!holds) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string(option) + " is " + describeNumber(value) + ", but must be " + rule
        );
    }
}

/// NaN is none.
bool isShare(double value) {
    return value >= 0.0 && value <= 1.0;
}

}  // namespace

const char* name(FieldKind kind) {
    switch (kind) {
        case FieldKind::NormalVariation:
            return "normal-variation";
        case FieldKind::Ridge:
            return "ridge";
        case FieldKind::Valley:
            return "valley";
        case FieldKind::CreaseDistance:
            return "crease-distance";
        case FieldKind::BoundaryDistance:
            return "boundary-distance";
        case FieldKind::Quality:
            return "quality";
        case FieldKind::Obstacle:
            return "obstacle";
        case FieldKind::MaximalCurvature:
            break;
    }
    return "maximal-curvature";
}

FieldCost naturalCost(FieldKind kind) {
    switch (kind) {
        case FieldKind::NormalVariation:
        case FieldKind::CreaseDistance:
        case FieldKind::BoundaryDistance:
            return FieldCost::Square;
        case FieldKind::Quality:
        case FieldKind::Obstacle:
            return FieldCost::Identity;
        case FieldKind::MaximalCurvature:
        case FieldKind::Ridge:
        case FieldKind::Valley:
            break;
    }
    return FieldCost::ExpMinus;
}

const char* name(FieldCost cost) {
    switch (cost) {
        case FieldCost::Square:
            return "square";
        case FieldCost::ExpMinus:
            return "exp-minus";
        case FieldCost::Natural:
            return "natural";
        case FieldCost::Identity:
            break;
    }
    return "identity";
}

void FieldOptions::validate() const {
    require(
        isShare(curvatureScale), "curvature scale", curvatureScale, "in [0, 1] (of the diagonal)"
    );
    require(
        creaseAngle >= 0.0 && creaseAngle <= 180.0,
        "crease angle",
        creaseAngle,
        "in [0, 180] (degrees)"
    );
    require(isShare(reach) && reach > 0.0, "field reach", reach, "in (0, 1] (of the diagonal)");
    require(
        obstacleValue >= 0.0 && std::isfinite(obstacleValue),
        "obstacle value",
        obstacleValue,
        "finite and not negative"
    );
    require(
        obstacleSlope > 0.0 && std::isfinite(obstacleSlope),
        "obstacle slope",
        obstacleSlope,
        "finite and above 0 (per diagonal)"
    );
    require(isShare(smoothing), "field smoothing", smoothing, "in [0, 1] (of the diagonal)");
}

}  // namespace bspline_curve
