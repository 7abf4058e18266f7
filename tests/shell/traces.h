// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/polynomial_trace.h"

#include <functional>
#include <vector>

namespace bspline_curve::test_support {

/// Walks from a point of the surface to height w of its fibre, as curves do: straight where that
/// stays inside, else along the fibre in shorter and shorter steps. Returns whether it arrives; the
/// state holds the end then.
[[nodiscard]] bool walkUp(
    const Shell& shell,
    const ExtendedSurface& extended,
    const SurfacePoint& point,
    double w,
    TraceState& state
);

struct Piece {
    ShellCell cell;
    double from, to;
};

struct Trace {
    bool inside = false;
    std::vector<Piece> pieces;
    ShellCell last;
};

/// What is expected of the two cells on both sides of a wall at a parameter of the curve.
using OnCrossing = std::function<void(const ShellCell&, const ShellCell&, double, int)>;

/// Traces a curve for s in [0, end] and expects what holds for each: pieces follow each other
/// without gaps, are cut where cells change, and lie in their cells.
[[nodiscard]] Trace traced(
    const Shell& shell,
    const PolynomialCurve& curve,
    double end,
    const ShellCell& start,
    const OnCrossing& onCrossing
);

}  // namespace bspline_curve::test_support
