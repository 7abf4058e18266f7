// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/band_cholesky.h"
#include "spline/pick_constraint.h"
#include "spline/span_blocks.h"

#include <algorithm>
#include <vector>

namespace bspline_curve {

/// One row of the interpolation constraints: sum_j values[j] * control(span, j) = target. A pick
/// has one for its position and, where it has a tangent, one for the derivative, in units of the
/// span over the degree, which are those of the control points.
struct InterpolationRow {
    int span = 0;
    SplineSpace::BasisValues values{};
    Vec3 target;
};

[[nodiscard]] std::vector<InterpolationRow> interpolationRows(
    const SplineSpace& space, const std::vector<PickConstraint>& picks
);

/// The interpolation constraints A x = target on the control points x of a spline.
class PickConstraints {
public:
    PickConstraints(const SplineSpace& space, std::vector<InterpolationRow> rows)
        : space_(space), rows_(std::move(rows)) {}

    [[nodiscard]] const std::vector<InterpolationRow>& rows() const { return rows_; }

    /// A x.
    [[nodiscard]] Eigen::VectorXd apply(const Eigen::VectorXd& x) const;
    /// out += A^T pulls.
    void addTransposed(const Eigen::VectorXd& pulls, Eigen::VectorXd& out) const;
    /// A x - target.
    [[nodiscard]] Eigen::VectorXd residual(const ControlPoints& controls) const;

    /// Moves the control points as little as possible so that the constraints hold to rounding.
    void meet(ControlPoints& controls) const;

    /// The x that minimises x^T H x / 2 - right^T x under A x = -residual, by the method of
    /// multipliers: two or three solves. `solve`: of a system with H + weight A^T A.
    template <class Solve>
    [[nodiscard]] Eigen::VectorXd minimiser(
        const Eigen::VectorXd& right,
        const Eigen::VectorXd& residual,
        double weight,
        const Solve& solve
    ) const {
        Eigen::VectorXd pulls = -weight * residual;
        Eigen::VectorXd x;
        for (int i = 0; i < kMaxSolves; ++i) {
            Eigen::VectorXd pulled = right;
            addTransposed(pulls, pulled);
            x = solve(std::move(pulled));
            const Eigen::VectorXd violation = apply(x) + residual;
            if (violation.lpNorm<Eigen::Infinity>() <=
                kAccuracy * std::max(1.0, x.lpNorm<Eigen::Infinity>())) {
                break;
            }
            pulls -= weight * violation;
        }
        return x;
    }

private:
    static constexpr double kAccuracy = 1e-12;  // of A x, relative to x or to 1: rounding
    static constexpr int kMaxSolves = 12;       // where rounding keeps A x from being that accurate

    const SplineSpace& space_;
    std::vector<InterpolationRow> rows_;
};

/// A factor for matrices over the control points of a spline: banded, and cyclic when closed, so
/// that the last control points border on all.
template <int kUnknowns>
[[nodiscard]] BandCholesky<kUnknowns> bandCholeskyOf(const SplineSpace& space) {
    const int controls = space.controlCount();
    return {controls, space.degree(), space.closed() ? std::min(space.degree(), controls) : 0};
}

/// The Newton system of a spline: a matrix over its control points, and the interpolation
/// constraints.
class SplineSystem {
public:
    SplineSystem(const SplineSpace& space, std::vector<InterpolationRow> rows)
        : space_(space), constraints_(space, std::move(rows)), factor_(bandCholeskyOf<3>(space)) {}

    [[nodiscard]] const PickConstraints& constraints() const { return constraints_; }

    /// Sums span blocks into the matrix and factorises it, after adding `fitWeight` A^T A. False
    /// where the result is not positive definite.
    [[nodiscard]] bool factorise(const std::vector<SpanBlocks>& blocks, double fitWeight);

    /// Solution of the factorised system.
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const {
        return factor_.solve(std::move(right));
    }

    /// The step d that minimises d^T H d / 2 + gradient^T d under A d = -residual, with the
    /// factorised H + fitWeight A^T A.
    [[nodiscard]] Eigen::VectorXd constrainedStep(
        const Eigen::VectorXd& gradient, const Eigen::VectorXd& residual, double fitWeight
    ) const {
        return constraints_.minimiser(-gradient, residual, fitWeight, [&](Eigen::VectorXd&& right) {
            return factor_.solve(std::move(right));
        });
    }

private:
    void addBlocks(int span, const SpanBlocks& blocks);

    const SplineSpace& space_;
    PickConstraints constraints_;
    BandCholesky<3> factor_;
};

}  // namespace bspline_curve
