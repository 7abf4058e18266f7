// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spline_system.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// The multipliers have converged when the constraints hold to rounding, relative to the step.
constexpr double kConstraintAccuracy = 1e-15;
constexpr int kMaxMultiplierSteps = 12;

// For each control point those before it that share a span with it, ascending.
std::vector<std::vector<int>> coupledControls(const SplineSpace& space) {
    std::vector<std::vector<int>> coupled(at(space.controlCount()));
    for (int span = 0; span < space.spanCount(); ++span) {
        for (int i = 0; i < space.basisCount(); ++i) {
            for (int j = 0; j < space.basisCount(); ++j) {
                const int from = space.control(span, i);
                const int to = space.control(span, j);
                std::vector<int>& before = coupled[at(from)];
                const auto place = std::ranges::lower_bound(before, to);
                if (to < from && (place == before.end() || *place != to)) {
                    before.insert(place, to);
                }
            }
        }
    }
    return coupled;
}

}  // namespace

std::vector<InterpolationRow> interpolationRows(
    const SplineSpace& space, const std::vector<PickConstraint>& picks
) {
    std::vector<InterpolationRow> rows;
    for (const PickConstraint& pick : picks) {
        const int span = space.spanAt(pick.parameter);
        const double tau = (pick.parameter - space.breaks()[at(span)]) / space.spanLength(span);
        rows.push_back({span, space.basisAt(span, tau), pick.position});
    }
    return rows;
}

SplineSystem::SplineSystem(const SplineSpace& space, std::vector<InterpolationRow> rows)
    : space_(space), rows_(std::move(rows)) {
    const std::vector<std::vector<int>> coupled = coupledControls(space);
    makePattern(coupled);
    factor_.analyzePattern(matrix_);

    const int n = space.basisCount();
    slots_.assign(at(space.spanCount() * 9 * n * n), -1);
    int* slot = slots_.data();
    for (int span = 0; span < space.spanCount(); ++span) {
        for (int j = 0; j < n; ++j) {
            const int column = space.control(span, j);
            for (int i = 0; i < n; ++i) {
                const int row = space.control(span, i);
                if (row <= column) {
                    setSlots(coupled[at(column)], row, column, slot + 9 * n * j + 3 * i);
                }
            }
        }
        slot += 9 * static_cast<std::ptrdiff_t>(n) * n;
    }
}

// Of each column whole blocks of the control points before its own, then the upper part of that.
void SplineSystem::makePattern(const std::vector<std::vector<int>>& coupled) {
    std::vector<int> firstOfColumn{0};
    std::vector<int> rows;
    for (int c = 0; c < space_.controlCount(); ++c) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int before : coupled[at(c)]) {
                rows.insert(rows.end(), {3 * before, 3 * before + 1, 3 * before + 2});
            }
            for (int above = 0; above <= axis; ++above) {
                rows.push_back(3 * c + above);
            }
            firstOfColumn.push_back(static_cast<int>(rows.size()));
        }
    }
    matrix_.resize(3 * space_.controlCount(), 3 * space_.controlCount());
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::ranges::copy(firstOfColumn, matrix_.outerIndexPtr());
    std::ranges::copy(rows, matrix_.innerIndexPtr());
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 1.0);
}

// The nine slots of two control points; `before` are those coupled to the column's, which comes
// after all of them.
void SplineSystem::setSlots(const std::vector<int>& before, int row, int column, int* slots) const {
    const auto place = static_cast<int>(std::ranges::lower_bound(before, row) - before.begin());
    for (int b = 0; b < 3; ++b) {
        const int last = row == column ? b : 2;
        for (int a = 0; a <= last; ++a) {
            slots[3 * space_.basisCount() * b + a] =
                matrix_.outerIndexPtr()[3 * column + b] + 3 * place + a;
        }
    }
}

void SplineSystem::addBlock(int span, const SpanMatrix& block) {
    const int size = 3 * space_.basisCount();
    const int* slot = slots_.data() + static_cast<std::ptrdiff_t>(span) * size * size;
    double* values = matrix_.valuePtr();
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i, ++slot) {
            if (*slot >= 0) {
                values[*slot] += block(i, j);
            }
        }
    }
}

bool SplineSystem::factorise(const std::vector<SpanMatrix>& blocks, double fitWeight) {
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    for (int span = 0; span < space_.spanCount(); ++span) {
        addBlock(span, blocks[at(span)]);
    }
    const int size = 3 * space_.basisCount();
    for (const InterpolationRow& row : rows_) {
        SpanMatrix block = SpanMatrix::Zero(size, size);
        for (int i = 0; i < size; ++i) {
            for (int j = i % 3; j < size; j += 3) {
                block(i, j) = fitWeight * row.values[at(i / 3)] * row.values[at(j / 3)];
            }
        }
        addBlock(row.span, block);
    }
    factor_.factorize(matrix_);
    return factor_.info() == Eigen::Success;
}

Eigen::VectorXd SplineSystem::applyConstraints(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result(3 * static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        Vec3 sum = Vec3::Zero();
        for (int j = 0; j < space_.basisCount(); ++j) {
            sum += rows_[r].values[at(j)] * x.segment<3>(3 * space_.control(rows_[r].span, j));
        }
        result.segment<3>(3 * static_cast<Eigen::Index>(r)) = sum;
    }
    return result;
}

void SplineSystem::addTransposed(const Eigen::VectorXd& multipliers, Eigen::VectorXd& out) const {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        for (int j = 0; j < space_.basisCount(); ++j) {
            out.segment<3>(3 * space_.control(rows_[r].span, j)) +=
                rows_[r].values[at(j)] * multipliers.segment<3>(3 * static_cast<Eigen::Index>(r));
        }
    }
}

void SplineSystem::meetConstraints(ControlPoints& controls) const {
    const auto count = static_cast<Eigen::Index>(rows_.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, space_.controlCount());
    for (Eigen::Index r = 0; r < count; ++r) {
        const InterpolationRow& row = rows_[static_cast<std::size_t>(r)];
        for (int j = 0; j < space_.basisCount(); ++j) {
            a(r, space_.control(row.span, j)) += row.values[at(j)];
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
        step = factor_.solve(right);
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
