// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/newton.h"
#include "solver/sample_rule.h"
#include "solver/spline_term.h"

#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve {

/// What a variant of the method does otherwise in the rounds of one solve(). This one does nothing.
class RoundVariant {
public:
    RoundVariant() = default;
    RoundVariant(const RoundVariant&) = delete;
    RoundVariant& operator=(const RoundVariant&) = delete;
    virtual ~RoundVariant() = default;

    /// Weights of the first round. `largestHeight`: of the first curve as traced, 1 where it leaves
    /// the shell.
    virtual void adjustFirst(
        Energy& /*energy*/, double /*largestHeight*/, EnergyWeights& /*first*/
    ) const {}

    /// Weights of the next round, from those and the terms of the round before.
    virtual void adjustNext(
        const EnergyWeights& /*before*/, const EnergyTerms& /*terms*/, EnergyWeights& /*next*/
    ) const {}

    /// The barrier for the curve as it is.
    virtual void setBarrier(
        const Energy& /*energy*/, double /*largestHeight*/, EnergyWeights& /*weights*/
    ) const {}

    /// Breaks of the next round; nothing: those by Energy::refinementGain(). `scale`: of the
    /// energy.
    [[nodiscard]] virtual std::optional<std::vector<double>> chooseBreaks(
        const Energy& /*energy*/,
        const EnergyWeights& /*weights*/,
        double /*scale*/,
        bool /*isNear*/
    ) {
        return std::nullopt;
    }

    /// Whether the curve is near enough to the picks to stop.
    [[nodiscard]] virtual bool arePicksNear(const Energy& /*energy*/) const { return true; }

    /// Moves the curve to the picks where it does not pass them. Returns how far that moves the
    /// farthest control point.
    virtual double meetPicks(Energy& /*energy*/, const NewtonPolicy& /*policy*/) const {
        return 0.0;
    }
};

/// Other ways to do what the solver does, which plug themselves in by CurveProblem::variant. This
/// one is the solver's own; the paper's is in solver/paper/paper_variant.h.
class SolveVariant {
public:
    SolveVariant() = default;
    SolveVariant(const SolveVariant&) = delete;
    SolveVariant& operator=(const SolveVariant&) = delete;
    virtual ~SolveVariant() = default;

    /// See makeFirstCurve().
    [[nodiscard]] virtual std::optional<SplineCurve> firstCurve(
        const CurveProblem& problem, const InitialPath& initialPath
    ) const;

    /// E_int with all bending of each span, as ambientProducts() has it.
    [[nodiscard]] virtual std::vector<SplineSpace::BasisMatrix> bendingProducts(
        const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule
    ) const;

    /// Terms besides those of the solver. They may refer to all three.
    [[nodiscard]] virtual std::vector<std::unique_ptr<SplineTerm>> moreTerms(
        const CurveProblem& problem,
        const SplineSpace& space,
        const std::vector<InterpolationRow>& rows
    ) const;

    [[nodiscard]] virtual std::unique_ptr<RoundVariant> rounds(const CurveProblem& problem) const;
};

/// Whether options ask for what only a variant has.
[[nodiscard]] bool needsVariant(const SolverOptions& options);

/// That of a problem, or the solver's own. Throws std::logic_error where there is none and the
/// options need one.
[[nodiscard]] const SolveVariant& variantOf(const CurveProblem& problem);

}  // namespace bspline_curve
