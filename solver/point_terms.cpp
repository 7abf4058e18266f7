// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/point_terms.h"

#include "solver/barrier.h"
#include "solver/field_cost.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// The field I(M_S(p)) in a cell.
AffineForm fieldForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.base->faces[at(cell.prism)];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const double value = problem.field[at(face[corner])];
        form.gradient += value * cell.shadowGradients[corner];
        form.offset += value * cell.shadowOffsets[corner];
    }
    return form;
}

// How far p lies beyond the boundary in a ghost cell: 0 at the boundary, 1 at the outer rim.
AffineForm beyondForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.base->faces[at(cell.prism)];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (face[corner] >= problem.base->surfaceVertexCount) {
            form.gradient += cell.shadowGradients[corner];
            form.offset += cell.shadowOffsets[corner];
        }
    }
    return form;
}

}  // namespace

double fieldWeight(const CurveProblem& problem) {
    return problem.field.empty() ? 0.0 : problem.options.fieldWeight;
}

CellIntegrand::CellIntegrand(
    const CurveProblem& problem,
    const EnergyWeights& weights,
    const ShellCell& cell,
    double heightScale
)
    : weights_(weights),
      mu_(fieldWeight(problem)),
      cost_(problem.options.fieldCost),
      height_{heightScale * cell.heightGradient, heightScale * cell.heightOffset},
      hasBeyond_(problem.shell->isGhost(cell.prism)) {
    if (hasBeyond_) {
        beyond_ = beyondForm(problem, cell);
    }
    if (mu_ > 0.0) {
        field_ = fieldForm(problem, cell);
    }
}

bool CellIntegrand::add(const Vec3& p, double weight, EnergyTerms& terms) const {
    const double height = height_.at(p);
    if (std::abs(height) >= weights_.barrierWidth) {
        return false;
    }
    terms.distance += weight * barrierValue(height, weights_.barrierWidth);
    if (hasBeyond_) {
        const double beyond = beyond_.at(p);
        if (beyond >= 1.0) {
            return false;
        }
        terms.distance += weight * barrierValue(beyond, 1.0);
    }
    if (mu_ > 0.0) {
        terms.external += weight * fieldCost(cost_, field_.at(p)).value;
    }
    return true;
}

bool CellIntegrand::add(
    const Vec3& p,
    double weight,
    EnergyTerms& terms,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisValues& basis,
    Eigen::VectorXd& gradient
) {
    Vec3 force = Vec3::Zero();
    const auto addBarrier = [&](const AffineForm& form, double width, BasisProducts& products) {
        const double x = form.at(p);
        if (std::abs(x) >= width) {
            return false;
        }
        const Barrier g = barrier(x, width);
        terms.distance += weight * g.value;
        force += weight * weights_.alpha * g.slope * form.gradient;
        products.add(basis, weight * weights_.alpha * g.curvature, space.basisCount());
        return true;
    };
    if (!addBarrier(height_, weights_.barrierWidth, heightProducts_) ||
        (hasBeyond_ && !addBarrier(beyond_, 1.0, beyondProducts_))) {
        return false;
    }
    if (mu_ > 0.0) {
        const FieldCostValue c = fieldCost(cost_, field_.at(p));
        terms.external += weight * c.value;
        force += weight * mu_ * c.slope * field_.gradient;
        fieldProducts_.add(basis, weight * mu_ * std::max(0.0, c.curvature), space.basisCount());
    }
    addGradient(gradient, space, span, basis, force);
    return true;
}

void CellIntegrand::flush(SpanMatrix& hessian, int basisCount) const {
    heightProducts_.addTo(hessian, height_.gradient, basisCount);
    if (hasBeyond_) {
        beyondProducts_.addTo(hessian, beyond_.gradient, basisCount);
    }
    if (mu_ > 0.0) {
        fieldProducts_.addTo(hessian, field_.gradient, basisCount);
    }
}

Vec3 CellIntegrand::gradient(const Vec3& p) const {
    Vec3 sum = Vec3::Zero();
    const double height = height_.at(p);
    if (std::abs(height) < weights_.barrierWidth) {
        sum += weights_.alpha * barrier(height, weights_.barrierWidth).slope * height_.gradient;
    }
    if (hasBeyond_ && beyond_.at(p) < 1.0) {
        sum += weights_.alpha * barrier(beyond_.at(p), 1.0).slope * beyond_.gradient;
    }
    if (mu_ > 0.0) {
        sum += mu_ * fieldCost(cost_, field_.at(p)).slope * field_.gradient;
    }
    return sum;
}

}  // namespace bspline_curve
