// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/polyline_relaxation.h"

#include "solver/sampled_solver.h"
#include "spline/band_cholesky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve::benchmarks {
namespace {

// Rounds and steps end as those of solveSampled() do, so that both get the same chance; these are
// for polylines that would not end.
constexpr double kHighestAlpha = 1e12;
constexpr int kMaxRounds = 24;
constexpr int kMaxSteps = 30;
constexpr double kRoundingEnergy = 1e-12;
constexpr int kMaxHalvings = 8;
constexpr double kSufficientDecrease = 1e-4;
constexpr std::array<double, 4> kTurningShares = {1.0, 0.5, 0.25, 0.0};

// A second difference spans so many steps.
constexpr int kBandwidth = 2;

class PolylineRelaxer {
public:
    PolylineRelaxer(const CurveProblem& problem, const InitialPath& initialPath, int count)
        : problem_(problem),
          finder_(*problem.extended, problem.patches),
          energy_(problem, count),
          factor_(energy_.count(), kBandwidth, energy_.isClosed() ? kBandwidth : 0),
          now_(energy_.along(initialPath, finder_)),
          alpha_(firstAlphaOf(problem)) {}

    RelaxedPolyline run() {
        RelaxedPolyline result;
        for (; result.rounds < kMaxRounds && alpha_ < kHighestAlpha; ++result.rounds) {
            descend(kSampled.roundDecrement, result);
            double ratio = heightRatio();
            if (ratio < kSampled.nearShare) {
                descend(kSampled.restDecrement, result);
                ratio = heightRatio();
                if (ratio < 1.0) {
                    result.isWithinTolerance = true;
                    break;
                }
            }
            alpha_ *= sampledSchedule().growth(ratio);
        }
        result.largestHeight = heightRatio();
        result.internalEnergy = energy_.terms(now_, now_.frames).internal;
        result.line = std::move(now_);
        return result;
    }

private:
    [[nodiscard]] double heightRatio() const {
        return energy_.largestHeight(now_) / problem_.distanceTolerance;
    }

    // Newton's method until a step promises less than this share of the energy.
    void descend(double least, RelaxedPolyline& result) {
        for (int step = 0; step < kMaxSteps; ++step) {
            const std::optional<Eigen::VectorXd> along = direction();
            if (!along) {
                return;
            }
            ++result.steps;
            const double total = energy_.terms(now_, now_.frames).total(alpha_);
            const double decrement = -0.5 * gradient_.dot(*along);
            if (!move(*along, total, decrement) || decrement <= least * (kRoundingEnergy + total)) {
                return;
            }
        }
    }

    [[nodiscard]] std::optional<Eigen::VectorXd> direction() {
        for (const double share : kTurningShares) {
            energy_.differentiate(now_, alpha_, share, gradient_, hessian_);
            factor_.clear();
            for (int i = 0; i < energy_.count(); ++i) {
                addRow(i);
            }
            if (factor_.factorise()) {
                return factor_.solve(-gradient_);
            }
        }
        return std::nullopt;
    }

    // Fixed vertices do not move: theirs is a row of the identity.
    void addRow(int i) {
        if (energy_.isFixed(i)) {
            gradient_.segment<3>(3 * Eigen::Index{i}).setZero();
            factor_.addSymmetric(i, i, {1.0, 0.0, 0.0, 1.0, 0.0, 1.0});
            return;
        }
        const PolylineEnergy::Blocks& blocks = hessian_[i];
        factor_.addSymmetric(i, i, blocks[0]);
        for (int steps = 1; steps <= kBandwidth; ++steps) {
            const int other = energy_.after(i, steps);
            const bool isThere = energy_.isClosed() || other > i;
            if (isThere && !energy_.isFixed(other)) {
                factor_.addSymmetric(std::max(i, other), std::min(i, other), blocks[steps]);
            }
        }
    }

    // As far as the energy falls; false where it does not.
    bool move(const Eigen::VectorXd& along, double total, double decrement) {
        for (int halving = 0; halving < kMaxHalvings; ++halving) {
            const double length = std::ldexp(1.0, -halving);
            FootedPolyline trial = now_;
            for (int i = 0; i < energy_.count(); ++i) {
                trial.points[i] += length * along.segment<3>(3 * Eigen::Index{i});
            }
            energy_.follow(finder_, trial);
            if (energy_.terms(trial, now_.frames).total(alpha_) <=
                total - kSufficientDecrease * length * 2.0 * decrement) {
                now_ = std::move(trial);
                return true;
            }
        }
        return false;
    }

    const CurveProblem& problem_;
    FibreProjector finder_;
    PolylineEnergy energy_;
    BandCholesky<3> factor_;
    FootedPolyline now_;
    double alpha_;
    Eigen::VectorXd gradient_;
    std::vector<PolylineEnergy::Blocks> hessian_;
};

}  // namespace

RelaxedPolyline relaxPolyline(
    const CurveProblem& problem, const InitialPath& initialPath, int count
) {
    return PolylineRelaxer(problem, initialPath, count).run();
}

}  // namespace bspline_curve::benchmarks
