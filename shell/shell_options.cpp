// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_options.h"

#include "surface/input_error.h"

#include <string>

namespace bspline_curve {

void ShellOptions::validate() const {
    const bool isThick = thickness > 0.0 && thickness <= kMaxShellThickness;  // NaN is not
    if (!isThick) {
        throw InputError(
            InputErrorCode::BadOption,
            "shell thickness is " + std::to_string(thickness) +
                ", but must be above 0 and at most 1000 (mean edge lengths)"
        );
    }
    if (smoothingPasses < 0) {
        throw InputError(
            InputErrorCode::BadOption,
            "smoothing passes are " + std::to_string(smoothingPasses) + ", but must not be negative"
        );
    }
}

}  // namespace bspline_curve
