// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/faired_curve.h"

#include "design/curve_fairing.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bspline_curve {

FairedCurve::FairedCurve(
    const Surface& surface, const CurveProblem& problem, const ProjectedCurve& shadow
)
    : extended_(*problem.extended), shadow_(shadow) {
    std::optional<FairedParts> parts;
    // Nearest points on a sheet are no projection that a spline would be smooth under.
    if (shadow.isCarried()) {
        parts = fairedParts(surface, problem, shadow);
    }
    if (parts) {
        crossings_ = std::move(parts->crossings);
        pieces_ = std::move(parts->pieces);
    } else {
        crossings_ = shadow.crossings();
    }
}

SurfacePoint FairedCurve::at(double t) const {
    const auto found = std::ranges::lower_bound(pieces_, t, {}, &FairedPiece::to);
    if (found == pieces_.end() || found->face < 0 || found->to <= found->from) {
        return shadow_.at(t);
    }
    const FairedPiece& piece = *found;
    const double s = (t - piece.from) / (piece.to - piece.from);
    const Eigen::Vector2d uv = piece.uvAt(s, shadow_.splineAt(t).position);
    return onSurface(extended_, piece.face, {1.0 - uv[0] - uv[1], uv[0], uv[1]});
}

}  // namespace bspline_curve
