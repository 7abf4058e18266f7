// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {

/// How the weight alpha of the distance grows from round to round, by what the curve needs to come
/// near enough: heights fall with a power of it.
struct WeightSchedule {
    /// A curve is near below this distance, in tolerances: then alpha stands still.
    double nearShare = 1.0;
    /// The distance that a growth aims at, in tolerances.
    double aimedShare = 0.8;
    /// Share by which a growth goes beyond what that needs.
    double overshoot = 1.0;
    /// alpha grows with this power of the distance: more slowly in theory, but heights lag behind.
    double exponent = 1.5;
    /// Bounds of the factor: less wastes rounds; more lets a stiff curve slide sideways.
    double leastFactor = 1.5, mostFactor = 6.0;
    /// Whether the factor follows what is needed; else it is mostFactor.
    bool isGentle = true;
    /// No more attempts above this: such a curve does not come near.
    double highest = std::numeric_limits<double>::infinity();
    /// Back to `returnTo`, the weight that the curve had before, by this factor at least.
    double returnFactor = 3.0;
    double returnTo = 0.0;

    /// By what alpha grows after a round that leaves the curve this many tolerances away.
    [[nodiscard]] double growth(double ratio) const {
        const double needed = std::pow(overshoot * ratio / aimedShare, exponent);
        return isGentle ? std::clamp(needed, leastFactor, mostFactor) : mostFactor;
    }

    /// The weight of the next round.
    [[nodiscard]] double next(double alpha, double ratio) const {
        return ratio < nearShare
                   ? alpha
                   : alpha * std::max(growth(ratio), std::min(returnFactor, returnTo / alpha));
    }
};

}  // namespace bspline_curve
