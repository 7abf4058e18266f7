// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace bspline_curve {

/// Where the nearest point of a curve lies, seen along the curve with the surface's normal upwards.
enum class CurveSide : std::uint8_t {
    Left,
    Right,
    Cap  ///< beyond an end of an open curve
};

/// The geodesic distance of a point to the curve, and the side that it is on.
struct SidedDistance {
    double distance = std::numeric_limits<double>::infinity();
    CurveSide side = CurveSide::Left;
};

/// Straight ways from one source across one face, laid out in the plane.
struct DistanceBeam {
    using Vec2 = Eigen::Vector2d;

    int face = -1;
    int frame = 0;           ///< side of the face that is the x axis; see FaceLayout
    std::uint8_t exits = 0;  ///< bit k: the beam may leave through the side opposite to corner k
    bool fromLine = false;   ///< from a segment, at right angles; else from a point
    CurveSide side = CurveSide::Left;
    Vec2 source = Vec2::Zero();  ///< the point, or one of the segment's line
    Vec2 normal = Vec2::Zero();  ///< fromLine: the unit direction of all ways
    double before = 0.0;         ///< distance at the source
    /// The beam lies right of its left ray and left of its right ray; directions of any length.
    Vec2 leftOrigin = Vec2::Zero(), left = Vec2::Zero();
    Vec2 rightOrigin = Vec2::Zero(), right = Vec2::Zero();

    [[nodiscard]] double distance(const Vec2& point) const {
        return fromLine ? normal.dot(point - source) : before + (point - source).norm();
    }

    /// Whether a point is in the beam, or within `tolerance`, and at most half more, of it.
    [[nodiscard]] bool contains(const Vec2& point, double tolerance) const;
};

/// Distances that are asked for, 0 <= from < to, in the user's unit.
struct DistanceRange {
    double from = 0.0;  ///< nearer points only have a bound, which is below it as well
    double to = 0.0;
};

/// Exact geodesic distances to polylines on a surface, within a range. Beams of straight ways run
/// from their segments and vertices through strips of unfolded faces, and again from
/// vertices whose angle is more than a full turn (on boundaries: a half turn). A beam that no
/// shortest way can lie in is dropped by the distances of the vertices (Xin & Wang 2009, Improving
/// Chen and Han's algorithm). Exact up to rounding: relative errors of about 1e-9. Time grows
/// with the faces within reach times the beams in one, memory with those within the range.
class DistanceBeams {
public:
    /// The polyline must be strict (isStrict). The surface must outlive this. Throws Cancelled.
    DistanceBeams(
        const Surface& surface,
        const SurfacePolyline& line,
        const DistanceRange& range,
        const Progress& progress = {}
    )
        : DistanceBeams(surface, std::span(&line, 1), range, progress) {}

    /// To the nearest of several; one with a single vertex is a point.
    DistanceBeams(
        const Surface& surface,
        std::span<const SurfacePolyline> lines,
        const DistanceRange& range,
        const Progress& progress = {}
    );

    /// Distance of a point; infinite or too large only where it is not within the range.
    [[nodiscard]] SidedDistance at(const SurfacePoint& point) const;

    /// No point of the same face that is within `radius` of this one has a smaller distance. The
    /// point may be beside its face, in the same plane.
    [[nodiscard]] double leastNear(const SurfacePoint& point, double radius) const;

    /// Of each vertex of the surface, exact up to the end of the range, whatever its beginning is.
    [[nodiscard]] const std::vector<SidedDistance>& atVertices() const { return vertices_; }

    /// Faces that a beam reaches, ascending.
    [[nodiscard]] std::vector<int> reachedFaces() const;

private:
    [[nodiscard]] SidedDistance inOneFace(const SurfacePoint& point) const;

    const Surface* surface_;
    std::vector<std::vector<DistanceBeam>> beams_;  ///< per face
    std::vector<char> isReached_;                   ///< per face
    std::vector<SidedDistance> vertices_;
};

}  // namespace bspline_curve
