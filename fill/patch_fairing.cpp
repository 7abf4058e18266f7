// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_fairing.h"

#include "bspline_curve/progress.h"
#include "utility/go_on.h"
#include "utility/while_waiting.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bspline_curve {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Steps end where points move by less than this of the patch's size.
constexpr double kMoveRelative = 1e-4;
/// Areas of points are at least this of their size's square, so that needles do not outweigh all.
constexpr double kLeastAreaRelative = 1e-3;
/// The size of a point is at least this of that far from the rim there.
constexpr double kLeastSizeForArea = 0.3;
/// The angles of slivers count as if twice their area were this of the longest edge's square: the
/// squares of their cotangents would leave no digits to the others. Not at the rim, where large
/// cotangents are of edges that stay.
constexpr double kLeastAreaOfSliver = 1e-3;
/// Conjugate gradients: rounds, each with a curvature of its own, and steps in each. Waves of up to
/// about four edges' length, which halving edges makes, are gone then.
constexpr int kSmoothingRounds = 2;
constexpr int kSmoothingSteps = 12;

/// The patch as finite elements: #points rows, one column for each inner point.
struct Elements {
    Sparse laplacian;  // of the inner points' positions
    Rows constant;     // what rim and surroundings add
    Eigen::VectorXd area;
    Rows normal;  // unit
};

/// By which the cotangents of a face are at least divided.
double leastTwiceArea(const Patch& patch, const Triangle& face) {
    const auto isOnRim = [&](int point) { return patch.isOnRim(point); };
    if (std::ranges::count_if(face, isOnRim) > 1) {
        return 0.0;
    }
    const auto squaredLength = [&](int a, int b) {
        return (patch.points[a] - patch.points[b]).squaredNorm();
    };
    const auto& [a, b, c] = face;
    return kLeastAreaOfSliver *
           std::max({squaredLength(a, b), squaredLength(b, c), squaredLength(c, a)});
}

Elements elementsOf(const Patch& patch, const RimSurroundings& around, const GoOn& goOn) {
    const auto count = static_cast<int>(patch.points.size());
    const int inner = count - patch.rimCount;
    Elements result{
        .laplacian = Sparse(count, inner),
        .constant = Rows::Zero(count, 3),
        .area = Eigen::VectorXd::Zero(count),
        .normal = Rows::Zero(count, 3)
    };
    for (int i = 0; i < patch.rimCount; ++i) {
        result.constant.row(i) = around.laplacians[i];
        result.normal.row(i) = around.normals[i];
    }
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int row, int of, double weight) {
        if (patch.isOnRim(of)) {
            result.constant.row(row) += weight * patch.points[of];
        } else {
            entries.emplace_back(row, of - patch.rimCount, weight);
        }
    };
    for (std::size_t f = 0; f < patch.faces.size(); ++f) {
        if (f % kRoundsBetweenCalls == 0) {
            goOn();
        }
        const Triangle& face = patch.faces[f];
        const Vec3& p = patch.points[face[0]];
        const Vec3 normal = (patch.points[face[1]] - p).cross(patch.points[face[2]] - p);
        const double twiceArea = std::max(normal.norm(), std::numeric_limits<double>::min());
        const double divisor = std::max(twiceArea, leastTwiceArea(patch, face));
        for (int k = 0; k < 3; ++k) {
            const int i = face[(k + 1) % 3];
            const int j = face[(k + 2) % 3];
            const Vec3& apex = patch.points[face[k]];
            const double weight = 0.5 * (patch.points[i] - apex).dot(patch.points[j] - apex) /
                                  divisor;  // half the cotangent
            add(i, j, weight);
            add(i, i, -weight);
            add(j, i, weight);
            add(j, j, -weight);
            result.normal.row(face[k]) += normal;
            // A point of the rim has as much surface outside.
            result.area[face[k]] += twiceArea / 6.0 * (patch.isOnRim(face[k]) ? 2.0 : 1.0);
        }
    }
    goOn();
    for (int i = 0; i < count; ++i) {
        const double size = std::max(patch.sizes[i], kLeastSizeForArea * patch.most[i]);
        const double least = kLeastAreaRelative * size * size;
        result.area[i] = std::max(result.area[i], least);
        result.normal.row(i).stableNormalize();
    }
    whileWaiting(goOn, [&] { result.laplacian.setFromTriplets(entries.begin(), entries.end()); });
    return result;
}

/// Mean of the Laplacian along the normal over the inner points: twice the mean curvature.
double meanCurvature(const Elements& elements, const Rows& laplacians, int rimCount) {
    const auto inner = elements.area.size() - rimCount;
    const double sum =
        laplacians.bottomRows(inner).cwiseProduct(elements.normal.bottomRows(inner)).sum();
    return sum / elements.area.tail(inner).sum();
}

/// What the inner points minimise: the weighted square of laplacian * points + constant - aim.
struct LeastSquares {
    Eigen::VectorXd weight;  // of each row
    Rows aim;
};

LeastSquares leastSquares(
    const Elements& elements, const RimSurroundings& around, int rimCount, double curvature
) {
    LeastSquares result{
        .weight = elements.area.cwiseInverse(),
        .aim = curvature * (elements.area.asDiagonal() * elements.normal)
    };
    for (int i = 0; i < rimCount; ++i) {
        result.weight[i] *= around.isKnown[i] != 0 ? 1.0 : 0.0;
    }
    return result;
}

Rows innerPoints(const Patch& patch) {
    Rows points(std::ssize(patch.points) - patch.rimCount, 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        points.row(i) = patch.points[patch.rimCount + i];
    }
    return points;
}

void setInnerPoints(Patch& patch, const Rows& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        patch.points[patch.rimCount + i] = points.row(i);
    }
}

/// A few steps of conjugate gradients towards the least squares, scaled by the diagonal.
void approach(
    Rows& points, const Elements& elements, const LeastSquares& squares, const GoOn& goOn
) {
    const Sparse& laplacian = elements.laplacian;
    const auto dots = [](const Rows& a, const Rows& b) -> Eigen::RowVector3d {
        return a.cwiseProduct(b).colwise().sum();
    };
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(points.rows());
    for (int column = 0; column < laplacian.outerSize(); ++column) {
        for (Sparse::InnerIterator entry(laplacian, column); entry; ++entry) {
            scale[column] += squares.weight[entry.row()] * entry.value() * entry.value();
        }
    }
    goOn();
    scale = scale.cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
    const Rows missing = squares.aim - elements.constant - laplacian * points;
    Rows residual = laplacian.transpose() * (squares.weight.asDiagonal() * missing);
    Rows direction = scale.asDiagonal() * residual;
    Eigen::RowVector3d size = dots(residual, direction);
    const auto shares = [](const Eigen::RowVector3d& of, const Eigen::RowVector3d& whole) {
        return of.cwiseQuotient(whole.cwiseMax(std::numeric_limits<double>::min())).eval();
    };
    for (int step = 0; step < kSmoothingSteps; ++step) {
        goOn();
        const Rows change = laplacian * direction;
        const Rows weighted = squares.weight.asDiagonal() * change;
        const Eigen::RowVector3d length = shares(size, dots(change, weighted));
        points += direction * length.asDiagonal();
        residual -= (laplacian.transpose() * weighted) * length.asDiagonal();
        const Rows scaled = scale.asDiagonal() * residual;
        const Eigen::RowVector3d next = dots(residual, scaled);
        direction = scaled + direction * shares(next, size).asDiagonal();
        size = next;
    }
}

double extentOf(const Patch& patch) {
    Vec3 low = patch.points[0];
    Vec3 high = low;
    for (int i = 0; i < patch.rimCount; ++i) {
        low = low.cwiseMin(patch.points[i]);
        high = high.cwiseMax(patch.points[i]);
    }
    return (high - low).norm();
}

}  // namespace

void fairPatch(Patch& patch, const RimSurroundings& around, int steps, const Progress& progress) {
    const auto inner = static_cast<int>(patch.points.size()) - patch.rimCount;
    if (inner == 0) {
        return;
    }
    const double enough = kMoveRelative * extentOf(patch);
    Eigen::SimplicialLDLT<Sparse> factors;
    double lastMove = std::numeric_limits<double>::infinity();
    for (int step = 0; step < steps; ++step) {
        const GoOn goOn = [&] {
            report(progress, static_cast<double>(step) / steps, "fairing a patch");
        };
        goOn();
        const Elements elements = elementsOf(patch, around, goOn);
        const Rows points = innerPoints(patch);
        // The first step has no curvature to go by: the patch is still flat.
        const Rows laplacians = elements.laplacian * points + elements.constant;
        const double curvature =
            step == 0 ? 0.0 : meanCurvature(elements, laplacians, patch.rimCount);
        const auto [weight, aim] = leastSquares(elements, around, patch.rimCount, curvature);
        Rows solution;
        whileWaiting(goOn, [&, &weight = weight, &aim = aim] {
            const Sparse weighted = weight.asDiagonal() * elements.laplacian;
            const Sparse system = elements.laplacian.transpose() * weighted;
            if (step == 0) {
                factors.analyzePattern(system);  // points move, faces stay
            }
            factors.factorize(system);
            if (factors.info() == Eigen::Success) {
                solution = factors.solve(weighted.transpose() * (aim - elements.constant));
            }
        });
        if (factors.info() != Eigen::Success) {
            return;  // the last positions are kept
        }
        const double move = (solution - points).rowwise().norm().maxCoeff();
        // A step that moves farther than the one before leads away (NaN too).
        const bool leadsAway =
            !(move <= (step < 2 ? std::numeric_limits<double>::max() : lastMove));
        if (leadsAway) {
            return;
        }
        setInnerPoints(patch, solution);
        if (move < enough) {
            return;
        }
        lastMove = move;
    }
}

void fairDivided(Patch& patch, const RimSurroundings& around, const Progress& progress) {
    if (std::ssize(patch.points) == patch.rimCount) {
        return;
    }
    for (int round = 0; round < kSmoothingRounds; ++round) {
        const GoOn goOn = [&] {
            report(progress, static_cast<double>(round) / kSmoothingRounds, "fairing a patch");
        };
        goOn();
        const Elements elements = elementsOf(patch, around, goOn);
        goOn();
        Rows points = innerPoints(patch);
        const Rows laplacians = elements.laplacian * points + elements.constant;
        const double curvature = meanCurvature(elements, laplacians, patch.rimCount);
        approach(points, elements, leastSquares(elements, around, patch.rimCount, curvature), goOn);
        const Eigen::VectorXd moves = (points - innerPoints(patch)).rowwise().norm();
        const double size = *std::ranges::max_element(patch.most);
        if (!(moves.maxCoeff() <= size)) {
            return;  // it leads away (NaN too); the last positions are kept
        }
        setInnerPoints(patch, points);
    }
}

}  // namespace bspline_curve
