// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_tracer.h"
#include "solver/spline_space.h"
#include "solver/traced_shell.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// The cells of a shell that a spline passes, and where its shadow passes from one face into the
/// next; both in order. It holds for that shell and spline only.
struct ShadowTrace {
    struct Piece {
        double end;  ///< parameter
        int span;
        int tet, foot, face;
    };

    struct Crossing {
        double parameter;
        SurfacePoint point;  ///< on the edge that is crossed, its face called as in the surface
    };

    bool isWhole = false;  ///< the spline lies in the shell; else the trace ends where it leaves
    int wholeSpans = 0;    ///< traced to their end
    std::vector<Piece> pieces;
    std::vector<Crossing> crossings;

    /// The faces passed, ghosts included, as the whole base calls them; one may come several times.
    [[nodiscard]] std::vector<int> faces(const TracedShell& traced) const;
};

/// The point at `curve(tau)` where a spline passes from one cell into one over another face.
[[nodiscard]] SurfacePoint crossingPoint(
    const TracedShell& traced,
    const PolynomialCurve& curve,
    double tau,
    const ShellCell& from,
    const ShellCell& to
);

/// Traces a whole spline; `onPiece` as in traceCurve().
template <class OnPiece>
[[nodiscard]] ShadowTrace traceShadow(
    const TracedShell& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    OnPiece&& onPiece
) {
    ShadowTrace trace;
    const auto parameter = [&](int span, double tau) {
        return space.breaks()[static_cast<std::size_t>(span)] + tau * space.spanLength(span);
    };
    trace.wholeSpans = traceCurve(
        traced,
        space,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            onPiece(span, curve, cell, tau0, tau1);
            trace.pieces.push_back({parameter(span, tau1), span, cell.tet, cell.foot, cell.face});
        },
        [&](int span,
            const PolynomialCurve& curve,
            const ShellCell& from,
            const ShellCell& to,
            double tau,
            int) {
            if (from.face != to.face) {
                trace.crossings.push_back(
                    {parameter(span, tau), crossingPoint(traced, curve, tau, from, to)}
                );
            }
        }
    );
    trace.isWhole = trace.wholeSpans == space.spanCount();
    return trace;
}

/// The shadow Q = M_S(P) of a spline on the surface, exactly: the spline cut at the shell's cells,
/// each piece carried to its face.
class ShadowCurve {
public:
    /// `space` and `controls` must outlive this, and so must what `traced` refers to.
    ShadowCurve(const TracedShell& traced, const SplineSpace& space, const ControlPoints& controls);

    /// The same with a trace of this spline in this shell; without one it is made.
    ShadowCurve(
        const TracedShell& traced,
        const SplineSpace& space,
        const ControlPoints& controls,
        std::optional<ShadowTrace> trace
    );

    /// Whether the spline lies in the shell. If not, there is no shadow.
    [[nodiscard]] bool isWhole() const { return trace_.isWhole; }

    /// Where the shadow passes from one face into the next, in order.
    [[nodiscard]] const std::vector<ShadowTrace::Crossing>& crossings() const {
        return trace_.crossings;
    }

    /// The faces that it passes, as ShadowTrace::faces().
    [[nodiscard]] std::vector<int> faces() const { return trace_.faces(traced_); }

    /// The shadow at t in [0, 1].
    [[nodiscard]] SurfacePoint at(double t) const;

private:
    TracedShell traced_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    ShadowTrace trace_;
};

}  // namespace bspline_curve
