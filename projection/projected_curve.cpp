// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/projected_curve.h"

#include "projection/fibre_tracer.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
SurfacePoint crossingPoint(
    const TraceStart& traced,
    const PolynomialCurve& curve,
    double tau,
    const ShellCell& from,
    const ShellCell& to
) {
    Vec3 shadow = from.project(traced.shell, curve.at(tau)).shadow;
    const Triangle& face = traced.extended.faces[from.face];
    const Triangle& other = traced.extended.faces[to.face];
    for (int corner = 0; corner < 3; ++corner) {
        if (cornerOf(other, face[corner]) < 0) {
            shadow[corner] = 0.0;
        }
    }
    return onSurface(traced.extended, from.face, shadow);
}

CellTrace traceCells(
    const TraceStart& traced, const SplineSpace& space, const ControlPoints& controls
) {
    return traceCells(
        traced, space, controls, [](int, const PolynomialCurve&, const ShellCell&, double, double) {
        }
    );
}

ProjectedCurve::ProjectedCurve(
    const ExtendedSurface& extended,
    const Shell* shell,
    const SplineSpace& space,
    const ControlPoints& controls,
    CurveTrace trace
)
    : extended_(extended),
      shell_(shell),
      space_(space),
      controls_(controls),
      trace_(std::move(trace)) {
    polynomials_.reserve(space.spanCount());
    for (int span = 0; span < space.spanCount(); ++span) {
        polynomials_.push_back(space.polynomial(controls, span));
    }
}

SplinePoint ProjectedCurve::splineAt(double t) const {
    const int span = space_.spanAt(t);
    const double length = space_.spanLength(span);
    const auto [position, byTau] =
        polynomials_[span].withDerivativeAt((t - space_.breaks()[span]) / length);
    return {position, byTau / length};
}

Vec3 ProjectedCurve::secondDerivativeAt(double t) const {
    const int span = space_.spanAt(t);
    const double length = space_.spanLength(span);
    const double tau = (t - space_.breaks()[span]) / length;
    return polynomials_[span].secondDerivativeAt(tau) / (length * length);
}

SurfacePoint ProjectedCurve::at(double t) const {
    return std::visit([&](const auto& trace) { return on(trace, t); }, trace_);
}

SurfacePoint ProjectedCurve::on(const CellTrace& trace, double t) const {
    const auto found = std::ranges::lower_bound(trace.pieces, t, {}, &CellTrace::Piece::end);
    const CellTrace::Piece& piece = found == trace.pieces.end() ? trace.pieces.back() : *found;
    const double tau = (t - space_.breaks()[piece.span]) / space_.spanLength(piece.span);
    const ShellCell cell(*shell_, piece.tet, piece.foot, piece.face);
    const Vec3 position = space_.polynomial(controls_, piece.span).at(tau);
    return onSurface(extended_, cell.face, cell.project(*shell_, position).shadow);
}

SurfacePoint ProjectedCurve::on(const FibreTrace& trace, double t) const {
    const FootPoint foot = footAt(extended_, trace, space_, controls_, t);
    return onSurface(extended_, foot.face, foot.barycentric());
}

// On the segment between the two points of the trace beside it, in their common face.
SurfacePoint ProjectedCurve::on(const SheetTrace& trace, double t) const {
    const auto found = std::ranges::lower_bound(trace.pieces, t, {}, &SheetTrace::Piece::end);
    const std::ptrdiff_t i =
        std::min<std::ptrdiff_t>(found - trace.pieces.begin(), std::ssize(trace.pieces) - 1);
    const int face = trace.pieces[i].face;
    const Triangle& corners = extended_.faces[face];
    const auto coordinatesOf = [&](const SurfacePoint& point) {
        Vec3 coordinates = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const int corner = cornerOf(corners, extended_.faces[point.face][k]);
            if (corner >= 0) {
                coordinates[corner] = point.barycentric[k];
            }
        }
        return coordinates;
    };
    const EdgeCrossing& from = trace.points[i];
    const EdgeCrossing& to = trace.points[i + 1];
    const double length = to.parameter - from.parameter;
    const double share = length > 0.0 ? (t - from.parameter) / length : 0.0;
    return onSurface(
        extended_, face, (1.0 - share) * coordinatesOf(from.point) + share * coordinatesOf(to.point)
    );
}

}  // namespace bspline_curve
