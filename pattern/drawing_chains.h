// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/drawing.h"

namespace bspline_curve {

/// Open paths whose ends meet as one path, closed where that leads back to its start; where more
/// than two ends meet they stay apart. Ends meet that are nearer than 1e-6 of the drawing's size.
/// Paths are numbered anew, in the order of their first parts. O(n log n).
[[nodiscard]] Drawing chained(const Drawing& drawing);

}  // namespace bspline_curve
