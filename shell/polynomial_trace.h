// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_cell.h"
#include "spline/polynomial_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve {

/// Where a traced curve stands.
struct TraceState {
    ShellCell cell;
    /// Crossings of the shell while the curve hardly moves, to bound walks around an edge or a
    /// vertex.
    int stalled = 0;

    /// That of cells; more where a walk stalls, because cells thinner than 1e-4 of the diagonal
    /// round more, so that each of two neighbours may hand a point to the other.
    [[nodiscard]] double tolerance() const;
};

/// A cell holds points whose wall forms are above minus this: rounding of the affine maps of a cell
/// whose height is 1e-4 of the diagonal, with a margin.
inline constexpr double kCellTolerance = 1e-10;

/// First parameter in (0, end] where p(s) + tolerance changes from non-negative to negative; `end`
/// if there is none. p is given by coefficients up to `degree`; 0 where p(0) + tolerance is
/// negative already.
[[nodiscard]] double firstExit(
    const double* coefficients, int degree, double end, double tolerance = kCellTolerance
);

/// Where a curve leaves a cell.
struct CellExit {
    double s;
    int wall;  ///< -1: nowhere up to s
};

/// First exit of a curve from a cell in [0, end]; s = 0 where it is outside already. Bit k of
/// `ignoredWalls` leaves wall k out.
[[nodiscard]] CellExit firstExitOf(
    const ShellCell& cell,
    const PolynomialCurve& curve,
    double end,
    unsigned ignoredWalls,
    double tolerance = kCellTolerance
);

/// How much s grows at least where a curve moves by the tolerance of cells; infinite for a curve
/// that stays at one point.
[[nodiscard]] inline double leastProgressOf(const PolynomialCurve& curve, double end) {
    double highestSpeed = 0.0;
    double power = 1.0;
    for (int j = 1; j <= curve.degree; ++j) {
        highestSpeed += j * power * curve.coefficients[j].norm();
        power *= end;
    }
    return kCellTolerance / highestSpeed;
}

/// Cuts p(s), s in [0, end], exactly where it passes from one cell into the next, starting in
/// state.cell. Calls onPiece(cell, s0, s1) for each piece in order and onCrossing(from, to, s,
/// wall) between two pieces, with the wall of `from` that is crossed. Returns true at the end with
/// state.cell holding p(end); false where the curve leaves the shell. Costs about 0.1 us per piece.
template <class OnPiece, class OnCrossing>
bool tracePolynomial(
    const Shell& shell,
    const PolynomialCurve& curve,
    double end,
    TraceState& state,
    OnPiece&& onPiece,
    OnCrossing&& onCrossing
) {
    // A walk that turns this often while the curve moves by less than the tolerance of cells goes
    // round in a circle: between sheets that almost touch, it once took millions of turns.
    constexpr int kMaxStalled = 128;
    const double leastProgress = leastProgressOf(curve, end);
    double s = 0.0;
    double lastProgress = 0.0;
    unsigned ignoredWalls = 0;
    // The cells of the two sides of a crossing, in turn.
    ShellCell other;
    ShellCell* here = &state.cell;
    ShellCell* after = &other;
    const auto stopHere = [&](bool inside) {
        if (here != &state.cell) {
            state.cell = *here;
        }
        return inside;
    };
    while (true) {
        const CellExit exit = firstExitOf(
            *here, s == 0.0 ? curve : curve.shifted(s), end - s, ignoredWalls, state.tolerance()
        );
        const double next = exit.wall < 0 ? end : s + exit.s;
        if (next > s) {
            onPiece(std::as_const(*here), s, next);
        }
        if (next - lastProgress > leastProgress) {
            lastProgress = next;
            state.stalled = 0;
        } else if (exit.wall >= 0 && ++state.stalled > kMaxStalled) {
            return stopHere(false);
        }
        if (exit.wall < 0) {
            return stopHere(true);
        }
        s = next;
        const Entry entry = after->enter(shell, *here, exit.wall);
        if (entry == Entry::Outside) {
            return stopHere(false);
        }
        if (entry == Entry::Lost) {
            // Where faces and tetrahedra end together, as over a crease, another wall comes first.
            const std::optional<ShellCell> found = ShellCell::find(shell, after->tet, curve.at(s));
            if (!found) {
                return stopHere(false);
            }
            if (found->isSame(*here)) {
                ignoredWalls |= 1U << static_cast<unsigned>(exit.wall);
                continue;
            }
            *after = *found;
        }
        onCrossing(std::as_const(*here), std::as_const(*after), s, exit.wall);
        std::swap(here, after);
        ignoredWalls = 0;
    }
}

/// Walks from one point to another in a straight line, starting in state.cell. Returns whether the
/// walk stays in the shell; state.cell then holds `to`, and its shadow is M_S(to).
bool walkStraight(const Shell& shell, const Vec3& from, const Vec3& to, TraceState& state);

}  // namespace bspline_curve
