// SPDX-License-Identifier: GPL-3.0-or-later
#include "cubic_interpolation.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace bspline_curve::test_support {
namespace {

std::vector<Vec3> solveRows(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    const Eigen::MatrixXd solution = matrix.partialPivLu().solve(right);
    std::vector<Vec3> rows;
    for (Eigen::Index i = 0; i < solution.rows(); ++i) {
        rows.emplace_back(solution.row(i).transpose());
    }
    return rows;
}

// Continuity of the first derivative at point b, between the intervals a b and b c:
// h0/6 Ma + (h0 + h1)/3 Mb + h1/6 Mc = (c - b)/h1 - (b - a)/h0.
struct Joint {
    Eigen::Index a, b, c;
    double h0, h1;
};

void addJoint(
    const Joint& joint,
    const std::vector<Vec3>& points,
    Eigen::MatrixXd& matrix,
    Eigen::MatrixXd& right
) {
    const auto& [a, b, c, h0, h1] = joint;
    const auto point = [&](Eigen::Index i) { return points[i]; };
    matrix(b, a) += h0 / 6.0;
    matrix(b, b) += (h0 + h1) / 3.0;
    matrix(b, c) += h1 / 6.0;
    right.row(b) = ((point(c) - point(b)) / h1 - (point(b) - point(a)) / h0).transpose();
}

}  // namespace

CubicInterpolation CubicInterpolation::natural(
    std::vector<double> knots, std::vector<Vec3> points
) {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
    matrix(0, 0) = 1.0;
    matrix(n - 1, n - 1) = 1.0;
    for (Eigen::Index b = 1; b + 1 < n; ++b) {
        const auto i = static_cast<std::size_t>(b);
        addJoint(
            {b - 1, b, b + 1, knots[i] - knots[i - 1], knots[i + 1] - knots[i]},
            points,
            matrix,
            right
        );
    }
    CubicInterpolation spline;
    spline.moments_ = solveRows(matrix, right);
    spline.knots_ = std::move(knots);
    spline.points_ = std::move(points);
    return spline;
}

CubicInterpolation CubicInterpolation::periodic(
    std::vector<double> knots, std::vector<Vec3> points
) {
    const auto n = static_cast<Eigen::Index>(points.size());
    knots.push_back(knots.front() + 1.0);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
    for (Eigen::Index b = 0; b < n; ++b) {
        const auto i = static_cast<std::size_t>(b);
        const double before =
            b == 0 ? knots.back() - knots[knots.size() - 2] : knots[i] - knots[i - 1];
        addJoint(
            {(b + n - 1) % n, b, (b + 1) % n, before, knots[i + 1] - knots[i]},
            points,
            matrix,
            right
        );
    }
    CubicInterpolation spline;
    spline.moments_ = solveRows(matrix, right);
    spline.moments_.push_back(spline.moments_.front());
    points.push_back(points.front());
    spline.knots_ = std::move(knots);
    spline.points_ = std::move(points);
    return spline;
}

Vec3 CubicInterpolation::at(double t) const {
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), t) - knots_.begin();
    const auto last = static_cast<std::ptrdiff_t>(knots_.size()) - 2;
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, last));
    const double h = knots_[i + 1] - knots_[i];
    const double a = (knots_[i + 1] - t) / h;
    const double b = (t - knots_[i]) / h;
    return a * points_[i] + b * points_[i + 1] +
           h * h / 6.0 * ((a * a * a - a) * moments_[i] + (b * b * b - b) * moments_[i + 1]);
}

}  // namespace bspline_curve::test_support
