// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spline_system.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

// The multipliers have converged when the constraints hold to rounding, relative to the step.
constexpr double kConstraintAccuracy = 1e-12;
constexpr int kMaxMultiplierSteps = 12;

}  // namespace

std::vector<InterpolationRow> interpolationRows(
    const SplineSpace& space, const std::vector<PickConstraint>& picks
) {
    std::vector<InterpolationRow> rows;
    for (const PickConstraint& pick : picks) {
        const int span = space.spanAt(pick.parameter);
        const double tau = (pick.parameter - space.breaks()[span]) / space.spanLength(span);
        rows.push_back({span, space.basisAt(span, tau), pick.position});
    }
    return rows;
}

SplineSystem::SplineSystem(const SplineSpace& space, std::vector<InterpolationRow> rows)
    : space_(space), rows_(std::move(rows)), factor_(bandCholeskyOf<3>(space)) {}

void SplineSystem::addBlocks(int span, const SpanBlocks& blocks) {
    std::size_t block = 0;
    for (int j = 0; j < space_.basisCount(); ++j) {
        const int row = space_.control(span, j);
        for (int k = 0; k <= j; ++k, ++block) {
            const int column = space_.control(span, k);
            factor_.addSymmetric(std::max(row, column), std::min(row, column), blocks[block]);
        }
    }
}

bool SplineSystem::factorise(const std::vector<SpanMatrix>& blocks, double fitWeight) {
    factor_.clear();
    for (int span = 0; span < space_.spanCount(); ++span) {
        const SpanMatrix& block = blocks[span];
        addSpan(factor_, space_, span, block.data(), block.outerStride());
    }
    return factoriseWithRows(fitWeight);
}

bool SplineSystem::factorise(const std::vector<SpanBlocks>& blocks, double fitWeight) {
    factor_.clear();
    for (int span = 0; span < space_.spanCount(); ++span) {
        addBlocks(span, blocks[span]);
    }
    return factoriseWithRows(fitWeight);
}

bool SplineSystem::factoriseWithRows(double fitWeight) {
    for (const InterpolationRow& row : rows_) {
        SpanBlocks blocks{};
        std::size_t block = 0;
        for (int j = 0; j < space_.basisCount(); ++j) {
            for (int k = 0; k <= j; ++k, ++block) {
                const double value = fitWeight * row.values[j] * row.values[k];
                blocks[block] = {value, 0.0, 0.0, value, 0.0, value};
            }
        }
        addBlocks(row.span, blocks);
    }
    return factor_.factorise();
}

Eigen::VectorXd SplineSystem::applyConstraints(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result(3 * static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        Vec3 sum = Vec3::Zero();
        for (int j = 0; j < space_.basisCount(); ++j) {
            sum += rows_[r].values[j] * x.segment<3>(3 * space_.control(rows_[r].span, j));
        }
        result.segment<3>(3 * static_cast<Eigen::Index>(r)) = sum;
    }
    return result;
}

void SplineSystem::addTransposed(const Eigen::VectorXd& multipliers, Eigen::VectorXd& out) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        for (int j = 0; j < space_.basisCount(); ++j) {
            out.segment<3>(3 * space_.control(rows_[r].span, j)) +=
                rows_[r].values[j] * multipliers.segment<3>(3 * static_cast<Eigen::Index>(r));
        }
    }
}

void SplineSystem::meetConstraints(ControlPoints& controls) const {
    const auto count = static_cast<Eigen::Index>(rows_.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, space_.controlCount());
    for (Eigen::Index r = 0; r < count; ++r) {
        const InterpolationRow& row = rows_[r];
        for (int j = 0; j < space_.basisCount(); ++j) {
            a(r, space_.control(row.span, j)) += row.values[j];
        }
    }
    const Eigen::VectorXd flat = residual(controls);
    const Eigen::Map<const ControlPoints> gaps(flat.data(), count, 3);
    controls -= a.transpose() * (a * a.transpose()).ldlt().solve(gaps);
}

Eigen::VectorXd SplineSystem::residual(const ControlPoints& controls) const {
    Eigen::VectorXd result =
        applyConstraints(Eigen::Map<const Eigen::VectorXd>(controls.data(), controls.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        result.segment<3>(3 * static_cast<Eigen::Index>(r)) -= rows_[r].target;
    }
    return result;
}

Eigen::VectorXd SplineSystem::constrainedStep(
    const Eigen::VectorXd& gradient, const Eigen::VectorXd& residual, double fitWeight
) const {
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(residual.size());
    Eigen::VectorXd step;
    for (int i = 0; i < kMaxMultiplierSteps; ++i) {
        Eigen::VectorXd right = -gradient;
        addTransposed(-multipliers - fitWeight * residual, right);
        step = factor_.solve(std::move(right));
        const Eigen::VectorXd violation = applyConstraints(step) + residual;
        multipliers += fitWeight * violation;
        if (violation.lpNorm<Eigen::Infinity>() <=
            kConstraintAccuracy * std::max(1.0, step.lpNorm<Eigen::Infinity>())) {
            break;
        }
    }
    return step;
}

}  // namespace bspline_curve
