// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace bspline_curve::cli {

/// CPU seconds that this process has used so far, all threads together.
[[nodiscard]] double processCpuSeconds();

/// Largest resident memory of this program so far, in bytes.
[[nodiscard]] std::int64_t peakMemoryBytes();

}  // namespace bspline_curve::cli
