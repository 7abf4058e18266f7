// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace bspline_curve::cli {

/// CPU seconds that this process has used so far, all threads together.
[[nodiscard]] double processCpuSeconds();

/// Largest resident memory of this program so far, in bytes.
[[nodiscard]] std::int64_t peakMemoryBytes();

/// The unit in which Linux tells of memory.
inline constexpr std::int64_t kKilobyte = 1024;

/// From now on large arrays go back to the system as soon as they are freed. Else glibc keeps them,
/// in pieces that later ones do not fit into; a third more memory on a large mesh.
void returnLargeArrays();

}  // namespace bspline_curve::cli
