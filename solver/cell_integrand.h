// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"
#include "shell/shell_cell.h"
#include "solver/curve_problem.h"
#include "solver/energy_derivatives.h"
#include "solver/energy_weights.h"
#include "solver/obstacles.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

/// The integrand of E_dist, E_ext and E_avoid in one cell: the barrier of the relative height, the
/// barrier of how far a point lies beyond a boundary (ghost cells), the cost of the field at the
/// shadow, and the barrier of how close that is to what the curve avoids.
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
    // The height d relative to the surface and its derivatives by w and w_S.
    struct HeightValue {
        double value = 0.0;
        double byHeight = 1.0, bySurface = 0.0;
        double byHeightTwice = 0.0, byBoth = 0.0, bySurfaceTwice = 0.0;
    };

    [[nodiscard]] HeightValue relativeHeightAt(const Vec3& p) const;
    [[nodiscard]] HeightValue linearHeightAt(double w, double v) const;
    void addAvoidance(
        const Vec3& p, double weight, EnergyTerms& terms, PointDerivatives& derivatives
    ) const;

    EnergyWeights weights_;
    double mu_;
    FieldCost cost_;
    AffineForm height_, surfaceHeight_, beyond_, field_;
    double heightScale_;
    bool hasSurfaceHeight_, hasBeyond_, isLinear_;
    bool isAvoided_ = false, hasCloseness_ = false;
    ClosenessForm closeness_;
};

}  // namespace bspline_curve
