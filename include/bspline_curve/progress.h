// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>

namespace bspline_curve {

/// Called with a fraction in [0, 1] that never falls and the name of the stage; return false to
/// cancel. A cancelled call throws Cancelled and leaves nothing behind.
using Progress = std::function<bool(double fraction, const char* stage)>;

struct Cancelled : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace bspline_curve
