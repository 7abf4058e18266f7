// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/cell_tracer.h"
#include "projection/curve_trace.h"
#include "spline/spline_space.h"

#include <variant>
#include <vector>

namespace bspline_curve {

/// The point at `curve(tau)` where a spline passes from one cell into one over another face.
[[nodiscard]] SurfacePoint crossingPoint(
    const TraceStart& traced,
    const PolynomialCurve& curve,
    double tau,
    const ShellCell& from,
    const ShellCell& to
);

/// Traces a whole spline through the cells of a shell; `onPiece` as in traceCurve().
template <class OnPiece>
[[nodiscard]] CellTrace traceCells(
    const TraceStart& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    OnPiece&& onPiece
) {
    CellTrace trace;
    const auto parameter = [&](int span, double tau) {
        return space.breaks()[span] + tau * space.spanLength(span);
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

/// The same, of the pieces alone.
[[nodiscard]] CellTrace traceCells(
    const TraceStart& traced, const SplineSpace& space, const ControlPoints& controls
);

/// A point of a spline in the shell's frame, and the derivative by its parameter.
struct SplinePoint {
    Vec3 position = Vec3::Zero(), derivative = Vec3::Zero();
};

/// The shadow Q = M_S(P) of a spline on the surface: the spline cut where its shadow crosses edges,
/// each piece carried to its face, through the cells of a shell or along the fibres.
class ProjectedCurve {
public:
    /// Refers to all but the trace. `shell`: null for a trace along the fibres. `trace`: whole, of
    /// this spline, in that shell or over the extended surface.
    ProjectedCurve(
        const ExtendedSurface& extended,
        const Shell* shell,
        const SplineSpace& space,
        const ControlPoints& controls,
        CurveTrace trace
    );

    /// Where the shadow passes from one face into the next, in order.
    [[nodiscard]] const std::vector<EdgeCrossing>& crossings() const {
        return progressOf(trace_).crossings;
    }

    /// The shadow at t in [0, 1].
    [[nodiscard]] SurfacePoint at(double t) const;

    /// The face of the extended surface that the shadow has there.
    [[nodiscard]] int faceAt(double t) const { return bspline_curve::faceAt(trace_, t); }

    /// The spline itself there.
    [[nodiscard]] SplinePoint splineAt(double t) const;

    /// Its second derivative by t there.
    [[nodiscard]] Vec3 secondDerivativeAt(double t) const;

    /// Whether the shadow is carried along directions that change continuously, by fibres or cells.
    [[nodiscard]] bool isCarried() const { return !std::holds_alternative<SheetTrace>(trace_); }

private:
    [[nodiscard]] SurfacePoint on(const CellTrace& trace, double t) const;
    [[nodiscard]] SurfacePoint on(const FibreTrace& trace, double t) const;
    [[nodiscard]] SurfacePoint on(const SheetTrace& trace, double t) const;

    const ExtendedSurface& extended_;
    const Shell* shell_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    CurveTrace trace_;
    std::vector<PolynomialCurve> polynomials_;  // of the spline, by span
};

}  // namespace bspline_curve
