// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "solver/curve_problem.h"
#include "solver/initial_curve.h"
#include "spline/symmetric_matrix.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bspline_curve::benchmarks {

/// A polyline whose vertices are the unknowns (degree 1), with their foot points.
struct FootedPolyline {
    std::vector<Vec3> points;  ///< in the shell's frame
    std::vector<FootPoint> feet;
    std::vector<FootFrame> frames;
};

/// The energy of SampledIntegrals, without a field, of a polyline: derivatives by t become
/// differences between neighbouring vertices, and the vertices are the samples of the distance.
/// Vertices at picks stay where they are. For surfaces without boundary.
class PolylineEnergy {
public:
    /// About `count` vertices, evenly by parameter between picks. Refers to the problem.
    PolylineEnergy(const CurveProblem& problem, int count);

    [[nodiscard]] int count() const { return static_cast<int>(vertices_.size()); }

    /// Vertices on a initial path, with the feet that belong to them.
    [[nodiscard]] FootedPolyline along(
        const InitialPath& initialPath, const FibreProjector& finder
    ) const;

    /// Finds all feet anew.
    void follow(const FibreProjector& finder, FootedPolyline& line) const;

    struct Terms {
        double internal = 0.0, distance = 0.0;

        [[nodiscard]] double total(double alpha) const { return internal + alpha * distance; }
    };

    /// With bending along the directions of `frozen` (one frame per vertex) left out.
    [[nodiscard]] Terms terms(
        const FootedPolyline& line, const std::vector<FootFrame>& frozen
    ) const;

    /// Blocks of the Hessian by vertex i: with itself, and with the first and second vertex after
    /// it (cyclic where the polyline is closed).
    using Blocks = std::array<SymmetricMatrix, 3>;

    /// Gradient and Hessian, the polyline's own directions frozen. `turning`: see SampledIntegrals.
    void differentiate(
        const FootedPolyline& line,
        double alpha,
        double turning,
        Eigen::VectorXd& gradient,
        std::vector<Blocks>& hessian
    ) const;

    [[nodiscard]] double largestHeight(const FootedPolyline& line) const;

    [[nodiscard]] bool isFixed(int vertex) const { return vertices_[vertex].pick >= 0; }

    [[nodiscard]] bool isClosed() const { return problem_.options.closed; }

    /// Index of the vertex so many after one.
    [[nodiscard]] int after(int vertex, int steps) const { return (vertex + steps) % count(); }

private:
    struct Vertex {
        double parameter;  // t
        double step;       // of t, to the vertex after it; 0 where there is none
        double weight;     // of the quadrature over [0, 1]
        int pick;          // that it is, or -1
    };

    // The second derivative at the vertex after `first`, by three vertices from there on.
    struct Stencil {
        std::array<double, 3> factors;
        double weight;  // of bending in E_int
    };

    void placeVertices(int count);

    [[nodiscard]] int stencilCount() const { return isClosed() ? count() : count() - 2; }

    [[nodiscard]] int segmentCount() const { return isClosed() ? count() : count() - 1; }

    [[nodiscard]] Stencil stencil(int first) const;
    [[nodiscard]] Vec3 secondDerivative(const FootedPolyline& line, int first) const;
    void addBending(
        const FootedPolyline& line, Eigen::VectorXd& gradient, std::vector<Blocks>& hessian
    ) const;
    void addTension(
        const FootedPolyline& line, Eigen::VectorXd& gradient, std::vector<Blocks>& hessian
    ) const;

    const CurveProblem& problem_;
    double heightUnit_;
    double bending_, stretching_;  // weights of |P''|^2 and |P'|^2 in E_int
    double normalShare_;           // of bending along the pillar directions that does not count
    std::vector<Vertex> vertices_;
};

}  // namespace bspline_curve::benchmarks
