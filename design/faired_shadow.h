// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/projected_curve.h"
#include "solver/curve_problem.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <vector>

namespace bspline_curve {

/// The part of a faired curve over one face, from one crossing or pick to the next. With P the
/// spline, s in [0, 1] the share of the piece, z the height of P over the face along the mean
/// normal, and uv its barycentric coordinates there along the same, the curve is at
///
///   uv(P) - (z(P) - lerp(heights, s)) (s - 1/2) twist + lerp(shifts, s)
///         + s (1 - s) ((1 - s) slopes[0] - s slopes[1]).
///
/// The first correction takes out what the turning normals add to its curvature, the second makes
/// it meet both ends, the third gives it the directions there. Without gradients it is straight.
struct FairedPiece {
    double from = 0.0, to = 0.0;  ///< parameters
    int face = -1;                ///< of the surface; -1: beyond its boundary, as the shadow is
    Vec3 u = Vec3::Zero(), v = Vec3::Zero(), z = Vec3::Zero();  ///< gradients of uv and z by P
    Eigen::Vector2d twist = Eigen::Vector2d::Zero();
    std::array<double, 2> heights{};
    std::array<Eigen::Vector2d, 2> shifts{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    std::array<Eigen::Vector2d, 2> slopes{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};

    /// uv at the share s, where the spline is at p.
    [[nodiscard]] Eigen::Vector2d uvAt(double s, const Vec3& p) const {
        const double bulge = z.dot(p) - std::lerp(heights[0], heights[1], s);
        return uvOf(p) - bulge * (s - 0.5) * twist + (1.0 - s) * shifts[0] + s * shifts[1] +
               s * (1.0 - s) * ((1.0 - s) * slopes[0] - s * slopes[1]);
    }

    /// Barycentric coordinates of a vector or point, without the face's origin.
    [[nodiscard]] Eigen::Vector2d uvOf(const Vec3& p) const { return {u.dot(p), v.dot(p)}; }
};

/// The shadow of a spline on a surface, as fair as the spline. Feet along fibres of a coarse mesh
/// are not: where fibres turn about the curve, they swing it to and fro as its height over the
/// faces changes, with a kink at every edge. Here crossings move along their edges, and pieces in a
/// face bend, until nothing is left of that. Faces and their order and picks stay as they are, the
/// curve stays within the distance tolerance of the spline wherever the shadow is, and does not
/// depend on how it is sampled.
class FairedShadow {
public:
    /// `shadow`: of a spline that solves `problem`; it must outlive this. O(n) for n crossings,
    /// about 4,000 instructions each.
    FairedShadow(const CurveProblem& problem, const ProjectedCurve& shadow);

    /// Where the curve passes from one face into the next, in order.
    [[nodiscard]] const std::vector<EdgeCrossing>& crossings() const { return crossings_; }

    /// The curve at t in [0, 1]. O(log n).
    [[nodiscard]] SurfacePoint at(double t) const;

private:
    const ExtendedSurface& extended_;
    const ProjectedCurve& shadow_;
    std::vector<EdgeCrossing> crossings_;
    std::vector<FairedPiece> pieces_;
};

}  // namespace bspline_curve
