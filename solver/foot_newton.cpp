// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/foot_newton.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr int kMaxHalvings = 8;
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

FootNewton::FootNewton(
    const CurveProblem& problem, SplineCurve curve, double heightUnit, int segments
)
    : space_(std::move(curve.space)),
      energy_(problem, space_, heightUnit, segments),
      system_(space_, interpolationRows(space_, problem.picks)),
      now_{
          std::move(curve.controls),
          std::vector<FootPoint>(at(energy_.sampleCount())),
          std::vector<FootFrame>(at(energy_.sampleCount())),
          {},
          {}
      } {}

std::optional<FootNewton::Step> FootNewton::step(const FootFinder& finder, double alpha) {
    Step step;
    const std::optional<Eigen::VectorXd> along = direction(alpha, step.terms);
    if (!along) {
        return std::nullopt;
    }
    step.total = energy_.total(step.terms, alpha);
    step.scale = energy_.scale(step.terms, alpha);
    step.decrement = -0.5 * gradient_.dot(*along);
    step.length = advance(finder, *along, alpha, step);
    return step;
}

std::optional<Eigen::VectorXd> FootNewton::direction(double alpha, EnergyTerms& terms) {
    for (const double share : kTurningShares) {
        terms = energy_.differentiate(now_, alpha, share, gradient_, hessian_);
        const double largest = largestDiagonal(hessian_);
        if (system_.factorise(hessian_, kConstraintWeight * largest)) {
            return system_.constrainedStep(
                gradient_, system_.residual(now_.controls), kConstraintWeight * largest
            );
        }
    }
    return std::nullopt;
}

// Moves as far as the energy falls enough; returns the share of the step taken.
double FootNewton::advance(
    const FootFinder& finder, const Eigen::VectorXd& direction, double alpha, const Step& step
) {
    const double slope = -2.0 * step.decrement;
    double length = 1.0;
    for (int halving = 0; halving < kMaxHalvings; ++halving, length *= 0.5) {
        trial_ = now_;
        Eigen::Map<Eigen::VectorXd>(trial_.controls.data(), trial_.controls.size()) +=
            length * direction;
        energy_.follow(finder, trial_);
        const double total = energy_.total(energy_.terms(trial_, now_.frames), alpha);
        if (total <= step.total + kSufficientDecrease * length * slope) {
            std::swap(now_, trial_);
            return length;
        }
    }
    return 0.0;
}

}  // namespace bspline_curve
