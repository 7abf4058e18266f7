// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/solve_report.h"
#include "solver/spline_space.h"
#include "solver/spline_system.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// Weights of (7) during one minimisation.
struct EnergyWeights {
    double alpha = 1.0;         ///< of E_dist
    double beta = 0.0;          ///< of E_fit; 0 where the picks are constraints
    double barrierWidth = 1.0;  ///< h of (11)
};

struct EnergyValue {
    bool inside =
        false;  ///< the whole curve lies in the shell, below the barrier; else nothing else is set
    double total = 0.0;
    EnergyTerms terms;
};

/// First and second derivatives of the energy by the control points: the gradient, and the Hessian
/// as span blocks. The part of the Hessian that kinks of the integrand at cell walls subtract is
/// kept apart, so that it can be damped.
struct EnergyDerivatives {
    Eigen::VectorXd gradient;
    std::vector<SpanMatrix> hessian;
    std::vector<SpanMatrix> negativeKinks;

    void reset(const SplineSpace& space);
};

/// How far the curve is from the surface on each span, in the shell's frame.
struct SpanDistances {
    std::vector<double> distance;  ///< largest |P - M_S(P)| sampled, per span
    double largestHeight = 0.0;    ///< largest relative height d (10)
    [[nodiscard]] double largest() const;
};

/// The directions that bending along the surface does not count, sampled along a curve by
/// parameter: fibres at the shadow. They stay fixed during a minimisation, so that E_int is
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

/// The energy (7) of a spline in a shell, integrated cell by cell: every span is cut exactly where
/// it passes from one tetrahedron into the next, so that the integrand is smooth on each piece and
/// the energy C1 in the control points. Terms: E_int (4) exactly; E_dist (8) and E_ext (5) by Gauss
/// quadrature on each piece; E_fit (9). The Hessian holds the second derivative of the barrier,
/// Gauss-Newton for c(I), and the kinks at the walls.
class CurveEnergy {
public:
    CurveEnergy(
        const CurveProblem& problem,
        const SplineSpace& space,
        const std::vector<InterpolationRow>& rows
    );

    /// Bending directions along a curve; nothing where it leaves the shell.
    [[nodiscard]] std::optional<BendingDirections> directionsAlong(
        const ControlPoints& controls
    ) const;

    /// Leaves the part of bending along these directions out of E_int, but for the share
    /// SolverOptions::normalBendingWeight (Bending::Geodesic).
    void setDirections(const BendingDirections& directions);

    [[nodiscard]] EnergyValue evaluate(
        const ControlPoints& controls, const EnergyWeights& weights
    ) const;
    [[nodiscard]] EnergyValue evaluate(
        const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives& derivatives
    ) const;

    [[nodiscard]] SpanDistances measure(const ControlPoints& controls) const;

private:
    template <bool kDerivatives>
    [[nodiscard]] EnergyValue integrate(
        const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
    ) const;

    void addInternal(
        const ControlPoints& controls, EnergyValue& value, EnergyDerivatives* derivatives
    ) const;
    void addFit(
        const ControlPoints& controls,
        const EnergyWeights& weights,
        EnergyValue& value,
        EnergyDerivatives* derivatives
    ) const;

    const CurveProblem& problem_;
    const SplineSpace& space_;
    const std::vector<InterpolationRow>& rows_;
    std::vector<SpanMatrix> ambient_;   // E_int with all of the second derivative; E = x^T H x / 2
    std::vector<SpanMatrix> internal_;  // the same less the normal part
};

}  // namespace bspline_curve
