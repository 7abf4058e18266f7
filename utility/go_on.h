// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace bspline_curve {

/// Called again and again during long work; may throw, which ends it. Never empty.
using GoOn = std::function<void()>;

/// Loops whose rounds take less than a microsecond or two call it once in so many.
inline constexpr std::size_t kRoundsBetweenCalls = 16384;

}  // namespace bspline_curve
