// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "spline/polynomial_curve.h"

#include <Eigen/Core>

#include <vector>

namespace bspline_curve {

/// Control points of a spline, one row each (#C by 3).
using ControlPoints = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

inline constexpr int kMaxBasis = kMaxPolynomialDegree + 1;

/// The splines of one degree over one sequence of simple knots on [0, 1]: clamped (open) or with
/// period 1 (closed). A span is the interval between two neighbouring breaks; in it degree + 1
/// basis functions are not zero.
class SplineSpace {
public:
    /// `breaks` ascend strictly from 0 to 1. Closed spaces need at least degree + 1 spans.
    SplineSpace(int degree, bool closed, std::vector<double> breaks);

    [[nodiscard]] int degree() const { return degree_; }

    [[nodiscard]] bool closed() const { return closed_; }

    [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }

    [[nodiscard]] int spanCount() const { return static_cast<int>(breaks_.size()) - 1; }

    [[nodiscard]] int controlCount() const { return closed_ ? spanCount() : spanCount() + degree_; }

    [[nodiscard]] int basisCount() const { return degree_ + 1; }

    [[nodiscard]] double spanLength(int span) const { return breaks_[span + 1] - breaks_[span]; }

    /// Control point of the j-th basis function that lives on a span.
    [[nodiscard]] int control(int span, int j) const {
        const int index = span + j;
        return closed_ && index >= controlCount() ? index - controlCount() : index;
    }

    /// The span that holds t (the last one for t = 1).
    [[nodiscard]] int spanAt(double t) const;

    /// Power coefficients of the basis on a span: entry (j, m) belongs to tau^m of basis function
    /// j, with tau = (t - break) / spanLength in [0, 1].
    using BasisMatrix = Eigen::Matrix<double, kMaxBasis, kMaxBasis>;

    [[nodiscard]] const BasisMatrix& basis(int span) const { return basis_[span]; }

    /// Coefficients of the basis on a span, or of its derivative of some order by t, in the
    /// products tau^k (1 - tau)^(n - k), n = degree - order: entry (j, k) belongs to basis function
    /// j.
    [[nodiscard]] BasisMatrix bernsteinBasis(int span, int order = 0) const;

    using BasisValues = std::array<double, kMaxBasis>;
    /// Values of the basis functions of a span at tau.
    [[nodiscard]] BasisValues basisAt(int span, double tau) const;

    /// The spline on one span, as a polynomial in tau.
    [[nodiscard]] PolynomialCurve polynomial(const ControlPoints& controls, int span) const;

    [[nodiscard]] Vec3 evaluate(const ControlPoints& controls, double t) const;

    /// The full knot vector: open clamped; closed the unclamped periodic one, degree knots beyond
    /// either end.
    [[nodiscard]] std::vector<double> knotVector() const;

private:
    [[nodiscard]] double knot(
        int index
    ) const;  // break with index from -degree to spanCount + degree

    int degree_;
    bool closed_;
    std::vector<double> breaks_;
    std::vector<BasisMatrix> basis_;
};

/// Controls of the same curve in a space with more breaks (every break of `from` is one of `to`).
/// Exact to rounding: blossoming (de Boor's algorithm with the knots of the finer space).
[[nodiscard]] ControlPoints refine(
    const SplineSpace& from, const ControlPoints& controls, const SplineSpace& to
);

}  // namespace bspline_curve
