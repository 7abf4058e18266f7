// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace bspline_curve {

/// Called again and again during long work; may throw, which ends it.
using GoOn = std::function<void()>;

}  // namespace bspline_curve
