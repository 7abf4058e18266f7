// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/harmonic_values.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bspline_curve {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Each half weight is in this range: no edge counts for nothing, or for all.
constexpr double kLeastWeight = 1e-3;
constexpr double kLargestWeight = 1e3;

}  // namespace

ValueRows harmonicFrom(
    const std::vector<Vec3>& points, const std::vector<Triangle>& faces, const ValueRows& values
) {
    const auto rimCount = static_cast<int>(values.rows());
    const auto inner = static_cast<int>(points.size()) - rimCount;
    if (inner == 0) {
        return values;
    }
    ValueRows right = ValueRows::Zero(inner, values.cols());
    std::vector<Eigen::Triplet<double>> entries;
    const auto addRow = [&](int i, int j, double weight) {
        if (i >= rimCount) {
            entries.emplace_back(i - rimCount, i - rimCount, weight);
            if (j >= rimCount) {
                entries.emplace_back(i - rimCount, j - rimCount, -weight);
            } else {
                right.row(i - rimCount) += weight * values.row(j);
            }
        }
    };
    for (const Triangle& face : faces) {
        for (int k = 0; k < 3; ++k) {
            const int i = face[(k + 1) % 3];
            const int j = face[(k + 2) % 3];
            const Vec3 to = points[i] - points[face[k]];
            const Vec3 from = points[j] - points[face[k]];
            const double sine = std::max(to.cross(from).norm(), 1e-300);
            const double weight =
                std::clamp(0.5 * to.dot(from) / sine, kLeastWeight, kLargestWeight);
            addRow(i, j, weight);
            addRow(j, i, weight);
        }
    }
    Sparse system(inner, inner);
    system.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Sparse> factors(system);
    if (factors.info() != Eigen::Success) {
        throw std::logic_error("a patch has points that its rim does not reach");
    }
    ValueRows result(points.size(), values.cols());
    result.topRows(rimCount) = values;
    result.bottomRows(inner) = factors.solve(right);
    return result;
}

}  // namespace bspline_curve
