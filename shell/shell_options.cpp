// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/shell.h"

#include <string>

namespace bspline_curve {

namespace {

void checkShare(double value, const char* name) {
    const bool isShare = value > 0.0 && value <= 1.0;  // NaN is not
    if (!isShare) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string(name) + " is " + std::to_string(value) +
                ", but must be above 0 and at most 1 (longest sides of the mesh's box)"
        );
    }
}

}  // namespace

const char* name(ShellKind kind) {
    switch (kind) {
        case ShellKind::Simplified:
            return "simplified";
        case ShellKind::FullResolution:
            return "full";
        case ShellKind::Local:
            return "local";
    }
    return "";
}

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
            "shell smoothing passes are " + std::to_string(smoothingPasses) +
                ", but must not be negative"
        );
    }
    checkShare(targetThickness, "target thickness");
    checkShare(targetEdgeLength, "target edge length");
}

}  // namespace bspline_curve
