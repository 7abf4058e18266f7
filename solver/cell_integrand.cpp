// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cell_integrand.h"

#include "solver/barrier.h"
#include "solver/field_cost.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

// Crossings of edges that end on what is avoided may be as close as this: rounding.
constexpr double kClosestKink = 1.0 - 1e-12;

// The field I(M_S(p)) in a cell.
AffineForm fieldForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.extended->faces[cell.face];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const double value = problem.field[face[corner]];
        form += value * cell.shadowForm(corner);
    }
    return form;
}

// How far p lies beyond the boundary in a ghost cell: 0 at the boundary, 1 at the outer rim.
AffineForm beyondForm(const CurveProblem& problem, const ShellCell& cell) {
    AffineForm form;
    const Triangle& face = problem.extended->faces[cell.face];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (face[corner] >= problem.extended->surfaceVertexCount) {
            form += cell.shadowForm(corner);
        }
    }
    return form;
}

}  // namespace

CellIntegrand::CellIntegrand(
    const CurveProblem& problem,
    const EnergyWeights& weights,
    const ShellCell& cell,
    double heightScale
)
    : weights_(weights),
      mu_(fieldWeight(problem)),
      cost_(problem.options.fieldCost),
      height_(cell.height),
      heightScale_(heightScale),
      hasSurfaceHeight_(!problem.shell->isFullResolution()),
      hasBeyond_(problem.shell->isGhost(cell.face)),
      isLinear_(problem.options.relativeHeight == RelativeHeight::Linear) {
    if (hasSurfaceHeight_) {
        surfaceHeight_ = cell.surfaceHeight;
    }
    if (hasBeyond_) {
        beyond_ = beyondForm(problem, cell);
    }
    if (mu_ > 0.0) {
        field_ = fieldForm(problem, cell);
    }
    if (problem.obstacles != nullptr) {
        isAvoided_ = problem.obstacles->isAvoided(cell.face);
        hasCloseness_ = !isAvoided_ && !problem.obstacles->isFar(cell.face);
        if (hasCloseness_) {
            closeness_ = ClosenessForm(*problem.obstacles, *problem.extended, cell);
        }
    }
}

CellIntegrand::HeightValue CellIntegrand::relativeHeightAt(const Vec3& p) const {
    HeightValue result;
    const double w = height_.at(p);
    result.byHeight = heightScale_;
    if (!hasSurfaceHeight_) {
        result.value = heightScale_ * w;
        return result;
    }
    // d = (w - v) / (1 - w v) with v the height of the surface.
    const double v = surfaceHeight_.at(p);
    if (isLinear_) {
        return linearHeightAt(w, v);
    }
    const double inverse = 1.0 / (1.0 - w * v);
    const double square = heightScale_ * inverse * inverse;
    const double byHeight = (1.0 - v * v) * square;
    const double bySurface = -(1.0 - w * w) * square;
    result.value = heightScale_ * (w - v) * inverse;
    result.byHeight = byHeight;
    result.bySurface = bySurface;
    result.byHeightTwice = 2.0 * v * inverse * byHeight;
    result.byBoth = 2.0 * (w - v) * inverse * square;
    result.bySurfaceTwice = 2.0 * w * inverse * bySurface;
    return result;
}

// (10), negative below the surface; its first derivatives jump there, but those of the even barrier
// vanish.
CellIntegrand::HeightValue CellIntegrand::linearHeightAt(double w, double v) const {
    const double side = w >= v ? 1.0 : -1.0;
    const double inverse = 1.0 / (1.0 - side * v);
    const double square = heightScale_ * inverse * inverse;
    HeightValue result;
    result.value = heightScale_ * (w - v) * inverse;
    result.byHeight = heightScale_ * inverse;
    result.bySurface = -(1.0 - side * w) * square;
    result.byBoth = side * square;
    result.bySurfaceTwice = 2.0 * side * inverse * result.bySurface;
    return result;
}

bool CellIntegrand::add(const Vec3& p, double weight, EnergyTerms& terms) const {
    const double height = relativeHeightAt(p).value;
    if (isAvoided_ || std::abs(height) >= weights_.barrierWidth) {
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
    if (hasCloseness_) {
        const double closeness = closeness_.at(p);
        if (closeness >= 1.0) {
            return false;
        }
        terms.avoidance += weight * avoidanceBarrier(closeness).value;
    }
    return true;
}

bool CellIntegrand::add(
    const Vec3& p, double weight, EnergyTerms& terms, PointDerivatives& derivatives
) const {
    const HeightValue d = relativeHeightAt(p);
    if (isAvoided_ || std::abs(d.value) >= weights_.barrierWidth) {
        return false;
    }
    const Barrier g = barrier(d.value, weights_.barrierWidth);
    const double slope = weight * weights_.alpha * g.slope;
    const double curvature = weight * weights_.alpha * g.curvature;
    terms.distance += weight * g.value;
    const Vec3& byP = height_.gradient;
    derivatives.force += slope * d.byHeight * byP;
    derivatives.addRankOne(byP, curvature * d.byHeight * d.byHeight + slope * d.byHeightTwice);
    if (hasSurfaceHeight_) {
        const Vec3& surfaceByP = surfaceHeight_.gradient;
        derivatives.force += slope * d.bySurface * surfaceByP;
        derivatives.addRankOne(
            surfaceByP, curvature * d.bySurface * d.bySurface + slope * d.bySurfaceTwice
        );
        derivatives.addProduct(
            byP, surfaceByP, curvature * d.byHeight * d.bySurface + slope * d.byBoth
        );
    }
    if (hasBeyond_) {
        const double beyond = beyond_.at(p);
        if (std::abs(beyond) >= 1.0) {
            return false;
        }
        const Barrier b = barrier(beyond, 1.0);
        terms.distance += weight * b.value;
        derivatives.force += weight * weights_.alpha * b.slope * beyond_.gradient;
        derivatives.addRankOne(beyond_.gradient, weight * weights_.alpha * b.curvature);
    }
    if (mu_ > 0.0) {
        const FieldCostValue c = fieldCost(cost_, field_.at(p));
        terms.external += weight * c.value;
        derivatives.force += weight * mu_ * c.slope * field_.gradient;
        derivatives.addRankOne(field_.gradient, weight * mu_ * std::max(0.0, c.curvature));
    }
    if (hasCloseness_) {
        if (closeness_.at(p) >= 1.0) {
            return false;
        }
        addAvoidance(p, weight, terms, derivatives);
    }
    return true;
}

double CellIntegrand::room(const Vec3& p) const {
    double room = 1.0 - std::abs(relativeHeightAt(p).value) / weights_.barrierWidth;
    if (hasBeyond_) {
        room = std::min(room, 1.0 - beyond_.at(p));
    }
    if (hasCloseness_) {
        room = std::min(room, 1.0 - closeness_.at(p));
    }
    return room;
}

void CellIntegrand::addAvoidance(
    const Vec3& p, double weight, EnergyTerms& terms, PointDerivatives& derivatives
) const {
    const Barrier b = avoidanceBarrier(closeness_.at(p));
    const double slope = weight * weights_.avoidance * b.slope;
    const Vec3 gradient = closeness_.gradient(p);
    terms.avoidance += weight * b.value;
    derivatives.force += slope * gradient;
    derivatives.addRankOne(gradient, weight * weights_.avoidance * b.curvature);
    if (closeness_.isAffine()) {
        return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const ClosenessForm::Bulge bulge = closeness_.bulge(k);  // curved by less than 0
        derivatives.addNegative(bulge.plus, slope * bulge.curvature);
        derivatives.addRankOne(bulge.minus, -slope * bulge.curvature);
    }
}

Vec3 CellIntegrand::gradient(const Vec3& p) const {
    Vec3 sum = Vec3::Zero();
    const HeightValue d = relativeHeightAt(p);
    if (std::abs(d.value) < weights_.barrierWidth) {
        const double slope = weights_.alpha * barrier(d.value, weights_.barrierWidth).slope;
        sum += slope * d.byHeight * height_.gradient;
        if (hasSurfaceHeight_) {
            sum += slope * d.bySurface * surfaceHeight_.gradient;
        }
    }
    if (hasBeyond_ && beyond_.at(p) < 1.0) {
        sum += weights_.alpha * barrier(beyond_.at(p), 1.0).slope * beyond_.gradient;
    }
    if (mu_ > 0.0) {
        sum += mu_ * fieldCost(cost_, field_.at(p)).slope * field_.gradient;
    }
    if (hasCloseness_) {
        const double closeness = std::min(closeness_.at(p), kClosestKink);
        sum += weights_.avoidance * avoidanceBarrier(closeness).slope * closeness_.gradient(p);
    }
    return sum;
}

}  // namespace bspline_curve
