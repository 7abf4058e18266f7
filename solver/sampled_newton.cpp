// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_newton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// A step that does not lower the energy is damped so often, and then shortened. Curves under a
// field may have far to go down gentle slopes, for which damped steps are too short.
constexpr int kMaxDampings = 4;
constexpr int kMaxHalvings = 8;
// Spans are damped that have more than this share of all energy that was not foreseen.
constexpr double kLeastModelError = 0.01;
// Where that was not enough the damping grows by this at least.
constexpr double kDampingGrowth = 2.0;
// And this share of it stays for the next step.
constexpr double kDampingKept = 0.25;
constexpr double kSufficientDecrease = 1e-4;
// Share of the surface's bending that is tried in turn until the Hessian is positive.
constexpr std::array<double, 4> kTurningShares = {1.0, 0.5, 0.25, 0.0};
// As in newtonStep().
constexpr double kConstraintWeight = 1e3;

double largestDiagonal(const std::vector<SpanBlocks>& blocksOfSpans) {
    double largest = 0.0;
    for (const SpanBlocks& blocks : blocksOfSpans) {
        for (std::size_t j = 0, diagonal = 0; diagonal < blocks.size(); ++j, diagonal += j + 1) {
            const SymmetricMatrix& block = blocks[diagonal];
            largest = std::max({largest, block[0], block[3], block[5]});
        }
    }
    return largest;
}

}  // namespace

SampledNewton::SampledNewton(
    const CurveProblem& problem, SplineCurve curve, double heightUnit, int segments
)
    : space_(std::move(curve.space)),
      energy_(problem, space_, heightUnit, segments),
      system_(space_, interpolationRows(space_, problem.picks)),
      now_{
          std::move(curve.controls),
          std::vector<FootPoint>(energy_.sampleCount()),
          std::vector<FootFrame>(energy_.sampleCount()),
          {},
          {}
      },
      damping_(space_.spanCount(), 0.0) {}

std::optional<SampledNewton::Step> SampledNewton::step(const FibreProjector& finder, double alpha) {
    for (double& damping : damping_) {
        damping *= kDampingKept;
    }
    Step step{};
    std::optional<Eigen::VectorXd> along = direction(alpha, step.terms);
    step.total = energy_.total(step.terms, alpha);
    step.scale = energy_.scale(step.terms, alpha);
    const int mostDampings = energy_.hasField() ? 0 : kMaxDampings;
    int halving = 0;
    for (int damped = 0; along && damped < mostDampings; ++damped) {
        if (tryStep(finder, *along, alpha, 1.0, step)) {
            return step;
        }
        if (!dampModelErrors(alpha)) {
            halving = 1;  // the whole of it has just failed
            break;
        }
        along = factorisedDirection();
    }
    if (!along) {
        return std::nullopt;
    }
    for (; halving < kMaxHalvings; ++halving) {
        if (tryStep(finder, *along, alpha, std::ldexp(1.0, -halving), step)) {
            return step;
        }
    }
    step.length = 0.0;
    return step;
}

std::optional<Eigen::VectorXd> SampledNewton::direction(double alpha, EnergyTerms& terms) {
    for (const double share : kTurningShares) {
        terms = energy_.differentiate(now_, alpha, share, gradient_, hessian_);
        energy_.addDamping(damping_, hessian_);
        if (std::optional<Eigen::VectorXd> along = factorisedDirection()) {
            return along;
        }
    }
    return std::nullopt;
}

std::optional<Eigen::VectorXd> SampledNewton::factorisedDirection() {
    const double fitWeight = kConstraintWeight * largestDiagonal(hessian_);
    if (!system_.factorise(hessian_, fitWeight)) {
        return std::nullopt;
    }
    return system_.constrainedStep(gradient_, system_.residual(now_.controls), fitWeight);
}

// Moves there if the energy falls enough.
bool SampledNewton::tryStep(
    const FibreProjector& finder,
    const Eigen::VectorXd& direction,
    double alpha,
    double length,
    Step& step
) {
    step.decrement = -0.5 * gradient_.dot(direction);
    step.length = length;
    trial_ = now_;
    Eigen::Map<Eigen::VectorXd>(trial_.controls.data(), trial_.controls.size()) +=
        length * direction;
    energy_.follow(finder, trial_);
    const double total = energy_.total(energy_.terms(trial_, now_.frames), alpha);
    const bool falls = total <= step.total - kSufficientDecrease * length * 2.0 * step.decrement;
    if (falls) {
        std::swap(now_, trial_);
    }
    return falls;
}

// Damps spans so that the model has the energy of the trial there. What was not foreseen grows
// with the square of the way, as where samples pass kinks of the surface heights grow with it.
// False where nothing has more energy than foreseen.
bool SampledNewton::dampModelErrors(double alpha) {
    const std::vector<SampledEnergy::ModelError> modelErrors =
        energy_.modelErrors(now_, trial_, alpha);
    double all = 0.0;
    for (const SampledEnergy::ModelError& modelError : modelErrors) {
        all += std::max(0.0, modelError.energy);
    }
    std::vector<double> more(modelErrors.size(), 0.0);
    for (std::size_t span = 0; span < modelErrors.size(); ++span) {
        const SampledEnergy::ModelError& modelError = modelErrors[span];
        if (modelError.squaredWay > 0.0 && modelError.energy > kLeastModelError * all) {
            const double needed = std::max(
                kDampingGrowth * damping_[span], modelError.energy / modelError.squaredWay
            );
            more[span] = needed - damping_[span];
            damping_[span] = needed;
        }
    }
    energy_.addDamping(more, hessian_);
    return all > 0.0;
}

}  // namespace bspline_curve
