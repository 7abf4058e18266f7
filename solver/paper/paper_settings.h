// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solve_variant.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// What the paper's own settings change in solve(): adaptive weights (18), a tight barrier (12),
/// the penalty (9) and the feature function (19)-(23). The default options change nothing.
class PaperSettings final : public RoundVariant {
public:
    explicit PaperSettings(const CurveProblem& problem) : problem_(problem) {}

    /// alpha by (18) from the terms of the first curve, and the first beta. `largestHeight`: of the
    /// first curve as traced, 1 where it leaves the shell.
    void adjustFirst(Energy& energy, double largestHeight, EnergyWeights& first) const override;

    /// (18) from the weights and terms of the round before.
    void adjustNext(
        const EnergyWeights& before, const EnergyTerms& terms, EnergyWeights& next
    ) const override;

    /// (12) for the curve as it is: by its samples where these are all that the energy sees, else
    /// by `largestHeight`, that of all of it.
    void setBarrier(
        const Energy& energy, double largestHeight, EnergyWeights& weights
    ) const override;

    /// By the feature function.
    [[nodiscard]] std::optional<std::vector<double>> chooseBreaks(
        const Energy& energy, const EnergyWeights& weights, double scale, bool isNear
    ) override;

    /// Whether E_fit is small enough to stop: a penalty's gaps at the picks are below the
    /// tolerance.
    [[nodiscard]] bool arePicksNear(const Energy& energy) const override;

    /// A penalty leaves gaps at the picks: one constrained step closes them. How far that moves the
    /// farthest control point; 0 where there is no step to take.
    double meetPicks(Energy& energy, const NewtonPolicy& policy) const override;

private:
    void adjustAlpha(
        const EnergyWeights& before, const EnergyTerms& terms, EnergyWeights& next
    ) const;

    const CurveProblem& problem_;
    double feature_ = 0.0;  // (19) of the round before
};

}  // namespace bspline_curve
