// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "field/elimination_order.h"
#include "surface/surface.h"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <memory>
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
    /// O(n log n). Throws Cancelled.
    explicit SurfaceDiffusion(const Surface& surface, const Progress& progress = {});

    /// Averages as over a disc of the given radius (the kernel has the variance of one); radius in
    /// the unit of the surface, >= 0. Constants stay what they are, integrals too, and so does what
    /// has no faces. Radii far below an edge change little. Within 1e-5 of the values' size.
    /// Conjugate gradients: O(n radius / edge length), and a direct solver for small components;
    /// half of the columns on a second thread where there are many vertices, with the same result.
    /// Throws Cancelled. Available for K = 1 and K = 9.
    template <int K>
    [[nodiscard]] VertexValues<K> smoothed(
        const VertexValues<K>& values, double radius, const Progress& progress = {}
    ) const;

private:
    template <int C>
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, C, C == 1 ? 0 : Eigen::RowMajor>;

    using Cholesky = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

    // A part of the surface that is less than the disc averaged over: it has little but one value,
    // which the incomplete factorisation below is far from. Each would take iterations of its own.
    struct SmallPart {
        std::vector<int> rows;
        std::unique_ptr<const Cholesky> factor;  ///< of its rows and columns of M + time L
    };

    // An incomplete Cholesky factorisation of M + time L.
    struct Factors {
        double time = 0.0;
        Eigen::VectorXd diagonal;  ///< of the matrix
        Eigen::VectorXd pivots;    ///< positive, since the matrix is diagonally dominant
        std::vector<SmallPart> smallParts;
        std::vector<bool> isSmall;  ///< whether a row is in one of them
    };

    struct FaceTerms;

    // The matrices, their rows in the order of vertexOf_.
    void assemble(
        const Surface& surface, const std::vector<FaceTerms>& terms, const Progress& progress
    );
    [[nodiscard]] std::vector<CoupledRows> strongEdges() const;
    void findParts();
    [[nodiscard]] Factors factorsFor(double time, const Progress& progress) const;
    [[nodiscard]] SmallPart smallPart(const std::vector<int>& rows, double time) const;
    template <int C>
    using ColumnsRef = Eigen::Ref<Columns<C>, 0, Eigen::OuterStride<>>;
    template <int C>
    class ImplicitStep;

    // Rows are vertices along a Morton curve, so that neighbours are near to each other in memory;
    // those that slivers couple strongly are in the order of eliminationOrder().
    std::vector<int> vertexOf_;    ///< #V; by row, as all below
    Eigen::VectorXd masses_;       ///< a third of the area of the faces at the vertex, else 1
    Eigen::VectorXd weightSums_;   ///< of the edges at the vertex
    std::vector<int> offsets_;     ///< #V + 1; the neighbours of i are from offsets_[i] on
    std::vector<int> middles_;     ///< #V; those after i are from middles_[i] on
    std::vector<int> neighbours_;  ///< #E twice; rows, for each in ascending order
    std::vector<double> weights_;  ///< of the edge to each neighbour
    // Parts that are not very large: rows that edges with a weight join, ascending.
    std::vector<std::vector<int>> parts_;
};

}  // namespace bspline_curve
