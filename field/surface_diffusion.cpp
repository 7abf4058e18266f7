// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/surface_diffusion.h"

#include "surface/spatial_order.h"
#include "utility/worker_task.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

/// What a face adds to the matrices of linear elements.
struct FaceTerms {
    Vec3 halfCotangents;  ///< of the angles at its corners
    double area = 0.0;
};

FaceTerms termsOf(const Surface& surface, const Triangle& face) {
    const std::array<Vec3, 3> corners{
        surface.vertices()[face[0]], surface.vertices()[face[1]], surface.vertices()[face[2]]
    };
    const double twiceArea = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    FaceTerms terms{.halfCotangents = Vec3::Zero(), .area = 0.5 * twiceArea};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 next = corners[(k + 1) % 3] - corners[k];
        const Vec3 previous = corners[(k + 2) % 3] - corners[k];
        terms.halfCotangents[static_cast<int>(k)] = 0.5 * next.dot(previous) / twiceArea;
    }
    return terms;
}

double clampedWeight(double weight) {
    constexpr double kLargest = 1000.0;  // beyond, rounding would swamp the masses
    return std::clamp(weight, 0.0, kLargest);
}

// Averages as if for a while twice, each implicitly.
constexpr int kSteps = 2;

std::size_t cornerOf(const Surface& surface, int face, int vertex) {
    const Triangle& corners = surface.faces()[face];
    return corners[0] == vertex ? 0 : (corners[1] == vertex ? 1 : 2);
}

}  // namespace

SurfaceDiffusion::SurfaceDiffusion(const Surface& surface)
    : masses_(Eigen::VectorXd::Zero(surface.vertexCount())),
      weightSums_(Eigen::VectorXd::Zero(surface.vertexCount())) {
    const std::size_t count = surface.vertexCount();
    vertexOf_.reserve(count);
    for (const MortonKey& key :
         spatialOrder(count, [&](std::size_t i) { return surface.vertices()[i]; })) {
        vertexOf_.push_back(key.index);
    }
    std::vector<int> rowOf(count);
    for (std::size_t row = 0; row < count; ++row) {
        rowOf[vertexOf_[row]] = static_cast<int>(row);
    }
    offsets_.reserve(count + 1);
    middles_.reserve(count);
    neighbours_.reserve(3 * surface.faceCount());
    weights_.reserve(3 * surface.faceCount());
    std::vector<FaceTerms> terms;
    terms.reserve(surface.faces().size());
    for (const Triangle& face : surface.faces()) {
        terms.push_back(termsOf(surface, face));
    }
    std::vector<std::pair<int, double>> edges;  // of one row
    for (int row = 0; row < surface.vertexCount(); ++row) {
        const int v = vertexOf_[row];
        edges.clear();
        // Counter-clockwise: the last edge of a face is the first one of the next.
        for (const int face : surface.facesAround(v)) {
            const Triangle& corners = surface.faces()[face];
            const int k = static_cast<int>(cornerOf(surface, face, v));
            const int next = (k + 1) % 3;
            const int previous = (k + 2) % 3;
            const auto [cotangents, area] = terms[face];
            const int to = rowOf[corners[next]];
            if (edges.empty() || edges.back().first != to) {
                edges.emplace_back(to, 0.0);
            }
            edges.back().second += cotangents[previous];
            edges.emplace_back(rowOf[corners[previous]], cotangents[next]);
            masses_[row] += area / 3.0;
        }
        if (edges.empty()) {
            masses_[row] = 1.0;
        } else if (!surface.isBoundaryVertex(v)) {
            edges.front().second += edges.back().second;
            edges.pop_back();
        }
        std::ranges::sort(edges);
        offsets_.push_back(static_cast<int>(neighbours_.size()));
        middles_.push_back(offsets_.back());
        for (const auto& [to, weight] : edges) {
            middles_.back() += to < row ? 1 : 0;
            neighbours_.push_back(to);
            weights_.push_back(clampedWeight(weight));
            weightSums_[row] += weights_.back();
        }
    }
    offsets_.push_back(static_cast<int>(neighbours_.size()));
}

SurfaceDiffusion::Factors SurfaceDiffusion::factorsFor(double time) const {
    Factors factors{
        .time = time,
        .diagonal = masses_ + time * weightSums_,
        .pivots = masses_ + time * weightSums_,
    };
    for (int row = 0; row < factors.pivots.size(); ++row) {
        for (int i = offsets_[row]; i < middles_[row]; ++i) {
            const double entry = time * weights_[i];
            factors.pivots[row] -= entry * entry / factors.pivots[neighbours_[i]];
        }
    }
    return factors;
}

/// By conjugate gradients with an incomplete Cholesky factorisation C P^-1 C^T as preconditioner:
/// C has the matrix's entries below its diagonal and the pivots P on it. Its two sweeps take the
/// place of the product with the matrix (Eisenstat 1981): with A = C + C^T + D - 2 P, the operator
/// C^-1 A C^-T takes p to t + C^-1 (p + (D - 2 P) t), where t = C^-T p.
template <int C>
void SurfaceDiffusion::implicitStep(
    const Factors& factors, Eigen::Ref<Columns<C>, 0, Eigen::OuterStride<>> values
) const {
    using Row = Eigen::Array<double, 1, C>;
    constexpr double kTolerance = 1e-5;  // of the values, in the norm of the preconditioner
    constexpr int kMaxIterations = 2000;
    const int rows = static_cast<int>(values.rows());
    // What C^-1 has at a row, from what it has at the rows before; C^-T from those after.
    const auto solvedForwards = [&](const Columns<C>& solved, int row, Row right) -> Row {
        for (int i = offsets_[row]; i < middles_[row]; ++i) {
            right += factors.time * weights_[i] * solved.row(neighbours_[i]).array();
        }
        return right / factors.pivots[row];
    };
    const auto solvedBackwards = [&](const Columns<C>& solved, int row, Row right) -> Row {
        for (int i = middles_[row]; i < offsets_[row + 1]; ++i) {
            right += factors.time * weights_[i] * solved.row(neighbours_[i]).array();
        }
        return right / factors.pivots[row];
    };

    Columns<C> back(rows, C);   // t
    Columns<C> forth(rows, C);  // what the operator adds to t
    Columns<C> residual(rows, C);
    Columns<C> direction = Columns<C>::Zero(rows, C);  // p
    Row enough = Row::Zero();
    Row error = Row::Zero();
    for (int row = 0; row < rows; ++row) {
        const Row own = values.row(row);
        Row rest = -weightSums_[row] * own;
        for (int i = offsets_[row]; i < offsets_[row + 1]; ++i) {
            rest += weights_[i] * values.row(neighbours_[i]).array();
        }
        const Row right = solvedForwards(forth, row, masses_[row] * own);
        rest = solvedForwards(residual, row, factors.time * rest);
        forth.row(row) = right.matrix();
        residual.row(row) = rest.matrix();
        enough += kTolerance * kTolerance * factors.pivots[row] * right * right;
        error += factors.pivots[row] * rest * rest;
    }
    Row turn = Row::Zero();
    for (int iteration = 0; iteration < kMaxIterations && (error > enough).any(); ++iteration) {
        for (int row = rows - 1; row >= 0; --row) {
            const Row here =
                factors.pivots[row] * residual.row(row).array() + turn * direction.row(row).array();
            direction.row(row) = here.matrix();
            back.row(row) = solvedBackwards(back, row, here).matrix();
        }
        Row curvature = Row::Zero();
        for (int row = 0; row < rows; ++row) {
            const Row here = direction.row(row);
            const Row there = back.row(row);
            const double rest = factors.diagonal[row] - 2.0 * factors.pivots[row];
            const Row added = solvedForwards(forth, row, here + rest * there);
            forth.row(row) = added.matrix();
            curvature += here * (there + added);
        }
        const Row step = (error > enough).select(error / curvature, Row::Zero());
        Row next = Row::Zero();
        for (int row = 0; row < rows; ++row) {
            const Row there = back.row(row);
            values.row(row).array() += step * there;
            const Row rest = residual.row(row).array() - step * (there + forth.row(row).array());
            residual.row(row) = rest.matrix();
            next += factors.pivots[row] * rest * rest;
        }
        turn = (error > enough).select(next / error, Row::Zero());
        error = next;
    }
}

template <int K>
VertexValues<K> SurfaceDiffusion::smoothed(const VertexValues<K>& values, double radius) const {
    if (radius <= 0.0) {
        return values;
    }
    VertexValues<K> byRow(values.rows(), K);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        byRow.row(row) = values.row(vertexOf_[row]);
    }
    // A disc has the variance radius^2 / 4 along each axis, diffusion for the time t has 2 t.
    const double time = radius * radius / 8.0;
    const Factors factors = factorsFor(time / kSteps);
    const auto diffuse = [&]<int From, int Count>() {
        for (int step = 0; step < kSteps; ++step) {
            implicitStep<Count>(factors, byRow.template middleCols<Count>(From));
        }
    };
    // Columns do not depend on each other.
    constexpr int kHalf = (K + 1) / 2;
    if constexpr (K > 1) {
        auto rest = startBeside(2 * vertexOf_.size(), [&] {
            diffuse.template operator()<kHalf, K - kHalf>();
        });
        diffuse.template operator()<0, kHalf>();
        rest.get();
    } else {
        diffuse.template operator()<0, K>();
    }
    VertexValues<K> result(values.rows(), K);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        result.row(vertexOf_[row]) = byRow.row(row);
    }
    return result;
}

template VertexValues<1> SurfaceDiffusion::smoothed<1>(const VertexValues<1>&, double) const;
template VertexValues<9> SurfaceDiffusion::smoothed<9>(const VertexValues<9>&, double) const;

}  // namespace bspline_curve
