// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
SplineSpace::SplineSpace(int degree, bool closed, std::vector<double> breaks)
    : degree_(degree), closed_(closed), breaks_(std::move(breaks)) {
    basis_.resize(spanCount());
    // Cox-de Boor (1), (2) carried out on polynomials in tau.
    for (int span = 0; span < spanCount(); ++span) {
        BasisMatrix table = BasisMatrix::Zero();
        table(0, 0) = 1.0;
        const double start = breaks_[span];
        const double length = spanLength(span);
        std::array<double, 2 * kMaxPolynomialDegree> knots;  // from first on
        const int first = span + 1 - degree_;
        for (int i = 0; i < 2 * degree_; ++i) {
            knots[i] = knot(first + i);
        }
        for (int k = 1; k <= degree_; ++k) {
            BasisMatrix next = BasisMatrix::Zero();
            for (int j = 0; j < k; ++j) {
                // Function j of degree k - 1 on this span is supported on knots [i, i + k].
                const int i = span - (k - 1) + j;
                const double left = knots[i - first];
                const double right = knots[i + k - first];
                const double scale = 1.0 / (right - left);
                // (t - left) / (right - left) and (right - t) / (right - left), t = start + length
                // * tau
                const double rise0 = (start - left) * scale;
                const double fall0 = (right - start) * scale;
                const double slope = length * scale;
                for (int m = 0; m < k; ++m) {
                    next(j + 1, m) += rise0 * table(j, m);
                    next(j + 1, m + 1) += slope * table(j, m);
                    next(j, m) += fall0 * table(j, m);
                    next(j, m + 1) -= slope * table(j, m);
                }
            }
            table = next;
        }
        basis_[span] = table;
    }
}

double SplineSpace::knot(int index) const {
    const int n = spanCount();
    if (index >= 0 && index <= n) {
        return breaks_[index];
    }
    if (!closed_) {
        return index < 0 ? 0.0 : 1.0;
    }
    return index < 0 ? breaks_[index + n] - 1.0 : breaks_[index - n] + 1.0;
}

int SplineSpace::spanAt(double t) const {
    const auto above = std::upper_bound(breaks_.begin(), breaks_.end(), t);
    const int span = static_cast<int>(above - breaks_.begin()) - 1;
    return std::clamp(span, 0, spanCount() - 1);
}

SplineSpace::BasisValues SplineSpace::basisAt(int span, double tau) const {
    const BasisMatrix& table = basis(span);
    BasisValues values{};
    for (int j = 0; j <= degree_; ++j) {
        double value = table(j, degree_);
        for (int m = degree_; m-- > 0;) {
            value = value * tau + table(j, m);
        }
        values[j] = value;
    }
    return values;
}

SplineSpace::BasisMatrix SplineSpace::bernsteinBasis(int span, int order) const {
    const BasisMatrix& table = basis(span);
    const int n = degree_ - order;
    const double scale = std::pow(spanLength(span), -order);
    BasisMatrix result = BasisMatrix::Zero();
    for (int j = 0; j <= degree_; ++j) {
        for (int m = 0; m <= n; ++m) {
            double factor = scale * table(j, m + order);
            for (int i = 0; i < order; ++i) {
                factor *= m + order - i;
            }
            // tau^m = tau^m (tau + (1 - tau))^(n - m)
            for (int k = m; k <= n; ++k) {
                result(j, k) += factor;
                factor = factor * (n - k) / (k - m + 1);
            }
        }
    }
    return result;
}

PolynomialCurve SplineSpace::polynomial(const ControlPoints& controls, int span) const {
    PolynomialCurve curve;
    curve.degree = degree_;
    const BasisMatrix& table = basis(span);
    for (int m = 0; m <= degree_; ++m) {
        Vec3 sum = Vec3::Zero();
        for (int j = 0; j <= degree_; ++j) {
            sum += table(j, m) * controls.row(control(span, j)).transpose();
        }
        curve.coefficients[m] = sum;
    }
    return curve;
}

Vec3 SplineSpace::evaluate(const ControlPoints& controls, double t) const {
    const int span = spanAt(t);
    return polynomial(controls, span).at((t - breaks_[span]) / spanLength(span));
}

std::vector<double> SplineSpace::knotVector() const {
    std::vector<double> knots;
    for (int i = -degree_; i <= spanCount() + degree_; ++i) {
        knots.push_back(knot(i));
    }
    return knots;
}

ControlPoints refine(
    const SplineSpace& from, const ControlPoints& controls, const SplineSpace& to
) {
    // Control i of a spline is its blossom at the `degree` inner knots of basis function i. Take
    // the polynomial of a coarse span under that function and polarise it.
    const int degree = to.degree();
    const std::vector<double> knots = to.knotVector();
    ControlPoints result(to.controlCount(), 3);
    for (int i = 0; i < to.controlCount(); ++i) {
        // Basis function i lives on knots[i .. i + degree + 1]; any non-empty fine span in it will
        // do: the middle one.
        int fine = i - degree / 2;
        if (!to.closed()) {
            fine = std::clamp(fine, 0, to.spanCount() - 1);
        }
        double shift = 0.0;
        if (fine < 0) {
            fine += to.spanCount();
            shift = 1.0;
        }
        const double start = to.breaks()[fine];
        const double middle = start + 0.5 * to.spanLength(fine);
        const int span = from.spanAt(middle);
        const PolynomialCurve p = from.polynomial(controls, span);
        // Elementary symmetric polynomials of the knots in the span's own parameter.
        std::array<double, kMaxBasis> symmetric{};
        symmetric[0] = 1.0;
        for (int j = 1; j <= degree; ++j) {
            const double u = (knots[i + j] + shift - from.breaks()[span]) / from.spanLength(span);
            for (int m = j; m > 0; --m) {
                symmetric[m] += u * symmetric[m - 1];
            }
        }
        Vec3 value = Vec3::Zero();
        double binomial = 1.0;
        for (int m = 0; m <= degree; ++m) {
            value += p.coefficients[m] * (symmetric[m] / binomial);
            binomial = binomial * (degree - m) / (m + 1);
        }
        result.row(i) = value.transpose();
    }
    return result;
}

}  // namespace bspline_curve
