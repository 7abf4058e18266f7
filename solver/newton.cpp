// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/newton.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bspline_curve {
namespace {

struct NewtonConstants {
    /// Armijo's constant: the energy must fall by this share of what the slope promises.
    double sufficientDecrease = 1e-4;
    /// A^T A enters with this many times the largest diagonal entry: two solves meet the picks.
    double constraintWeight = 1e3;
    /// A whole step was too short if the energy then still falls by this share of the first slope.
    double steepShare = 0.5;
};

constexpr NewtonConstants kNewton;

double largestDiagonal(const std::vector<SpanBlocks>& hessian) {
    double largest = 0.0;
    for (const SpanBlocks& blocks : hessian) {
        for (std::size_t j = 0, diagonal = 0; diagonal < blocks.size(); ++j, diagonal += j + 1) {
            const SymmetricMatrix& block = blocks[diagonal];
            largest = std::max({largest, block[0], block[3], block[5]});
        }
    }
    return largest;
}

void growDiagonal(double ridge, std::vector<SpanBlocks>& hessian) {
    for (SpanBlocks& blocks : hessian) {
        for (std::size_t j = 0, diagonal = 0; diagonal < blocks.size(); ++j, diagonal += j + 1) {
            for (const std::size_t entry : {0, 3, 5}) {
                blocks[diagonal][entry] *= 1.0 + ridge;
            }
        }
    }
}

// Nothing where the matrix is not positive definite.
std::optional<Eigen::VectorXd> solveWith(
    const std::vector<SpanBlocks>& hessian, Interpolation interpolation, Energy& energy
) {
    const Eigen::VectorXd& gradient = energy.derivatives().gradient;
    const bool isConstrained = interpolation == Interpolation::Constraint;
    const double weight =
        isConstrained ? kNewton.constraintWeight * largestDiagonal(energy.derivatives().hessian)
                      : 0.0;
    SplineSystem& system = energy.system();
    if (!system.factorise(hessian, weight)) {
        return std::nullopt;
    }
    return isConstrained ? system.constrainedStep(
                               gradient, energy.picks().residual(energy.controls()), weight
                           )
                         : system.solve(-gradient);
}

class Minimiser {
public:
    Minimiser(
        Energy& energy,
        Interpolation interpolation,
        const NewtonPolicy& policy,
        const NewtonGoal& goal
    )
        : energy_(energy), interpolation_(interpolation), policy_(policy), goal_(goal) {}

    MinimiseResult run() {
        result_.value = energy_.differentiate();
        if (!result_.value.inside) {
            result_.status = MinimiseStatus::Outside;
            return std::move(result_);
        }
        for (int iteration = 0; iteration < goal_.mostIterations; ++iteration) {
            if (iteration > 0) {
                if (isOverBudget(energy_, policy_)) {
                    break;
                }
                result_.value = energy_.differentiate();
            }
            if (std::optional<MinimiseStatus> end = iterate()) {
                result_.status = *end;
                break;
            }
        }
        return std::move(result_);
    }

private:
    // One step; where it is the last one, why.
    std::optional<MinimiseStatus> iterate() {
        std::optional<NewtonStep> step = newtonStep(energy_, interpolation_, policy_);
        if (!step) {
            return MinimiseStatus::NotPositive;
        }
        IterationReport entry;
        entry.total = result_.value.total;
        entry.terms = result_.value.terms;
        entry.decrement = -0.5 * slopeAlong(step->direction);
        const double least = goal_.decrement * result_.value.scale;
        if (policy_.takesLastStep || entry.decrement > least) {
            if (!takeStep(*step, entry)) {
                return MinimiseStatus::NotPositive;
            }
        }
        totals_.push_back(entry.total);
        result_.iterations.push_back(entry);
        const double promisedBefore = std::exchange(promised_, promiseOf(entry));
        if (promised_ <= least) {
            return MinimiseStatus::Converged;
        }
        if (entry.step == 0.0 || fallOfStep() < goal_.keptPromise * promisedBefore ||
            (goal_.gainlessSteps > 0 && fallOfLast() < least)) {
            return MinimiseStatus::LineSearchStalled;
        }
        return std::nullopt;
    }

    [[nodiscard]] double slopeAlong(const Eigen::VectorXd& direction) const {
        return energy_.derivatives().gradient.dot(direction);
    }

    // Damps what fails, then shortens it; sets how far it went. False where the damped Hessian is
    // not positive definite.
    bool takeStep(NewtonStep& step, IterationReport& entry) {
        double length = 1.0;
        for (int damped = 0; damped < policy_.mostDampings; ++damped) {
            entry.step = 1.0;
            if (tryStep(step.direction, 1.0, entry)) {
                return true;
            }
            if (!energy_.dampModelErrors()) {
                length = 0.5;  // the whole of it has just failed
                break;
            }
            std::optional<Eigen::VectorXd> along =
                solveWith(energy_.hessian(step.negativeShare), interpolation_, energy_);
            if (!along) {
                return false;
            }
            step.direction = std::move(*along);
        }
        for (; length >= goal_.leastStep; length *= 0.5) {
            if (tryStep(step.direction, length, entry)) {
                if (length == 1.0 && step.isTooShort) {
                    lengthen(step.direction, entry);
                }
                return true;
            }
        }
        entry.step = 0.0;
        return true;
    }

    // Moves there if the energy falls enough.
    bool tryStep(const Eigen::VectorXd& direction, double length, IterationReport& entry) {
        const double slope = slopeAlong(direction);
        entry.decrement = -0.5 * slope;
        entry.step = length;
        return moveTo(direction, length, slope);
    }

    bool moveTo(const Eigen::VectorXd& direction, double length, double slope) {
        const EnergyValue tried = energy_.tryStep(direction, length);
        const bool falls =
            tried.inside &&
            tried.total <= result_.value.total + kNewton.sufficientDecrease * length * slope;
        if (falls) {
            energy_.acceptStep();
            result_.value = tried;
        }
        return falls;
    }

    // Where the energy still falls steeply at the end of a whole step, goes on along it: twice as
    // far each time, while that lowers the energy.
    void lengthen(const Eigen::VectorXd& direction, IterationReport& entry) {
        const double slope = -2.0 * entry.decrement;
        while (entry.step < policy_.longestStep) {
            result_.value = energy_.differentiate();
            if (slopeAlong(direction) >= kNewton.steepShare * slope ||
                !moveTo(direction, entry.step, slope)) {
                break;
            }
            entry.step *= 2.0;
        }
    }

    // What a step gains by its promise: a short one not all of that.
    [[nodiscard]] double promiseOf(const IterationReport& entry) const {
        const bool isShort = policy_.hasShortSteps && entry.step > 0.0;
        return entry.decrement * (isShort ? entry.step * (2.0 - entry.step) : 1.0);
    }

    // By how much the step before has brought the energy down; infinite where that is not asked.
    [[nodiscard]] double fallOfStep() const {
        return goal_.keptPromise == 0.0 || totals_.size() < 2
                   ? std::numeric_limits<double>::infinity()
                   : totals_.end()[-2] - totals_.back();
    }

    // By how much the last steps have brought the energy below all before; infinite after few.
    [[nodiscard]] double fallOfLast() const {
        if (totals_.size() <= static_cast<std::size_t>(goal_.gainlessSteps)) {
            return std::numeric_limits<double>::infinity();
        }
        const auto last = totals_.end() - goal_.gainlessSteps;
        return *std::min_element(totals_.begin(), last) - *std::min_element(last, totals_.end());
    }

    Energy& energy_;
    Interpolation interpolation_;
    const NewtonPolicy& policy_;
    const NewtonGoal& goal_;
    MinimiseResult result_;
    std::vector<double> totals_;  // before each step
    double promised_ = 0.0;       // by the last step
};

}  // namespace

bool isOverBudget(const Energy& energy, const NewtonPolicy& policy) {
    return static_cast<double>(energy.work()) > policy.mostWork;
}

std::optional<NewtonStep> newtonStep(
    Energy& energy, Interpolation interpolation, const NewtonPolicy& policy
) {
    for (const double share : policy.negativeShares) {
        if (std::optional<Eigen::VectorXd> along =
                solveWith(energy.hessian(share), interpolation, energy)) {
            return NewtonStep{std::move(*along), share, share < 1.0};
        }
    }
    if (policy.ridges.empty()) {
        return std::nullopt;
    }
    std::vector<SpanBlocks> ridged = energy.hessian(0.0);
    for (const double ridge : policy.ridges) {
        growDiagonal(ridge, ridged);
        if (std::optional<Eigen::VectorXd> along = solveWith(ridged, interpolation, energy)) {
            return NewtonStep{std::move(*along), 0.0, true};
        }
    }
    return std::nullopt;
}

MinimiseResult minimise(
    Energy& energy,
    const EnergyWeights& weights,
    Interpolation interpolation,
    const NewtonPolicy& policy,
    const NewtonGoal& goal
) {
    energy.setWeights(weights);
    return Minimiser(energy, interpolation, policy, goal).run();
}

}  // namespace bspline_curve
