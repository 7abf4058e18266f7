// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve_options.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

bool canBeFollowed(std::span<const double> quality) {
    if (quality.empty() ||
        !std::ranges::all_of(quality, [](double value) { return std::isfinite(value); })) {
        return false;
    }
    return std::ranges::any_of(quality, [&](double value) { return value != quality.front(); });
}

}  // namespace bspline_curve
