// SPDX-License-Identifier: GPL-3.0-or-later
#include "cubic_interpolation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace bspline_curve::test_support {

// At every point b between intervals a b and b c, the first derivative is continuous:
// h0/6 Ma + (h0 + h1)/3 Mb + h1/6 Mc = (c - b)/h1 - (b - a)/h0.
CubicInterpolation::CubicInterpolation(
    std::vector<double> knots, std::vector<Vec3> points, bool isPeriodic
)
    : knots_(std::move(knots)), points_(std::move(points)) {
    const auto n = static_cast<int>(points_.size());
    if (isPeriodic) {
        knots_.push_back(knots_.front() + 1.0);
        points_.push_back(points_.front());
    }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
    for (int b = isPeriodic ? 0 : 1; b + (isPeriodic ? 0 : 1) < n; ++b) {
        const int a = (b + n - 1) % n;
        const int c = (b + 1) % n;
        const double h0 = knots_[a + 1] - knots_[a];
        const double h1 = knots_[b + 1] - knots_[b];
        matrix(b, b) = (h0 + h1) / 3.0;
        matrix(b, a) += h0 / 6.0;
        matrix(b, c) += h1 / 6.0;
        right.row(b) =
            ((points_[c] - points_[b]) / h1 - (points_[b] - points_[a]) / h0).transpose();
    }
    const Eigen::MatrixXd moments = matrix.partialPivLu().solve(right);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        moments_.emplace_back(moments.row(static_cast<int>(i) % n).transpose());
    }
}

Vec3 CubicInterpolation::at(double t) const {
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), t) - knots_.begin();
    const auto i = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(knots_) - 2);
    const double h = knots_[i + 1] - knots_[i];
    const double a = (knots_[i + 1] - t) / h;
    const double b = (t - knots_[i]) / h;
    return a * points_[i] + b * points_[i + 1] +
           h * h / 6.0 * ((a * a * a - a) * moments_[i] + (b * b * b - b) * moments_[i + 1]);
}

}  // namespace bspline_curve::test_support
