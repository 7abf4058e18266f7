// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// A point of a curve on a surface, as morphometrics and machines want it.
struct CurvePoint {
    SurfacePoint place;
    Vec3 position = Vec3::Zero();
    double distance = 0.0;  ///< along the polyline, from the curve's start
    /// Unit vectors: along the curve; the surface's normal, made perpendicular to it; to the left
    /// of the curve, seen with the normal upwards. Zero where the surface has no normal.
    Vec3 tangent = Vec3::Zero(), normal = Vec3::Zero(), left = Vec3::Zero();
    double curvature = 0.0;          ///< 1 / radius, >= 0
    double normalCurvature = 0.0;    ///< its part along the normal
    double geodesicCurvature = 0.0;  ///< its part to the left
};

/// Points at distances along curves of one mesh.
class CurvePoints {
public:
    /// The mesh must outlive this. O(n).
    explicit CurvePoints(const TriangleMesh& mesh);

    /// One point for each distance, in [0, length]; a closed curve takes any, and begins anew after
    /// its length. Tangent and curvature are those of the spline, where that is smooth; else those
    /// of the parabola through the point and two others, 1 % of the length away, which on an open
    /// curve are farther inwards near its ends. O(m log n) for m points. Throws InputError
    /// (BadOption) where a distance is not on the curve.
    [[nodiscard]] std::vector<CurvePoint> at(
        const SurfacePolyline& line, const SplineData* spline, std::span<const double> distances
    ) const;

private:
    [[nodiscard]] SurfacePoint placeBetween(
        const SurfacePoint& from, const SurfacePoint& to, double share
    ) const;

    const TriangleMesh& mesh_;
    std::vector<Vec3> normals_;
    std::vector<int> firstFace_, facesOf_;  // around each vertex, from firstFace_[v] on
};

/// Distances that part a curve evenly: those of an open one with both ends, of a closed one from
/// its start. Expects a count > 1, or 1 of a closed curve.
[[nodiscard]] std::vector<double> evenDistances(const SurfacePolyline& line, int count);

/// Distances of the vertices at which the curve's picks are.
[[nodiscard]] std::vector<double> distancesOfPicks(const SurfacePolyline& line);

}  // namespace bspline_curve
