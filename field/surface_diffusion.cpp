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

/// product = (M + time L) values; returns values' product of each column.
template <int K>
Eigen::Array<double, 1, K> SurfaceDiffusion::multiply(
    const VertexValues<K>& values, double time, VertexValues<K>& product
) const {
    Eigen::Array<double, 1, K> dot = Eigen::Array<double, 1, K>::Zero();
    for (int v = 0; v < static_cast<int>(values.rows()); ++v) {
        const Eigen::Array<double, 1, K> own = values.row(v);
        Eigen::Array<double, 1, K> sum = weightSums_[v] * own;
        for (std::size_t i = at(offsets_[at(v)]); i < at(offsets_[at(v) + 1]); ++i) {
            sum -= weights_[i] * values.row(neighbours_[i]).array();
        }
        sum = masses_[v] * own + time * sum;
        product.row(v) = sum.matrix();
        dot += own * sum;
    }
    return dot;
}

/// Solves (M + time L) x = M values for each column, by conjugate gradients with the diagonal as
/// preconditioner. Memory is what takes the time, so each row is visited as seldom as can be.
template <int K>
VertexValues<K> SurfaceDiffusion::implicitStep(const VertexValues<K>& values, double time) const {
    using Row = Eigen::Array<double, 1, K>;
    constexpr double kTolerance = 1e-5;  // of the values, in the norm of the preconditioner
    constexpr int kMaxIterations = 2000;
    const Eigen::VectorXd inverseDiagonal = (masses_ + time * weightSums_).cwiseInverse();
    VertexValues<K> solution = values;
    VertexValues<K> product(values.rows(), K);
    static_cast<void>(multiply<K>(solution, time, product));
    VertexValues<K> residual(values.rows(), K);
    VertexValues<K> direction(values.rows(), K);
    Row error = Row::Zero();
    Row enough = Row::Zero();
    for (Eigen::Index v = 0; v < values.rows(); ++v) {
        const Row right = masses_[v] * values.row(v).array();
        const Row rest = right - product.row(v).array();
        residual.row(v) = rest.matrix();
        direction.row(v) = (inverseDiagonal[v] * rest).matrix();
        error += inverseDiagonal[v] * rest * rest;
        enough += kTolerance * kTolerance * inverseDiagonal[v] * right * right;
    }
    for (int i = 0; i < kMaxIterations && (error > enough).any(); ++i) {
        const Row curvature = multiply<K>(direction, time, product);
        const Row step = (error > enough).select(error / curvature, Row::Zero());
        Row next = Row::Zero();
        for (Eigen::Index v = 0; v < values.rows(); ++v) {
            solution.row(v).array() += step * direction.row(v).array();
            const Row rest = residual.row(v).array() - step * product.row(v).array();
            residual.row(v) = rest.matrix();
            next += inverseDiagonal[v] * rest * rest;
        }
        const Row turn = (error > enough).select(next / error, Row::Zero());
        for (Eigen::Index v = 0; v < values.rows(); ++v) {
            direction.row(v) =
                (inverseDiagonal[v] * residual.row(v).array() + turn * direction.row(v).array())
                    .matrix();
        }
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
