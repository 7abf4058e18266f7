// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spline_fit.h"

#include "spline/constrained_fit.h"
#include "spline/spline_system.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bspline_curve {
namespace {

// Weight of the bending regulariser against the squared distance, in units of the span length to
// the fourth.
constexpr double kRegularisation = 1e-5;

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

}  // namespace

SpanTarget::SpanTarget(const InitialPath& initialPath, double begin, double end) {
    moments.fill(Vec3::Zero());
    std::size_t last = initialPath.indexAt(begin);
    for (int i = 0; i < kSamples; ++i) {
        const double t = begin + tau(i) * (end - begin);
        last = initialPath.indexFrom(last, t);
        const Vec3 position = initialPath.positionAfter(last, t);
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
    const PickConstraints picks(space, interpolationRows(space, problem.picks));
    BandCholesky<1> factor = bandCholeskyOf<1>(space);
    ControlPoints right = ControlPoints::Zero(space.controlCount(), 3);
    for (int span = 0; span < space.spanCount(); ++span) {
        addProducts(factor, space, span, fitProducts(space, span));
        for (int j = 0; j < space.basisCount(); ++j) {
            Vec3 mean = Vec3::Zero();
            for (int m = 0; m < space.basisCount(); ++m) {
                mean += space.basis(span)(j, m) * targets[span].moments[m];
            }
            right.row(space.control(span, j)) += space.spanLength(span) * mean.transpose();
        }
    }
    addProducts(factor, space, picks, kFitConstraintWeight);
    ControlPoints controls = factor.factorise()
                                 ? constrainedFit(factor, picks, right, kFitConstraintWeight)
                                 : ControlPoints(ControlPoints::Zero(space.controlCount(), 3));
    // To rounding, before it is asked whether the curve stays inside.
    picks.meet(controls);
    return controls;
}

}  // namespace bspline_curve
