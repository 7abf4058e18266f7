// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/energy_weights.h"

#include <optional>

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

    /// The same of further knots that promise to lower the energy: whether those of the last rounds
    /// did not what they had promised. The energy has a kink there, as where the curve lies along
    /// an edge of cells, and no number of knots gets round it. `energy`: at the end of this round.
    [[nodiscard]] bool isRefiningInVain(
        double energy, double promised, const EnergyWeights& weights
    );

private:
    /// What knots promised of the energy at the end of a round, under its weights.
    struct Promise {
        double energy, gain;
        EnergyWeights weights;
    };

    bool givesUp_;
    std::optional<Promise> promise_;  // of the knots of the round before
    int brokenPromises_ = 0;          // in turn
    int knotsAtRest_ = 0;             // when that came first, or 0
    int knotsNearby_ = 0;             // since when the curve has been near, or 0
    int roundsNearby_ = 0;            // the last ones
};

}  // namespace bspline_curve
