// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <functional>

namespace bspline_curve {

/// Called with a fraction in [0, 1] that never falls and the name of the stage; return false to
/// cancel. A cancelled call throws Cancelled and leaves nothing behind.
using Progress = std::function<bool(double fraction, const char* stage)>;

struct Cancelled : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// The stage of all that is made of a mesh once.
inline constexpr const char* kPreparingStage = "preparing the surface";

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

/// A callback for one of `count` steps that take alike; refers to `progress`.
[[nodiscard]] inline Progress stepOf(
    const Progress& progress, std::size_t step, std::size_t count
) {
    const double share = 1.0 / static_cast<double>(count);
    const double from = share * static_cast<double>(step);
    return partOf(progress, from, from + share);
}

}  // namespace bspline_curve
