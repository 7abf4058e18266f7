// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/energy_derivatives.h"
#include "solver/sample_rule.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// The directions that bending along the surface does not count, sampled along a curve by
/// parameter: directionAt the shadow. They stay fixed during a minimisation, so that E_int is
/// quadratic.
struct BendingDirections {
    struct Sample {
        double parameter, weight;
        Vec3 direction;
    };

    std::vector<Sample> samples;  ///< ascending; the weights are those of a quadrature over [0, 1]

    /// Linear between samples, unit length. Needs at least one sample.
    [[nodiscard]] Vec3 at(double parameter) const;
};

/// Bending directions along a curve: cell by cell, or at samples. Nothing where the curve leaves
/// the shell.
[[nodiscard]] std::optional<BendingDirections> bendingDirectionsAlong(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule
);

/// E_int (4) of a span with all of the second derivative is x^T A x / 2 for each axis of its
/// control points; entry (i, j) of A belongs to basis functions i and j. Exact.
[[nodiscard]] SplineSpace::BasisMatrix ambientProducts(
    const CurveProblem& problem, const SplineSpace& space, int span
);

/// E_int (4): quadratic in the control points, integrated exactly but for the normal part; at
/// samples of the curve by differences, as in (14).
class InternalEnergy {
public:
    InternalEnergy(const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule);

    /// Leaves the part of bending along these directions out of E_int, but for the share
    /// SolverOptions::normalBendingWeight (Bending::Geodesic).
    void setDirections(const BendingDirections& directions);

    /// The energy; adds its derivatives where asked for.
    double add(const ControlPoints& controls, EnergyDerivatives* derivatives) const;

private:
    const CurveProblem& problem_;
    const SplineSpace& space_;
    std::vector<SpanMatrix> ambient_;   // with all of the second derivative; E = x^T H x / 2
    std::vector<SpanMatrix> internal_;  // the same less the normal part
};

}  // namespace bspline_curve
