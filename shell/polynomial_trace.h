// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {

inline constexpr int kMaxPolynomialDegree = 4;

/// A polynomial curve p(s) = sum c_j s^j.
struct PolynomialCurve {
    int degree = 3;
    std::array<Vec3, kMaxPolynomialDegree + 1> coefficients;

    [[nodiscard]] Vec3 at(double s) const {
        Vec3 value = coefficients[static_cast<std::size_t>(degree)];
        for (int j = degree; j-- > 0;) {
            value = value * s + coefficients[static_cast<std::size_t>(j)];
        }
        return value;
    }

    /// The first derivative at s.
    [[nodiscard]] Vec3 derivativeAt(double s) const {
        Vec3 value = degree * coefficients[static_cast<std::size_t>(degree)];
        for (int j = degree - 1; j > 0; --j) {
            value = value * s + j * coefficients[static_cast<std::size_t>(j)];
        }
        return value;
    }

    /// The second derivative at s.
    [[nodiscard]] Vec3 secondDerivativeAt(double s) const {
        Vec3 value = degree * (degree - 1) * coefficients[static_cast<std::size_t>(degree)];
        for (int j = degree - 1; j > 1; --j) {
            value = value * s + j * (j - 1) * coefficients[static_cast<std::size_t>(j)];
        }
        return value;
    }

    /// The same curve with s measured from `origin`.
    [[nodiscard]] PolynomialCurve shifted(double origin) const;
};

/// Where a traced curve stands.
struct TraceState {
    ShellCell cell;
    /// Crossings of the shell without progress in s, to bound walks around a vertex.
    int stalled = 0;
};

/// A tetrahedron holds points whose barycentric coordinates are above minus this: rounding of the
/// affine maps of a cell whose height is 1e-4 of the diagonal, with a margin.
inline constexpr double kCellTolerance = 1e-10;

/// First parameter in (0, end] where p(s) + tolerance changes from non-negative to negative; `end`
/// if there is none. p is given by coefficients up to `degree`; 0 where p(0) + tolerance is
/// negative already.
[[nodiscard]] double firstExit(const double* coefficients, int degree, double end);

/// A barycentric coordinate of a cell along a curve: a polynomial.
struct CellCoordinate {
    std::array<double, kMaxPolynomialDegree + 1> coefficients{};

    CellCoordinate() = default;

    CellCoordinate(const ShellCell& cell, int k, const PolynomialCurve& curve) {
        const Vec3& gradient = cell.gradients[static_cast<std::size_t>(k)];
        for (std::size_t j = 0; j <= static_cast<std::size_t>(curve.degree); ++j) {
            coefficients[j] = gradient.dot(curve.coefficients[j]);
        }
        coefficients[0] += cell.offsets[static_cast<std::size_t>(k)];
    }

    /// Where the tangent at 0 reaches zero; infinite where it does not fall.
    [[nodiscard]] double linearExit() const {
        return coefficients[1] < 0.0 ? -coefficients[0] / coefficients[1]
                                     : std::numeric_limits<double>::infinity();
    }
};

/// Cuts p(s), s in [0, end], exactly where it passes from one tetrahedron into the next, starting
/// in state.cell. Calls onPiece(cell, s0, s1) for each piece in order and onCrossing(from, to, s,
/// k) between two pieces, k being the vertex of `from` opposite to the face crossed. Returns true
/// at the end with state.cell holding p(end); false where the curve leaves the shell. Costs about
/// 0.1 us per piece.
template <class OnPiece, class OnCrossing>
bool tracePolynomial(
    const Shell& shell,
    const PolynomialCurve& curve,
    double end,
    TraceState& state,
    OnPiece&& onPiece,
    OnCrossing&& onCrossing
) {
    // A walk that turns this often at one parameter goes round in a circle.
    constexpr int kMaxStalled = 64;
    double s = 0.0;
    while (true) {
        const PolynomialCurve here = s == 0.0 ? curve : curve.shifted(s);
        const ShellCell& cell = state.cell;
        std::array<CellCoordinate, 4> lambda;
        int nearest = 0;
        for (int k = 0; k < 4; ++k) {
            lambda[static_cast<std::size_t>(k)] = CellCoordinate(cell, k, here);
            if (lambda[static_cast<std::size_t>(k)].linearExit() <
                lambda[static_cast<std::size_t>(nearest)].linearExit()) {
                nearest = k;
            }
        }
        // The face that the tangent leaves by first bounds the search for the others.
        double exit = end - s;
        int exitFace = -1;
        for (int i = 0; i < 4; ++i) {
            const int k = (nearest + i) % 4;
            const CellCoordinate& coordinate = lambda[static_cast<std::size_t>(k)];
            const double candidate = firstExit(coordinate.coefficients.data(), here.degree, exit);
            if (candidate < exit) {
                exit = candidate;
                exitFace = k;
            }
        }
        const double next = exitFace < 0 ? end : s + exit;
        if (next > s) {
            onPiece(cell, s, next);
            state.stalled = 0;
        } else if (exitFace >= 0 && ++state.stalled > kMaxStalled) {
            return false;
        }
        if (exitFace < 0) {
            return true;
        }
        const int neighbour = shell.neighbour(cell.tet, exitFace);
        if (neighbour < 0) {
            return false;
        }
        const ShellCell after(shell, neighbour);
        onCrossing(cell, after, next, exitFace);
        state.cell = after;
        s = next;
    }
}

}  // namespace bspline_curve
