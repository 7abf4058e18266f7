// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shadow_curve.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <utility>

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

SurfacePoint toSurface(const TracedShell& traced, int face, const Vec3& shadow) {
    const ShellBase& base = traced.base;
    if (!traced.shell.isGhost(face)) {
        return {traced.nameOf(face), shadow};
    }
    // A ghost triangle collapses onto the boundary edge that it grew from.
    int inner = face;
    while (traced.shell.isGhost(inner)) {
        inner = base.faceNeighbours[at(inner)][2];
    }
    SurfacePoint point{traced.nameOf(inner), Vec3::Zero()};
    for (int corner = 0; corner < 3; ++corner) {
        const int vertex = base.surfaceVertex(base.faces[at(face)][at(corner)]);
        point.barycentric[cornerOf(base.faces[at(inner)], vertex)] += shadow[corner];
    }
    return point;
}

ShadowTrace traceOf(
    const TracedShell& traced, const SplineSpace& space, const ControlPoints& controls
) {
    return traceShadow(
        traced, space, controls, [](int, const PolynomialCurve&, const ShellCell&, double, double) {
        }
    );
}

}  // namespace

std::vector<int> ShadowTrace::faces(const TracedShell& traced) const {
    std::vector<int> faces;
    for (const Piece& piece : pieces) {
        const int face = traced.nameOf(piece.face);
        if (faces.empty() || faces.back() != face) {
            faces.push_back(face);
        }
    }
    return faces;
}

SurfacePoint crossingPoint(
    const TracedShell& traced,
    const PolynomialCurve& curve,
    double tau,
    const ShellCell& from,
    const ShellCell& to
) {
    Vec3 shadow = from.shadow(curve.at(tau));
    const Triangle& face = traced.base.faces[at(from.face)];
    const Triangle& other = traced.base.faces[at(to.face)];
    for (int corner = 0; corner < 3; ++corner) {
        if (cornerOf(other, face[at(corner)]) < 0) {
            shadow[corner] = 0.0;
        }
    }
    return toSurface(traced, from.face, clamped(shadow));
}

ShadowCurve::ShadowCurve(
    const TracedShell& traced, const SplineSpace& space, const ControlPoints& controls
)
    : ShadowCurve(traced, space, controls, std::nullopt) {}

ShadowCurve::ShadowCurve(
    const TracedShell& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    std::optional<ShadowTrace> trace
)
    : traced_(traced),
      space_(space),
      controls_(controls),
      trace_(trace ? std::move(*trace) : traceOf(traced, space, controls)) {}

SurfacePoint ShadowCurve::at(double t) const {
    const std::vector<ShadowTrace::Piece>& pieces = trace_.pieces;
    const auto found =
        std::ranges::lower_bound(pieces, t, {}, [](const auto& piece) { return piece.end; });
    const ShadowTrace::Piece& piece = found == pieces.end() ? pieces.back() : *found;
    const double tau =
        (t - space_.breaks()[bspline_curve::at(piece.span)]) / space_.spanLength(piece.span);
    const ShellCell cell(traced_.shell, piece.tet, piece.foot, piece.face);
    return toSurface(
        traced_, cell.face, clamped(cell.shadow(space_.polynomial(controls_, piece.span).at(tau)))
    );
}

}  // namespace bspline_curve
