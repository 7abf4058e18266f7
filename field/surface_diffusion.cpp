// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/surface_diffusion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Half the cotangent of the angle of a face at its corner k.
double halfCotangent(const Surface& surface, int face, std::size_t k) {
    const Triangle& corners = surface.faces()[at(face)];
    const Vec3& corner = surface.vertices()[at(corners[k])];
    const Vec3 next = surface.vertices()[at(corners[(k + 1) % 3])] - corner;
    const Vec3 previous = surface.vertices()[at(corners[(k + 2) % 3])] - corner;
    return 0.5 * next.dot(previous) / next.cross(previous).norm();
}

double areaOf(const Surface& surface, int face) {
    const Triangle& corners = surface.faces()[at(face)];
    const Vec3& corner = surface.vertices()[at(corners[0])];
    const Vec3 next = surface.vertices()[at(corners[1])] - corner;
    const Vec3 previous = surface.vertices()[at(corners[2])] - corner;
    return 0.5 * next.cross(previous).norm();
}

double clampedWeight(double weight) {
    constexpr double kLargest = 1000.0;  // beyond, rounding would swamp the masses
    return std::clamp(weight, 0.0, kLargest);
}

std::size_t cornerOf(const Surface& surface, int face, int vertex) {
    const Triangle& corners = surface.faces()[at(face)];
    return corners[0] == vertex ? 0 : (corners[1] == vertex ? 1 : 2);
}

}  // namespace

SurfaceDiffusion::SurfaceDiffusion(const Surface& surface)
    : masses_(Eigen::VectorXd::Zero(surface.vertexCount())),
      weightSums_(Eigen::VectorXd::Zero(surface.vertexCount())) {
    offsets_.reserve(at(surface.vertexCount()) + 1);
    neighbours_.reserve(3 * at(surface.faceCount()));
    weights_.reserve(3 * at(surface.faceCount()));
    const auto addEdge = [&](int from, int to, double weight) {
        neighbours_.push_back(to);
        weights_.push_back(clampedWeight(weight));
        weightSums_[from] += weights_.back();
    };
    for (int v = 0; v < surface.vertexCount(); ++v) {
        offsets_.push_back(static_cast<int>(neighbours_.size()));
        const Surface::FaceRange fan = surface.facesAround(v);
        if (fan.empty()) {
            masses_[v] = 1.0;
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
            addEdge(v, surface.faces()[at(face)][(k + 1) % 3], weight);
            masses_[v] += areaOf(surface, face) / 3.0;
            before = face;
        }
        if (isOpen) {
            const std::size_t k = cornerOf(surface, before, v);
            const int last = surface.faces()[at(before)][(k + 2) % 3];
            addEdge(v, last, halfCotangent(surface, before, (k + 1) % 3));
        }
    }
    offsets_.push_back(static_cast<int>(neighbours_.size()));
}

/// product = (M + time L) values
template <int K>
void SurfaceDiffusion::multiply(
    const VertexValues<K>& values, double time, VertexValues<K>& product
) const {
    for (int v = 0; v < static_cast<int>(values.rows()); ++v) {
        const Eigen::Matrix<double, 1, K> own = values.row(v);
        Eigen::Matrix<double, 1, K> sum = weightSums_[v] * own;
        for (std::size_t i = at(offsets_[at(v)]); i < at(offsets_[at(v) + 1]); ++i) {
            sum -= weights_[i] * values.row(neighbours_[i]);
        }
        product.row(v) = masses_[v] * own + time * sum;
    }
}

/// Solves (M + time L) x = M values for each column, by conjugate gradients with the diagonal as
/// preconditioner.
template <int K>
VertexValues<K> SurfaceDiffusion::implicitStep(const VertexValues<K>& values, double time) const {
    using Row = Eigen::Array<double, 1, K>;
    constexpr double kTolerance = 1e-6;  // of the values, in the norm of the preconditioner
    constexpr int kMaxIterations = 2000;
    const auto inverseDiagonal = (masses_ + time * weightSums_).cwiseInverse().eval();
    const auto sums = [](const VertexValues<K>& a, const VertexValues<K>& b) {
        return Row(a.cwiseProduct(b).colwise().sum().array());
    };
    const VertexValues<K> right = masses_.asDiagonal() * values;
    VertexValues<K> preconditioned = inverseDiagonal.asDiagonal() * right;
    const Row enough = kTolerance * kTolerance * sums(right, preconditioned);

    VertexValues<K> solution = values;
    VertexValues<K> product(values.rows(), K);
    multiply<K>(solution, time, product);
    VertexValues<K> residual = right - product;
    preconditioned = inverseDiagonal.asDiagonal() * residual;
    VertexValues<K> direction = preconditioned;
    Row error = sums(residual, preconditioned);
    for (int i = 0; i < kMaxIterations && (error > enough).any(); ++i) {
        multiply<K>(direction, time, product);
        const Row curvature = sums(direction, product);
        const Row step = (error > enough).select(error / curvature, Row::Zero());
        solution += direction * step.matrix().asDiagonal();
        residual -= product * step.matrix().asDiagonal();
        preconditioned = inverseDiagonal.asDiagonal() * residual;
        const Row next = sums(residual, preconditioned);
        const Row turn = (error > enough).select(next / error, Row::Zero());
        direction = preconditioned + direction * turn.matrix().asDiagonal();
        error = next;
    }
    return solution;
}

template <int K>
VertexValues<K> SurfaceDiffusion::smoothed(const VertexValues<K>& values, double radius) const {
    if (radius <= 0.0) {
        return values;
    }
    // A disc has the variance radius^2 / 4 along each axis, diffusion for the time t has 2 t.
    const double time = radius * radius / 8.0;
    return implicitStep<K>(implicitStep<K>(values, 0.5 * time), 0.5 * time);
}

template VertexValues<1> SurfaceDiffusion::smoothed<1>(const VertexValues<1>&, double) const;
template VertexValues<9> SurfaceDiffusion::smoothed<9>(const VertexValues<9>&, double) const;

}  // namespace bspline_curve
