// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/value_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bspline_curve {

namespace {

/// The share-th quantile, linear between the two nearest; reorders the values.
double quantile(std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::ptrdiff_t>(place);
    const auto middle = values.begin() + below;
    std::ranges::nth_element(values, middle);
    const double low = *middle;
    const double high =
        middle + 1 == values.end() ? low : *std::min_element(middle + 1, values.end());
    return std::lerp(low, high, place - static_cast<double>(below));
}

}  // namespace

void normalise(std::span<double> values) {
    constexpr double kOutliers = 0.01;
    if (values.empty()) {
        return;
    }
    std::vector<double> copy(values.begin(), values.end());
    double low = quantile(copy, kOutliers);
    double high = quantile(copy, 1.0 - kOutliers);
    if (low == high) {
        const auto [smallest, largest] = std::ranges::minmax(values);
        low = smallest;
        high = largest;
    }
    for (double& value : values) {
        value = low == high ? 0.0 : std::clamp((value - low) / (high - low), 0.0, 1.0);
    }
}

void invert(std::span<double> values) {
    if (values.empty()) {
        return;
    }
    const auto [smallest, largest] = std::ranges::minmax(values);
    for (double& value : values) {
        value = smallest + largest - value;
    }
}

}  // namespace bspline_curve
