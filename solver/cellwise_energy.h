// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/cellwise_integrals.h"
#include "solver/energy.h"
#include "solver/newton.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bspline_curve {

/// For CellwiseEnergy.
[[nodiscard]] NewtonPolicy cellwiseNewton();

/// The energy (7) of a spline in a shell, cell by cell, or in rounds that only prepare the next one
/// at a few samples; or at the paper's samples. Bending directions stay frozen until
/// freezeDirections().
class CellwiseEnergy final : public Energy {
public:
    /// `tensionFloor`: what no knot can save of E_int.
    CellwiseEnergy(const CurveProblem& problem, SplineCurve curve, double tensionFloor);

    [[nodiscard]] const ControlPoints& controls() const override { return controls_; }

    void setControls(const ControlPoints& controls) override {
        controls_ = controls;
        isDifferentiated_ = false;
    }

    void setWeights(const EnergyWeights& weights) override;
    EnergyValue differentiate() override;
    [[nodiscard]] const std::vector<SpanBlocks>& hessian(double negativeShare) override;
    EnergyValue tryStep(const Eigen::VectorXd& step, double length) override;
    void acceptStep() override;

    void freezeDirections(double freshShare) override;

    [[nodiscard]] bool isRough() const override;
    void makeExact() override;

    [[nodiscard]] CurveDistance measure() override { return trace(); }

    [[nodiscard]] CurveDistance trace() override;

    /// By one Newton step in the space with all spans halved, shared among the spans by the step's
    /// energy norm; the directions stay as they are.
    [[nodiscard]] KnotDemand refinementGain() override;
    void insertKnots(SplineSpace finer) override;

    /// Spans that were integrated, over all evaluations.
    [[nodiscard]] std::int64_t work() const override { return spansSeen_; }

private:
    void setRule(const SampleRule& rule);

    SampleRule rule_;
    double tensionFloor_;
    double restingMove_;  // more knots change nothing where they move the curve less than this
    std::unique_ptr<CellwiseIntegrals> integrals_;
    BendingDirections directions_;
    ControlPoints controls_, trial_;
    EnergyValue value_, trialValue_;
    EnergyDerivatives trialDerivatives_;
    bool isDifferentiated_ = false, isTrialDifferentiated_ = false;
    std::vector<SpanBlocks> hessian_;  // with a share of the negative part
    double negativeShare_ = 0.0;
    std::int64_t spansSeen_ = 0;
};

}  // namespace bspline_curve
