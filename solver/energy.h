// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"
#include "projection/curve_distance.h"
#include "solver/energy_derivatives.h"
#include "solver/energy_weights.h"
#include "solver/initial_curve.h"
#include "spline/spline_system.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The energy (7) at a spline.
struct EnergyValue {
    bool inside = false;  ///< the spline may be used: below the barrier; else nothing else is set
    double total = 0.0;
    /// What changes of the energy are measured against: the terms that are never negative, and a
    /// part of what the field costs over its least cost.
    double scale = 0.0;
    EnergyTerms terms;
};

/// What knots would gain, span by span.
struct KnotDemand {
    double total = 0.0;
    std::vector<double> perSpan;
    bool isNegligible = false;  ///< more knots no longer change the curve
};

/// A spline that has been traced as a whole.
struct TracedSpline {
    SplineCurve curve;
    CurveDistance distance;
};

/// The energy (7) of a spline, which it holds: what minimise() and solve() ask of it. Bending
/// directions and whatever else is held fixed meanwhile belong to the energy.
class Energy {
public:
    Energy(const Energy&) = delete;
    Energy& operator=(const Energy&) = delete;
    virtual ~Energy() = default;

    [[nodiscard]] const SplineSpace& space() const { return basis_->space; }

    [[nodiscard]] SplineSystem& system() { return basis_->system; }

    [[nodiscard]] const PickConstraints& picks() const { return basis_->system.constraints(); }

    [[nodiscard]] virtual const ControlPoints& controls() const = 0;

    // ---- For Newton's method ----

    /// For all that follows.
    virtual void setWeights(const EnergyWeights& weights) { weights_ = weights; }

    /// Value and derivatives at the spline. To be called once before each step.
    virtual EnergyValue differentiate() = 0;

    /// As of the last differentiate(). The Hessian may lack its negative part.
    [[nodiscard]] const EnergyDerivatives& derivatives() const { return derivatives_; }

    /// The Hessian with a share of the part that can make it indefinite.
    [[nodiscard]] virtual const std::vector<SpanBlocks>& hessian(double negativeShare) = 0;

    /// Value at the spline moved by `length` times `step`.
    virtual EnergyValue tryStep(const Eigen::VectorXd& step, double length) = 0;
    /// Moves the spline where it was tried last.
    virtual void acceptStep() = 0;

    /// Stiffens the Hessian on spans that had more energy at the last trial than its model says.
    /// False where there are none.
    [[nodiscard]] virtual bool dampModelErrors() { return false; }

    /// What all of that has cost so far: at samples the faces that feet were sought on, cell by
    /// cell the spans that were integrated. Where nothing is counted, 0.
    [[nodiscard]] virtual std::int64_t work() const { return 0; }

    // ---- For Algorithm 1 ----

    virtual void setControls(const ControlPoints& controls) = 0;

    /// Takes the bending directions along the spline, blended with those before.
    virtual void freezeDirections(double /*freshShare*/) {}

    /// Whether integrals are taken roughly, for rounds that only prepare the next one.
    [[nodiscard]] virtual bool isRough() const { return false; }

    virtual void makeExact() {}

    /// How far the spline is from the surface: at samples alone, where that is cheaper.
    [[nodiscard]] virtual CurveDistance measure() = 0;
    /// The same of the whole spline.
    [[nodiscard]] virtual CurveDistance trace() = 0;

    /// How much finer knots would lower the energy.
    [[nodiscard]] virtual KnotDemand refinementGain() = 0;

    /// The same spline in a space with more breaks.
    virtual void insertKnots(SplineSpace finer) = 0;

    /// The spline at rest without knots that it does not need, within the tolerance. Nothing where
    /// it needs all, or that is not for this energy.
    [[nodiscard]] virtual std::optional<TracedSpline> withFewerKnots() { return std::nullopt; }

protected:
    /// A space and what belongs to it; refers to its own parts.
    struct Basis {
        Basis(const CurveProblem& problem, SplineSpace splines)
            : space(std::move(splines)), system(space, interpolationRows(space, problem.picks)) {}

        SplineSpace space;
        SplineSystem system;
    };

    Energy(const CurveProblem& problem, SplineSpace space)
        : problem_(problem), basis_(std::make_unique<Basis>(problem, std::move(space))) {}

    const CurveProblem& problem_;
    std::unique_ptr<Basis> basis_;
    EnergyWeights weights_;
    EnergyDerivatives derivatives_;
};

}  // namespace bspline_curve
