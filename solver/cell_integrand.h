// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy_derivatives.h"
#include "solver/energy_terms.h"

namespace bspline_curve {

/// The integrand of PointTerms in one cell.
class CellIntegrand {
public:
    /// `heightScale` is the paper's eta: heights count this much of their value.
    CellIntegrand(
        const CurveProblem& problem,
        const EnergyWeights& weights,
        const ShellCell& cell,
        double heightScale = 1.0
    );

    /// Adds `weight` times the integrand at p to the terms; false where p is on or above a barrier.
    [[nodiscard]] bool add(const Vec3& p, double weight, EnergyTerms& terms) const;

    /// The same; adds the derivatives of the weighted terms, Gauss-Newton for the field.
    [[nodiscard]] bool add(
        const Vec3& p, double weight, EnergyTerms& terms, PointDerivatives& derivatives
    ) const;

    /// How far p is from the nearest pole of the integrand, relative to the barrier there: 1 where
    /// it is farthest, 0 on the pole.
    [[nodiscard]] double room(const Vec3& p) const;

    /// Gradient of the weighted integrand at p.
    [[nodiscard]] Vec3 gradient(const Vec3& p) const;

private:
    PointTerms::On<CellGround> terms_;
};

}  // namespace bspline_curve
