// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <Eigen/Core>

#include <vector>

namespace bspline_curve {

/// #V by K values, those of one vertex beside each other.
template <int K>
using VertexValues = Eigen::Matrix<double, Eigen::Dynamic, K, K == 1 ? 0 : Eigen::RowMajor>;

/// Averages values at the vertices over their surroundings within the surface, by diffusion for a
/// while: linear finite elements with lumped masses, two implicit steps. Weights of edges are
/// cotangents, clamped to [0, 1000], so that obtuse faces make no new extrema and slivers no
/// trouble.
class SurfaceDiffusion {
public:
    /// O(n).
    explicit SurfaceDiffusion(const Surface& surface);

    /// Averages as over a disc of the given radius (the kernel has the variance of one); radius in
    /// the unit of the surface, >= 0. Constants stay what they are, integrals too, and so does what
    /// has no faces. Radii far below an edge change little. Within 1e-5 of the values' size.
    /// Conjugate gradients: O(n radius / edge length). Available for K = 1 and K = 9.
    template <int K>
    [[nodiscard]] VertexValues<K> smoothed(const VertexValues<K>& values, double radius) const;

private:
    template <int K>
    [[nodiscard]] VertexValues<K> implicitStep(const VertexValues<K>& values, double time) const;
    template <int K>
    Eigen::Array<double, 1, K> multiply(
        const VertexValues<K>& values, double time, VertexValues<K>& product
    ) const;

    Eigen::VectorXd masses_;       ///< #V; a third of the area of the faces at the vertex, else 1
    Eigen::VectorXd weightSums_;   ///< #V; of the edges at the vertex
    std::vector<int> offsets_;     ///< #V + 1; the neighbours of v are from offsets_[v] on
    std::vector<int> neighbours_;  ///< #E twice
    std::vector<double> weights_;  ///< of the edge to each neighbour
};

}  // namespace bspline_curve
