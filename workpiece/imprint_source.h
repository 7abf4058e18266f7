// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "surface/surface.h"

#include <memory>

namespace bspline_curve {

/// What an imprint was made on.
struct Imprint::Source {
    /// The workpiece's surface, or one that was joined anew for curves that pass from sheet to
    /// sheet.
    std::shared_ptr<const Surface> surface;
};

}  // namespace bspline_curve
