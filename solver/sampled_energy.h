// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/sampled_integrals.h"

#include <memory>
#include <vector>

namespace bspline_curve {

struct FootOfSpan;

/// The energy (7) at samples of a spline, by their foot points. Bending directions are frozen anew
/// at each differentiate(), so they are those of where a step starts.
class SampledEnergy final : public Energy {
public:
    /// `heightUnit`, `segments`: see SampledIntegrals. The feet are sought from the initial path.
    SampledEnergy(
        const CurveProblem& problem,
        SplineCurve curve,
        const InitialPath& initialPath,
        double heightUnit,
        int segments
    );

    [[nodiscard]] const ControlPoints& controls() const override { return now_.controls; }

    [[nodiscard]] const FootedSpline& footed() const { return now_; }

    void setFooted(const FootedSpline& spline) { now_ = spline; }

    void setControls(const ControlPoints& controls) override;

    EnergyValue differentiate() override;
    [[nodiscard]] const std::vector<SpanBlocks>& hessian(double negativeShare) override;
    EnergyValue tryStep(const Eigen::VectorXd& step, double length) override;

    void acceptStep() override { std::swap(now_, trial_); }

    [[nodiscard]] std::int64_t work() const override { return facesSeen_; }

    /// Damps spans so that the model has the energy of the trial there. What was not foreseen grows
    /// with the square of the way, as where samples pass kinks of the surface heights grow with it.
    [[nodiscard]] bool dampModelErrors() override;

    /// The largest height of a sample alone.
    [[nodiscard]] CurveDistance measure() override;
    /// In the problem's shell, or along the fibres where it has none.
    [[nodiscard]] CurveDistance trace() override;
    [[nodiscard]] KnotDemand refinementGain() override;
    void insertKnots(SplineSpace finer) override;
    [[nodiscard]] std::optional<TracedSpline> withFewerKnots() override;

private:
    [[nodiscard]] EnergyValue valueOf(const EnergyTerms& terms) const;
    void differentiateWith(double negativeShare);
    [[nodiscard]] FootOfSpan footAtMiddle(
        const SplineSpace& splines, const ControlPoints& controls
    ) const;
    [[nodiscard]] CurveDistance traceOf(
        const SplineSpace& splines, const ControlPoints& controls
    ) const;

    FibreProjector projector_;
    double heightUnit_;
    int segments_;
    std::unique_ptr<SampledIntegrals> integrals_;
    FootedSpline now_, trial_;
    std::int64_t facesSeen_ = 0;
    EnergyTerms terms_;            // at the last differentiate()
    double negativeShare_ = 1.0;   // in the Hessian
    std::vector<double> damping_;  // by span, see SampledIntegrals::addDamping()
};

}  // namespace bspline_curve
