// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/faired_shadow.h"

#include "design/shadow_fairing.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bspline_curve {

FairedShadow::FairedShadow(const CurveProblem& problem, const ProjectedCurve& shadow)
    : extended_(*problem.extended), shadow_(shadow) {
    std::optional<FairedParts> parts;
    // Nearest points on a sheet are no projection that a spline would be smooth under.
    if (shadow.isCarried()) {
        parts = fairedParts(problem, shadow);
    }
    if (parts) {
        crossings_ = std::move(parts->crossings);
        pieces_ = std::move(parts->pieces);
    } else {
        crossings_ = shadow.crossings();
    }
}

SurfacePoint FairedShadow::at(double t) const {
    const auto found = std::ranges::lower_bound(pieces_, t, {}, &FairedPiece::to);
    if (found == pieces_.end() || found->face < 0) {
        return shadow_.at(t);
    }
    const FairedPiece& piece = *found;
    const double length = piece.to - piece.from;
    const double s = length > 0.0 ? (t - piece.from) / length : 0.0;
    const Eigen::Vector2d uv = piece.uvAt(s, shadow_.splineAt(t).position);
    return onSurface(extended_, piece.face, {1.0 - uv[0] - uv[1], uv[0], uv[1]});
}

}  // namespace bspline_curve
