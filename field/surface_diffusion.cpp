// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/surface_diffusion.h"

#include "surface/spatial_order.h"
#include "utility/worker_task.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

/// Half the cotangent of the angle of a face at its corner k.
double halfCotangent(const Surface& surface, int face, std::size_t k) {
    const Triangle& corners = surface.faces()[face];
    const Vec3& corner = surface.vertices()[corners[k]];
    const Vec3 next = surface.vertices()[corners[(k + 1) % 3]] - corner;
    const Vec3 previous = surface.vertices()[corners[(k + 2) % 3]] - corner;
    return 0.5 * next.dot(previous) / next.cross(previous).norm();
}

double areaOf(const Surface& surface, int face) {
    const Triangle& corners = surface.faces()[face];
    const Vec3& corner = surface.vertices()[corners[0]];
    const Vec3 next = surface.vertices()[corners[1]] - corner;
    const Vec3 previous = surface.vertices()[corners[2]] - corner;
    return 0.5 * next.cross(previous).norm();
}

double clampedWeight(double weight) {
    constexpr double kLargest = 1000.0;  // beyond, rounding would swamp the masses
    return std::clamp(weight, 0.0, kLargest);
}

// Closed surfaces have half as many vertices as faces.
constexpr std::size_t kVerticesForTwoThreads = kFacesForTwoThreads / 2;
// Rows that one thread takes at once. Sums are those of blocks, so that they do not depend on the
// number of threads.
constexpr Eigen::Index kRowsAtOnce = 1024;

// Calls task(begin, end) for all rows, block by block.
template <class Task>
void forEachBlock(WorkerThread* side, Eigen::Index rows, const Task& task) {
    const auto blocks = static_cast<int>((rows + kRowsAtOnce - 1) / kRowsAtOnce);
    forEach(side, blocks, 1, [&](int block) {
        const Eigen::Index begin = block * kRowsAtOnce;
        task(begin, std::min(rows, begin + kRowsAtOnce));
    });
}

// The sum of what a task returns for each row.
template <int K, class Task>
Eigen::Array<double, 1, K> sumOfRows(WorkerThread* side, Eigen::Index rows, const Task& task) {
    using Row = Eigen::Array<double, 1, K>;
    const Eigen::Index blocks = (rows + kRowsAtOnce - 1) / kRowsAtOnce;
    VertexValues<K> sums(blocks, K);
    forEachBlock(side, rows, [&](Eigen::Index begin, Eigen::Index end) {
        Row sum = Row::Zero();
        for (Eigen::Index i = begin; i < end; ++i) {
            sum += task(i);
        }
        sums.row(begin / kRowsAtOnce) = sum.matrix();
    });
    Row sum = Row::Zero();
    for (Eigen::Index block = 0; block < blocks; ++block) {
        sum += sums.row(block).array();
    }
    return sum;
}

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
    neighbours_.reserve(3 * surface.faceCount());
    weights_.reserve(3 * surface.faceCount());
    const auto addEdge = [&](int row, int to, double weight) {
        neighbours_.push_back(rowOf[to]);
        weights_.push_back(clampedWeight(weight));
        weightSums_[row] += weights_.back();
    };
    for (int row = 0; row < surface.vertexCount(); ++row) {
        const int v = vertexOf_[row];
        offsets_.push_back(static_cast<int>(neighbours_.size()));
        const Surface::FaceRange fan = surface.facesAround(v);
        if (fan.empty()) {
            masses_[row] = 1.0;
            continue;
        }
        // Counter-clockwise, each edge with the face before it and the one after it.
        const bool isOpen = surface.isBoundaryVertex(v);
        int before = *(fan.end() - 1);
        for (const int face : fan) {
            const std::size_t k = cornerOf(surface, face, v);
            const bool isFirst = face == *fan.begin();
            double weight = halfCotangent(surface, face, (k + 2) % 3);
            if (!isFirst || !isOpen) {
                const std::size_t opposite = (cornerOf(surface, before, v) + 1) % 3;
                weight += halfCotangent(surface, before, opposite);
            }
            addEdge(row, surface.faces()[face][(k + 1) % 3], weight);
            masses_[row] += areaOf(surface, face) / 3.0;
            before = face;
        }
        if (isOpen) {
            const std::size_t k = cornerOf(surface, before, v);
            const int last = surface.faces()[before][(k + 2) % 3];
            addEdge(row, last, halfCotangent(surface, before, (k + 1) % 3));
        }
    }
    offsets_.push_back(static_cast<int>(neighbours_.size()));
}

template <int K>
Eigen::Array<double, 1, K> SurfaceDiffusion::productAt(
    const VertexValues<K>& values, double time, Eigen::Index row
) const {
    const Eigen::Array<double, 1, K> own = values.row(row);
    Eigen::Array<double, 1, K> sum = weightSums_[row] * own;
    for (int i = offsets_[row]; i < offsets_[row + 1]; ++i) {
        sum -= weights_[i] * values.row(neighbours_[i]).array();
    }
    return masses_[row] * own + time * sum;
}

/// By conjugate gradients with the diagonal as preconditioner. Memory is what takes the time, so
/// each row is visited as seldom as can be.
template <int K>
VertexValues<K> SurfaceDiffusion::implicitStep(
    VertexValues<K> values, double time, WorkerThread* side
) const {
    using Row = Eigen::Array<double, 1, K>;
    constexpr double kTolerance = 1e-5;  // of the values, in the norm of the preconditioner
    constexpr int kMaxIterations = 2000;
    const Eigen::Index rows = values.rows();
    const Eigen::VectorXd inverseDiagonal = (masses_ + time * weightSums_).cwiseInverse();
    VertexValues<K> product(rows, K);
    VertexValues<K> residual(rows, K);
    VertexValues<K> direction(rows, K);
    const Row enough = sumOfRows<K>(side, rows, [&](Eigen::Index i) -> Row {
        const Row right = masses_[i] * values.row(i).array();
        return kTolerance * kTolerance * inverseDiagonal[i] * right * right;
    });
    Row error = sumOfRows<K>(side, rows, [&](Eigen::Index i) -> Row {
        const Row rest = masses_[i] * values.row(i).array() - productAt<K>(values, time, i);
        residual.row(i) = rest.matrix();
        direction.row(i) = (inverseDiagonal[i] * rest).matrix();
        return inverseDiagonal[i] * rest * rest;
    });
    for (int iteration = 0; iteration < kMaxIterations && (error > enough).any(); ++iteration) {
        const Row curvature = sumOfRows<K>(side, rows, [&](Eigen::Index i) -> Row {
            const Row here = productAt<K>(direction, time, i);
            product.row(i) = here.matrix();
            return direction.row(i).array() * here;
        });
        const Row step = (error > enough).select(error / curvature, Row::Zero());
        const Row next = sumOfRows<K>(side, rows, [&](Eigen::Index i) -> Row {
            values.row(i).array() += step * direction.row(i).array();
            const Row rest = residual.row(i).array() - step * product.row(i).array();
            residual.row(i) = rest.matrix();
            return inverseDiagonal[i] * rest * rest;
        });
        const Row turn = (error > enough).select(next / error, Row::Zero());
        forEachBlock(side, rows, [&](Eigen::Index begin, Eigen::Index end) {
            for (Eigen::Index i = begin; i < end; ++i) {
                direction.row(i) =
                    (inverseDiagonal[i] * residual.row(i).array() + turn * direction.row(i).array())
                        .matrix();
            }
        });
        error = next;
    }
    return values;
}

template <int K>
VertexValues<K> SurfaceDiffusion::smoothed(const VertexValues<K>& values, double radius) const {
    if (radius <= 0.0) {
        return values;
    }
    std::optional<WorkerThread> side;
    if (vertexOf_.size() >= kVerticesForTwoThreads) {
        side.emplace();
    }
    WorkerThread* const second = side ? &*side : nullptr;
    VertexValues<K> byRow(values.rows(), K);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        byRow.row(row) = values.row(vertexOf_[row]);
    }
    // A disc has the variance radius^2 / 4 along each axis, diffusion for the time t has 2 t.
    const double time = radius * radius / 8.0;
    for (int step = 0; step < 2; ++step) {
        byRow = implicitStep<K>(std::move(byRow), 0.5 * time, second);
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
