// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/options.h"

#include <cmath>
#include <string>

namespace bspline_curve {

void FitOptions::validate() const {
    if (!(deviation.value >= 0.0) || !std::isfinite(deviation.value)) {
        throw InputError(
            InputErrorCode::BadOption,
            "deviation is " + std::to_string(deviation.value) +
                ", but must be finite and not negative"
        );
    }
    if (std::isnan(cornerAngle) || cornerAngle < 1.0 || cornerAngle > 180.0) {
        throw InputError(
            InputErrorCode::BadOption,
            "corner_angle is " + std::to_string(cornerAngle) +
                ", but must be in [1, 180] degrees; 180: no corners"
        );
    }
}

}  // namespace bspline_curve
