// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/lines.h"
#include "bspline_curve/spline.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/vector.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

DesignedCurve curveOf(SurfacePolyline line) {
    Curve curve;
    curve.spline = polygonSpline(line);
    curve.polyline = std::move(line);
    curve.report.usable = true;
    return {.curve = std::move(curve)};
}

/// A polyline in space, projected onto the mesh.
DesignedCurve projected(const Mesh& mesh, const Points& points, bool closed, double distance) {
    const SpacePolyline line{.points = toVectors(points), .closed = closed};
    const nb::gil_scoped_release unlocked;
    return curveOf(projectedPolyline(*mesh.workpiece, line, distance));
}

std::vector<SurfacePoint> pointsOf(const Ids& faces, const Points& barycentrics) {
    const std::vector<Vec3> weights = toVectors(barycentrics);
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        points.push_back({.face = faces(i), .barycentric = weights[i]});
    }
    return points;
}

SurfacePolyline lineOfOne(const SurfacePoint& point) {
    SurfacePolyline line;
    line.surfacePoints.push_back(point);
    return line;
}

/// The shortest way between two points of the mesh; none where there is no way.
std::optional<DesignedCurve> shortestWay(
    const Mesh& mesh, const Ids& faces, const Points& barycentrics
) {
    const std::vector<SurfacePoint> ends = pointsOf(faces, barycentrics);
    const nb::gil_scoped_release unlocked;
    std::optional<SurfacePolyline> line = shortestPath(*mesh.workpiece, ends[0], ends[1]);
    return line ? std::optional(curveOf(*std::move(line))) : std::nullopt;
}

/// Of each vertex to the nearest of some curves and points.
Array distances(
    const Mesh& mesh,
    const std::vector<const DesignedCurve*>& curves,
    const Ids& faces,
    const Points& barycentrics,
    double reach,
    nb::object progress
) {
    std::vector<SurfacePolyline> lines;
    for (const DesignedCurve* curve : curves) {
        lines.push_back(curve->curve.polyline);
    }
    for (const SurfacePoint& point : pointsOf(faces, barycentrics)) {
        lines.push_back(lineOfOne(point));
    }
    return arrayOf(PythonProgress(std::move(progress)).run([&](const Progress& goesOn) {
        return distancesToLines(*mesh.workpiece, lines, reach, goesOn);
    }));
}

}  // namespace

void bindWays(nb::module_& module) {
    module.def("projected", projected);
    module.def("shortest_way", shortestWay);
    module.def(
        "distances",
        distances,
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg(),
        nb::arg().none()
    );
}

}  // namespace bspline_curve::python
