// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"
#include "solver/sampled_energy.h"

#include <optional>

namespace bspline_curve {

/// Newton's method for SampledEnergy in one space of splines; the picks stay met.
class SampledNewton {
public:
    /// Feet are found by follow(), from where the caller puts them in now(), or followRefined().
    SampledNewton(const CurveProblem& problem, SplineCurve curve, double heightUnit, int segments);
    SampledNewton(const SampledNewton&) = delete;  // parts of it refer to others
    SampledNewton& operator=(const SampledNewton&) = delete;

    [[nodiscard]] const SplineSpace& space() const { return space_; }

    [[nodiscard]] const SampledEnergy& energy() const { return energy_; }

    [[nodiscard]] const SplineSystem& system() const { return system_; }

    [[nodiscard]] FootedSpline& now() { return now_; }

    void follow(const FibreProjector& finder) { energy_.follow(finder, now_); }

    /// Where this spline is another one refined.
    void followRefined(const FibreProjector& finder, const SampledNewton& coarse) {
        energy_.followRefined(finder, coarse.energy_, coarse.now_, now_);
    }

    struct Step {
        EnergyTerms terms;  ///< before it
        double total, scale;
        double decrement;  ///< what the whole step promises
        double length;     ///< share of it that was taken; 0 where the energy does not fall
    };

    /// One step, with the bending directions of where it starts. Where it would not lower the
    /// energy, the spans that have more of it than foreseen are damped, and the step is made anew:
    /// the rest of the curve then goes all its way. Under a field it is shortened instead. Nothing
    /// where the Hessian is positive with no share of the surface's bending.
    std::optional<Step> step(const FibreProjector& finder, double alpha);

private:
    [[nodiscard]] std::optional<Eigen::VectorXd> direction(double alpha, EnergyTerms& terms);
    [[nodiscard]] std::optional<Eigen::VectorXd> factorisedDirection();
    bool tryStep(
        const FibreProjector& finder,
        const Eigen::VectorXd& direction,
        double alpha,
        double length,
        Step& step
    );
    [[nodiscard]] bool dampModelErrors(double alpha);

    SplineSpace space_;
    SampledEnergy energy_;
    SplineSystem system_;
    FootedSpline now_, trial_;
    Eigen::VectorXd gradient_;
    std::vector<SpanBlocks> hessian_;  // with the damping
    std::vector<double> damping_;      // by span, see SampledEnergy::addDamping()
};

}  // namespace bspline_curve
