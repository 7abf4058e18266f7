// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"

namespace bspline_curve {

/// Reports to a callback that may be empty; throws Cancelled where it says so.
inline void report(const Progress& progress, double fraction, const char* stage) {
    if (progress && !progress(fraction, stage)) {
        throw Cancelled();
    }
}

/// A callback for a part of the work: its fractions 0 to 1 are `from` to `to` of the whole. Empty
/// where the whole has none; refers to `progress`.
[[nodiscard]] inline Progress partOf(const Progress& progress, double from, double to) {
    if (!progress) {
        return {};
    }
    return [&progress, from, to](double fraction, const char* stage) {
        return progress(from + (to - from) * fraction, stage);
    };
}

}  // namespace bspline_curve
