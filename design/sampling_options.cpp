// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "bspline_curve/options.h"

#include <cmath>
#include <string>

namespace bspline_curve {

void SamplingOptions::validate() const {
    if (samples < 0) {
        throw InputError(
            InputErrorCode::BadOption,
            "samples is " + std::to_string(samples) + ", but must not be negative"
        );
    }
    if (!(maxSegmentLength >= 0.0) || !std::isfinite(maxSegmentLength)) {
        throw InputError(
            InputErrorCode::BadOption,
            "max segment length is " + std::to_string(maxSegmentLength) +
                ", but must be finite and not negative"
        );
    }
}

}  // namespace bspline_curve
