// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// A polyline in space; a closed one does not repeat its first point.
struct SpacePolyline {
    std::vector<Vec3> points;
    bool closed = false;
};

/// A line of mesh edges between faces of two labels.
struct BoundaryLine {
    bool closed = false;
    std::vector<int> vertices;  ///< closed: the first one is not repeated
    int left = 0, right = 0;    ///< labels, seen along the line with the normals up
};

/// The lines between faces of different labels, each once: closed ones, and ones from junction to
/// junction, which are vertices where other than two such edges meet, or at the mesh's boundary;
/// edges of one face are no part of any. `labels`: one for each face. By their least vertex,
/// open ones first; O(#F log #F).
[[nodiscard]] std::vector<BoundaryLine> boundaryLines(
    const TriangleMesh& mesh, std::span<const int> labels
);

/// A line to be fitted, in the user's unit, as hosts have it.
struct LineToFit {
    std::vector<Vec3> points;
    bool closed = false;
    std::string name;  ///< for messages: "line 3 of lines.obj"
};

/// Curves along lines.
struct FittedLines {
    std::vector<DesignedCurve> curves;
    std::vector<std::size_t> lines;  ///< of each curve
    std::vector<std::string> notes;  ///< also of lines that were left out
};

/// The lines between faces of different labels as lines to be fitted, see boundaryLines().
/// `labels`: of the faces of the workpiece's mesh.
[[nodiscard]] std::vector<LineToFit> linesBetween(
    const TriangleMesh& mesh, std::span<const int> labels
);

/// The same round some faces.
[[nodiscard]] std::vector<LineToFit> linesRound(const TriangleMesh& mesh, const Region& faces);

/// Fits each. A line that has no smooth curve so near is left out with a note. Throws InputError
/// where that is so of all, or there are none; Cancelled.
[[nodiscard]] FittedLines fitLines(
    const Workpiece& workpiece,
    std::span<const LineToFit> lines,
    const FitOptions& fit = {},
    const CurveOptions& options = {},
    const Progress& progress = {}
);

/// A polyline near the mesh, projected onto it: its points become their closest points, and so do
/// points between them, as dense as edges are there; shortest paths join these. t is the length
/// along it, from 0 to 1. O(n log m) for n points of the result and m faces. Throws InputError
/// (PickTooFar) where a point is farther from the mesh than `distance` (user's unit), and (NoPath)
/// where one part of it and the next are near to parts of the mesh that are not, or where nothing
/// but one point is left; both name the vertex.
[[nodiscard]] SurfacePolyline projectedPolyline(
    const Workpiece& workpiece, const SpacePolyline& line, double distance
);

/// How polylines come onto a mesh.
struct ProjectionOptions {
    /// Polylines that are farther from the mesh anywhere are refused, in the user's unit, >= 0;
    /// 0: 1 % of its diagonal, along a direction any distance.
    double distance = 0.0;
    /// Points are moved along it, see projectedLines(); finite and not zero. None: to the closest
    /// point.
    std::optional<Vec3> direction{};

    /// Throws InputError (BadOption).
    void validate() const;
};

/// A polyline on a mesh, in as many parts as it is parted into.
struct ProjectedLines {
    std::vector<SurfacePolyline> lines;  ///< none: all of it is beside the mesh
    /// For each stretch of the polyline that is beside the mesh, seen along the direction, the
    /// vertex behind which it begins; ascending.
    std::vector<std::size_t> gaps;
    /// The same for each jump, by more than the mean edge length, from one part of the surface to
    /// another.
    std::vector<std::size_t> jumps;
};

/// A polyline projected onto the mesh as projectedPolyline() does, or with a direction moved along
/// it, as light would throw its shadow: each point goes to the first face that is met on the line
/// through it, coming from outside in this direction, wherever on that line the point is. The
/// vertices of the result are then those of the polyline and where it crosses edges, on the plane
/// through segment and direction to rounding; it is looked for at steps of half a mean edge, so
/// what is narrower may be missed. Where it leaves the mesh it is parted, up to the boundary; where
/// it jumps it goes down the shortest path, or is parted where there is none. O(n log m) for n
/// steps and m faces. Throws InputError as projectedPolyline() does, but not where a direction
/// leads past the mesh; BadOption.
[[nodiscard]] ProjectedLines projectedLines(
    const Workpiece& workpiece, const SpacePolyline& line, const ProjectionOptions& options
);

/// What to say of polylines that were projected, in one note: where they leave the mesh and where
/// they jump, with counts and the first of either; empty where they do neither.
[[nodiscard]] std::string projectionNote(std::span<const ProjectedLines> polylines);

/// Lines that were moved onto a mesh.
struct DrapedLines {
    std::vector<LineToFit> lines;
    std::vector<std::string> notes;  ///< one at most: projectionNote()
};

/// Lines moved along a direction onto the mesh, as projectedLines() does, so that curves can be
/// fitted to them there. A line that is parted becomes several, whose names tell it. Throws
/// InputError (BadOption; NoPath where none meets the mesh).
[[nodiscard]] DrapedLines drapedLines(
    const Workpiece& workpiece, std::span<const LineToFit> lines, const Vec3& direction
);

/// The shortest path between two points of the mesh, up to rounding; where that takes more than
/// half a second to tell, the shortest one found so far. t is the length along it, from 0 to 1.
/// None where no way leads, or both are one point. Throws InputError (IndexOutOfRange: no face of
/// the mesh; NoPath: a face that mending has removed).
[[nodiscard]] std::optional<SurfacePolyline> shortestPath(
    const Workpiece& workpiece, const SurfacePoint& from, const SurfacePoint& to
);

/// The exact geodesic distance of each vertex to the nearest of some lines, in the user's unit;
/// infinite where it is more than `reach` (which may be infinite), or where no way leads. A line
/// with a single vertex is a point. For k vertices within reach time grows as k^1.5 on a smooth
/// surface, where tens of beams of ways cross each edge: about 4 s for 68,000 vertices. Throws
/// InputError (NoPath where a line is not strictly on the mesh), Cancelled.
[[nodiscard]] std::vector<double> distancesToLines(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    double reach,
    const Progress& progress = {}
);

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
