// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spline_fit.h"

#include "solver/spline_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Weight of the bending regulariser against the squared distance, in units of the span length to
// the fourth.
constexpr double kRegularisation = 1e-5;
// Of the squared distance from the picks; multipliers do the rest.
constexpr double kConstraintWeight = 1e4;
// The multipliers have converged when the picks are met to rounding.
constexpr double kConstraintAccuracy = 1e-12;
constexpr int kMaxMultiplierSteps = 12;

using BasisMatrix = SplineSpace::BasisMatrix;

// Of the mean squared distance from the targets and the regulariser, for powers of tau in a span.
BasisMatrix powerProducts() {
    BasisMatrix moments = BasisMatrix::Zero();
    for (int i = 0; i < SpanTarget::kSamples; ++i) {
        for (int m = 0; m < kMaxBasis; ++m) {
            for (int n = 0; n < kMaxBasis; ++n) {
                moments(m, n) += std::pow(SpanTarget::tau(i), m + n) / SpanTarget::kSamples;
            }
        }
    }
    BasisMatrix second = BasisMatrix::Zero();  // derivative of powers: row m becomes m (m - 1)
    for (int m = 2; m < kMaxBasis; ++m) {
        second(m, m - 2) = m * (m - 1);
    }
    return moments + kRegularisation * (second * moments * second.transpose());
}

// The same for the basis functions of a span; its length cancels out of the regulariser's second
// derivatives by t.
BasisMatrix fitProducts(const SplineSpace& space, int span) {
    static const BasisMatrix powers = powerProducts();
    const BasisMatrix& basis = space.basis(span);
    BasisMatrix half;
    half.noalias() = basis * powers;
    BasisMatrix products;
    products.noalias() = space.spanLength(span) * half * basis.transpose();
    return products;
}

// The quadratic problem of a fit under the interpolation constraints, for all axes at once.
class Fit {
public:
    Fit(const SplineSpace& space, std::vector<InterpolationRow> rows)
        : space_(space),
          rows_(std::move(rows)),
          factor_(bandCholeskyOf<1>(space)),
          right_(ControlPoints::Zero(space.controlCount(), 3)) {}

    void addTarget(int span, const SpanTarget& target) {
        addToMatrix(span, fitProducts(space_, span));
        for (int j = 0; j < space_.basisCount(); ++j) {
            Vec3 mean = Vec3::Zero();
            for (int m = 0; m < space_.basisCount(); ++m) {
                mean += space_.basis(span)(j, m) * target.moments[m];
            }
            right_.row(space_.control(span, j)) += space_.spanLength(span) * mean.transpose();
        }
    }

    // By the method of multipliers; zero where the matrix is not positive definite.
    [[nodiscard]] ControlPoints solve() {
        for (const InterpolationRow& row : rows_) {
            BasisMatrix products = BasisMatrix::Zero();
            for (int j = 0; j < space_.basisCount(); ++j) {
                for (int k = 0; k < space_.basisCount(); ++k) {
                    products(j, k) = kConstraintWeight * row.values[j] * row.values[k];
                }
            }
            addToMatrix(row.span, products);
        }
        ControlPoints controls = ControlPoints::Zero(space_.controlCount(), 3);
        if (!factor_.factorise()) {
            return controls;
        }
        // What pulls at each pick.
        std::vector<Vec3> pulls;
        for (const InterpolationRow& row : rows_) {
            pulls.emplace_back(kConstraintWeight * row.target);
        }
        for (int step = 0; step < kMaxMultiplierSteps; ++step) {
            controls = pulledBy(pulls);
            double largest = 0.0;
            for (std::size_t r = 0; r < rows_.size(); ++r) {
                const Vec3 gap = rows_[r].target - valueAt(rows_[r], controls);
                pulls[r] += kConstraintWeight * gap;
                largest = std::max(largest, gap.lpNorm<Eigen::Infinity>());
            }
            if (largest <= kConstraintAccuracy) {
                break;
            }
        }
        return controls;
    }

private:
    void addToMatrix(int span, const BasisMatrix& products) {
        addSpan(factor_, space_, span, products.data(), products.outerStride());
    }

    [[nodiscard]] ControlPoints pulledBy(const std::vector<Vec3>& pulls) const {
        ControlPoints right = right_;
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            for (int j = 0; j < space_.basisCount(); ++j) {
                right.row(space_.control(rows_[r].span, j)) +=
                    rows_[r].values[j] * pulls[r].transpose();
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            right.col(axis) = factor_.solve(right.col(axis));
        }
        return right;
    }

    [[nodiscard]] Vec3 valueAt(const InterpolationRow& row, const ControlPoints& controls) const {
        Vec3 value = Vec3::Zero();
        for (int j = 0; j < space_.basisCount(); ++j) {
            value += row.values[j] * controls.row(space_.control(row.span, j)).transpose();
        }
        return value;
    }

    const SplineSpace& space_;
    std::vector<InterpolationRow> rows_;
    BandCholesky<1> factor_;
    ControlPoints right_;
};

}  // namespace

SpanTarget::SpanTarget(const InitialPath& initialPath, double begin, double end) {
    moments.fill(Vec3::Zero());
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 position = initialPath.positionAt(begin + tau(i) * (end - begin));
        positions[i] = position;
        double power = 1.0 / kSamples;
        for (Vec3& moment : moments) {
            moment += power * position;
            power *= tau(i);
        }
    }
}

ControlPoints fitSpline(
    const CurveProblem& problem, const SplineSpace& space, const std::vector<SpanTarget>& targets
) {
    const std::vector<InterpolationRow> rows = interpolationRows(space, problem.picks);
    Fit fit(space, rows);
    for (int span = 0; span < space.spanCount(); ++span) {
        fit.addTarget(span, targets[span]);
    }
    ControlPoints controls = fit.solve();
    // To rounding, before it is asked whether the curve stays inside.
    SplineSystem(space, rows).meetConstraints(controls);
    return controls;
}

}  // namespace bspline_curve
