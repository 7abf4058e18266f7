// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_system.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace bspline_curve {

namespace {

InterpolationRow tangentRow(
    const SplineSpace& space, int span, double tau, const PickConstraint& pick
) {
    const auto degree = static_cast<double>(space.degree());
    InterpolationRow row;
    row.span = span;
    for (int j = 0; j < space.basisCount(); ++j) {
        double power = 1.0;
        for (int m = 1; m < space.basisCount(); ++m) {
            row.values[j] += m / degree * space.basis(span)(j, m) * power;
            power *= tau;
        }
    }
    row.target = pick.speed * space.spanLength(span) / degree * pick.tangent;
    return row;
}

}  // namespace

std::vector<InterpolationRow> interpolationRows(
    const SplineSpace& space, const std::vector<PickConstraint>& picks
) {
    std::vector<InterpolationRow> rows;
    for (const PickConstraint& pick : picks) {
        const int span = space.spanAt(pick.parameter);
        const double tau = (pick.parameter - space.breaks()[span]) / space.spanLength(span);
        rows.push_back({span, space.basisAt(span, tau), pick.position});
        if (pick.hasTangent()) {
            rows.push_back(tangentRow(space, span, tau, pick));
        }
    }
    return rows;
}

Eigen::VectorXd PickConstraints::apply(const Eigen::VectorXd& x) const {
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

void PickConstraints::addTransposed(const Eigen::VectorXd& pulls, Eigen::VectorXd& out) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        for (int j = 0; j < space_.basisCount(); ++j) {
            out.segment<3>(3 * space_.control(rows_[r].span, j)) +=
                rows_[r].values[j] * pulls.segment<3>(3 * static_cast<Eigen::Index>(r));
        }
    }
}

Eigen::VectorXd PickConstraints::residual(const ControlPoints& controls) const {
    Eigen::VectorXd result =
        apply(Eigen::Map<const Eigen::VectorXd>(controls.data(), controls.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        result.segment<3>(3 * static_cast<Eigen::Index>(r)) -= rows_[r].target;
    }
    return result;
}

void PickConstraints::meet(ControlPoints& controls) const {
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

bool SplineSystem::factorise(const std::vector<SpanBlocks>& blocks, double fitWeight) {
    factor_.clear();
    for (int span = 0; span < space_.spanCount(); ++span) {
        addBlocks(span, blocks[span]);
    }
    for (const InterpolationRow& row : constraints_.rows()) {
        SpanBlocks products{};
        for (int j = 0; j < space_.basisCount(); ++j) {
            for (int k = 0; k <= j; ++k) {
                const double value = fitWeight * row.values[j] * row.values[k];
                products[blockIndex(j, k)] = {value, 0.0, 0.0, value, 0.0, value};
            }
        }
        addBlocks(row.span, products);
    }
    return factor_.factorise();
}

}  // namespace bspline_curve
