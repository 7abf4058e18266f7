// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/shadow_curve.h"

#include "solver/curve_tracer.h"
#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Clears rounding: a point that a cell holds has coordinates in [0, 1] up to the cell's tolerance.
Vec3 clamped(Vec3 barycentric) {
    barycentric = barycentric.cwiseMax(0.0);
    return barycentric / barycentric.sum();
}

}  // namespace

ShadowCurve::ShadowCurve(
    const TracedShell& traced, const SplineSpace& space, const ControlPoints& controls
)
    : traced_(traced), space_(space), controls_(controls) {
    const auto parameter = [&](int span, double tau) {
        return space.breaks()[bspline_curve::at(span)] + tau * space.spanLength(span);
    };
    const int spans = traceCurve(
        traced,
        space,
        controls,
        [&](int span, const PolynomialCurve&, const ShellCell& cell, double, double tau1) {
            pieces_.push_back({parameter(span, tau1), span, cell.tet, cell.foot, cell.face});
        },
        [&](int span,
            const PolynomialCurve& curve,
            const ShellCell& from,
            const ShellCell& to,
            double tau,
            int) {
            if (from.face == to.face) {
                return;
            }
            Vec3 shadow = from.shadow(curve.at(tau));
            const Triangle& face = traced_.base.faces[bspline_curve::at(from.face)];
            const Triangle& other = traced_.base.faces[bspline_curve::at(to.face)];
            for (int corner = 0; corner < 3; ++corner) {
                if (cornerOf(other, face[bspline_curve::at(corner)]) < 0) {
                    shadow[corner] = 0.0;
                }
            }
            crossings_.push_back({parameter(span, tau), toSurface(from.face, clamped(shadow))});
        }
    );
    isWhole_ = spans == space.spanCount();
}

std::vector<int> ShadowCurve::faces() const {
    std::vector<int> faces;
    for (const Piece& piece : pieces_) {
        if (faces.empty() || faces.back() != piece.face) {
            faces.push_back(piece.face);
        }
    }
    return faces;
}

SurfacePoint ShadowCurve::toSurface(int face, const Vec3& shadow) const {
    const ShellBase& base = traced_.base;
    if (!traced_.shell.isGhost(face)) {
        return named({face, shadow});
    }
    // A ghost triangle collapses onto the boundary edge that it grew from.
    int inner = face;
    while (traced_.shell.isGhost(inner)) {
        inner = base.faceNeighbours[bspline_curve::at(inner)][2];
    }
    SurfacePoint point{inner, Vec3::Zero()};
    for (int corner = 0; corner < 3; ++corner) {
        const int vertex =
            base.surfaceVertex(base.faces[bspline_curve::at(face)][bspline_curve::at(corner)]);
        point.barycentric[cornerOf(base.faces[bspline_curve::at(inner)], vertex)] += shadow[corner];
    }
    return named(point);
}

SurfacePoint ShadowCurve::named(SurfacePoint point) const {
    point.face = traced_.nameOf(point.face);
    return point;
}

SurfacePoint ShadowCurve::at(double t) const {
    const auto found =
        std::lower_bound(pieces_.begin(), pieces_.end(), t, [](const Piece& piece, double value) {
            return piece.end < value;
        });
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    const double tau =
        (t - space_.breaks()[bspline_curve::at(piece.span)]) / space_.spanLength(piece.span);
    const ShellCell cell(traced_.shell, piece.tet, piece.foot, piece.face);
    return toSurface(
        cell.face, clamped(cell.shadow(space_.polynomial(controls_, piece.span).at(tau)))
    );
}

}  // namespace bspline_curve
