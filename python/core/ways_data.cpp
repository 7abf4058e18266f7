// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/lines.h"
#include "bspline_curve/spline.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"
#include "python/core/python_progress.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
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

/// A polyline in space, projected onto the mesh, along a direction where there is one: its parts,
/// and what is to be said of them; empty: nothing.
std::pair<std::vector<DesignedCurve>, std::string> projected(
    const Mesh& mesh,
    const Points& points,
    bool closed,
    double distance,
    const std::optional<std::array<double, 3>>& direction
) {
    const SpacePolyline line{.points = toVectors(points), .closed = closed};
    ProjectionOptions options{.distance = distance};
    if (direction) {
        options.direction = Vec3(direction->data());
    }
    const nb::gil_scoped_release unlocked;
    ProjectedLines found = projectedLines(*mesh.workpiece, line, options);
    std::string note = projectionNote({&found, 1});
    std::vector<DesignedCurve> curves;
    for (SurfacePolyline& each : found.lines) {
        curves.push_back(curveOf(std::move(each)));
    }
    return {std::move(curves), std::move(note)};
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
    module.def(
        "projected", projected, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none()
    );
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
