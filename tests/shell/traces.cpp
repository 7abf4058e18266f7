// SPDX-License-Identifier: GPL-3.0-or-later
#include "traces.h"

#include "shell/extended_surface.h"

#include <gtest/gtest.h>

namespace bspline_curve::test_support {
namespace {

// Of the way along a fibre between two heights: straight, else in two halves, so that where the
// shell's top or bottom is not convex steps become as short as the fibre's straight pieces.
constexpr int kMostHalvings = 16;

}  // namespace

bool walkUp(
    const Shell& shell,
    const ExtendedSurface& extended,
    const SurfacePoint& point,
    double w,
    TraceState& state
) {
    state = {ShellCell(shell, point)};
    Vec3 here = extended.position(point);
    const double start = state.cell.height.at(here);
    const int steps = 1 << kMostHalvings;
    int done = 0;
    int step = steps;
    while (done < steps) {
        const Vec3 next = shell.lift(point, start + (w - start) * (done + step) / steps);
        TraceState after = state;
        if (walkStraight(shell, here, next, after)) {
            state = after;
            here = next;
            done += step;
            continue;
        }
        if (step == 1) {
            return false;
        }
        step /= 2;
    }
    return true;
}

Trace traced(
    const Shell& shell,
    const PolynomialCurve& curve,
    double end,
    const ShellCell& start,
    const OnCrossing& onCrossing
) {
    constexpr double kRounding = 1e-9;
    Trace trace;
    TraceState state{start};
    double now = 0.0;
    trace.inside = tracePolynomial(
        shell,
        curve,
        end,
        state,
        [&](const ShellCell& cell, double from, double to) {
            EXPECT_EQ(from, now);
            EXPECT_LT(from, to);
            now = to;
            trace.pieces.push_back({cell, from, to});
        },
        [&](const ShellCell& from, const ShellCell& to, double s, int wall) {
            EXPECT_EQ(s, now);
            onCrossing(from, to, s, wall);
        }
    );
    trace.last = state.cell;
    if (trace.inside) {
        EXPECT_EQ(now, end);
        EXPECT_GE(trace.last.insideness(curve.at(end)), -kRounding);
    }
    for (const Piece& piece : trace.pieces) {
        for (int i = 0; i <= 16; ++i) {
            const double s = piece.from + (piece.to - piece.from) * i / 16.0;
            EXPECT_GE(piece.cell.insideness(curve.at(s)), -kRounding);
        }
    }
    return trace;
}

}  // namespace bspline_curve::test_support
