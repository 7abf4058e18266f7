// SPDX-License-Identifier: GPL-3.0-or-later
// Ways on a workpiece: lines of space brought onto it, shortest paths, distances.
#include "bspline_curve/error.h"
#include "bspline_curve/lines.h"
#include "imprint/projected_polyline.h"
#include "offset/distances_to_lines.h"
#include "surface/geodesic_path.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "workpiece/workpiece_parts.h"

#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// A point of the mesh, with the surface's own face.
SurfacePoint ownPoint(const Surface& surface, const SurfacePoint& point, const char* name) {
    const auto faceCount = static_cast<int>(surface.input().faces.size());
    if (point.face < 0 || point.face >= faceCount) {
        throw InputError(
            InputErrorCode::IndexOutOfRange,
            std::string(name) + " is in face " + std::to_string(point.face) +
                "; faces are numbered from 0 to " + std::to_string(faceCount - 1),
            {point.face}
        );
    }
    SurfacePolyline line;
    line.surfacePoints.push_back(point);
    return strictLine(surface, std::move(line), name).surfacePoints.front();
}

/// A path as a line on its surface; one of fewer than two points where it has no length.
SurfacePolyline lineOf(const Surface& surface, const GeodesicPath& path) {
    SurfacePolyline line;
    double length = 0.0;
    for (const SurfacePoint& passed : path.points) {
        // On the vertex or edge that it is near, so that points at one place are the same.
        const SurfacePoint point = snapped(passed, kSnapBarycentric);
        const Vec3 position = surface.position(point);
        if (!line.points.empty()) {
            if (position == line.points.back()) {
                continue;
            }
            length += (position - line.points.back()).norm();
        }
        line.surfacePoints.push_back(point);
        line.points.push_back(position);
        line.parameters.push_back(length);
    }
    for (double& t : line.parameters) {
        t /= length;
    }
    return line;
}

}  // namespace

SurfacePolyline projectedPolyline(
    const Workpiece& workpiece, const SpacePolyline& line, double distance
) {
    const CurveDesigner& designer = designerOf(workpiece);
    return projectedPolyline(designer.surface(), designer.tree(), line, distance);
}

ProjectedLines projectedLines(
    const Workpiece& workpiece, const SpacePolyline& line, const ProjectionOptions& options
) {
    const CurveDesigner& designer = designerOf(workpiece);
    return projectedLines(designer.surface(), designer.tree(), line, options);
}

std::optional<SurfacePolyline> shortestPath(
    const Workpiece& workpiece, const SurfacePoint& from, const SurfacePoint& to
) {
    const Surface& surface = surfaceOf(workpiece);
    const SurfacePoint start = ownPoint(surface, from, "the start");
    const SurfacePoint goal = ownPoint(surface, to, "the end");
    const std::optional<GeodesicPath> path =
        GeodesicPathFinder(surface, {}).findShortest(start, goal);
    if (!path) {
        return std::nullopt;
    }
    SurfacePolyline line = lineOf(surface, *path);
    if (line.points.size() < 2) {
        return std::nullopt;
    }
    surface.provenance().bringToInput(line);
    return line;
}

std::vector<double> distancesToLines(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    double reach,
    const Progress& progress
) {
    return distancesToLines(surfaceOf(workpiece), lines, reach, progress);
}

}  // namespace bspline_curve
