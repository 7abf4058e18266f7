// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace bspline_curve {

/// Maps values to [0, 1]: the quantiles of 1 % and 99 % to 0 and 1, linear between, clamped beyond,
/// so that single outliers do not squeeze the rest. Where the two are equal, smallest and largest
/// take their place; equal values all become 0. O(n).
void normalise(std::span<double> values);

/// x becomes smallest + largest - x: high and low change places, the range stays.
void invert(std::span<double> values);

}  // namespace bspline_curve
