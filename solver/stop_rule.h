// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"

namespace bspline_curve {

/// Tells after each round whether the next ones would be in vain.
class StopRule {
public:
    /// `givesUp`: also a curve that stays far from the surface, or is near and still asks for more
    /// knots: mostly it passes through a fold or a thin part of the surface. Else only one that is
    /// near and whose minimisation never ends.
    explicit StopRule(bool givesUp) : givesUp_(givesUp) {}

    /// `isNear`: the curve is near enough at all samples.
    [[nodiscard]] bool isInVain(
        const CurveProblem& problem, const Energy& energy, const SolveReport& report, bool isNear
    );

    /// The same where a curve came to rest, but leaves the tolerance somewhere.
    [[nodiscard]] bool isHalvingInVain(int knots);

private:
    bool givesUp_;
    int knotsAtRest_ = 0;   // when that came first, or 0
    int knotsNearby_ = 0;   // since when the curve has been near, or 0
    int roundsNearby_ = 0;  // the last ones
};

}  // namespace bspline_curve
