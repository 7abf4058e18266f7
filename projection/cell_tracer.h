// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/trace_start.h"
#include "shell/polynomial_trace.h"
#include "spline/spline_space.h"

#include <optional>

namespace bspline_curve {

/// The cell at the start of a curve, found by walking from the first pick, near which every curve
/// starts. Nothing where that walk leaves the shell.
[[nodiscard]] inline std::optional<TraceState> startOfCurve(
    const TraceStart& traced, const SplineSpace& space, const ControlPoints& controls
) {
    TraceState state{ShellCell(traced.shell, traced.start)};
    const Vec3 start = space.polynomial(controls, 0).coefficients[0];
    return walkStraight(traced.shell, traced.startPosition, start, state) ? std::optional(state)
                                                                          : std::nullopt;
}

/// Traces a whole spline: onPiece(span, curve, cell, tau0, tau1), onCrossing(span, curve, from, to,
/// tau, wall). Returns the number of spans traced to their end; fewer than all where the curve
/// leaves the shell.
template <class OnPiece, class OnCrossing>
int traceCurve(
    const TraceStart& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    OnPiece&& onPiece,
    OnCrossing&& onCrossing
) {
    std::optional<TraceState> state = startOfCurve(traced, space, controls);
    if (!state) {
        return 0;
    }
    for (int span = 0; span < space.spanCount(); ++span) {
        const PolynomialCurve curve = space.polynomial(controls, span);
        const bool inside = tracePolynomial(
            traced.shell,
            curve,
            1.0,
            *state,
            [&](const ShellCell& cell, double tau0, double tau1) {
                onPiece(span, curve, cell, tau0, tau1);
            },
            [&](const ShellCell& from, const ShellCell& to, double tau, int wall) {
                onCrossing(span, curve, from, to, tau, wall);
            }
        );
        if (!inside) {
            return span;
        }
    }
    return space.spanCount();
}

}  // namespace bspline_curve
