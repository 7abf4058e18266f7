// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/curve_data.h"

#include "design/strict_polyline.h"
#include "filters/curve_notes.h"
#include "python/core/arrays.h"
#include "python/core/report_dict.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace bspline_curve::python {

namespace {

Array facesOf(const Curve& curve) {
    std::vector<std::int32_t> faces;
    faces.reserve(curve.polyline.surfacePoints.size());
    for (const SurfacePoint& point : curve.polyline.surfacePoints) {
        faces.push_back(point.face);
    }
    return arrayOf(std::move(faces));
}

Array barycentricsOf(const Curve& curve) {
    std::vector<double> weights;
    weights.reserve(3 * curve.polyline.surfacePoints.size());
    for (const SurfacePoint& point : curve.polyline.surfacePoints) {
        weights.insert(weights.end(), point.barycentric.begin(), point.barycentric.end());
    }
    return arrayOf(std::move(weights), 3);
}

// What a curve is kept by in files: enough to be shown, written and moved on from; its report is
// kept by the caller.
void restore(
    Curve& curve,
    const nb::dict& parts,
    const Points& points,
    const Ids& faces,
    const Points& barycentrics,
    const Values& parameters,
    const Points& controlPoints
) {
    const std::size_t count = points.shape(0);
    if (faces.shape(0) != count || barycentrics.shape(0) != count || parameters.shape(0) != count) {
        throw nb::value_error("the parts of a curve have different lengths");
    }
    curve.polyline.points = toVectors(points);
    const std::vector<Vec3> weights = toVectors(barycentrics);
    for (std::size_t i = 0; i < count; ++i) {
        curve.polyline.surfacePoints.push_back({.face = faces(i), .barycentric = weights[i]});
    }
    curve.polyline.parameters.assign(parameters.data(), parameters.data() + count);
    curve.polyline.picks = nb::cast<std::vector<int>>(parts["pick_vertices"]);
    curve.polyline.closed = nb::cast<bool>(parts["closed"]);
    curve.spline.closed = curve.polyline.closed;
    curve.spline.degree = nb::cast<int>(parts["degree"]);
    curve.spline.knots = nb::cast<std::vector<double>>(parts["knots"]);
    curve.spline.pickParameters = nb::cast<std::vector<double>>(parts["pick_parameters"]);
    curve.spline.controlPoints = toVectors(controlPoints);
    curve.report.isSampled = nb::cast<bool>(parts["is_sampled"]);
    // A curve that starts from this one goes on with its last weight of the distance.
    curve.report.rounds.resize(1);
    curve.report.rounds.back().alpha = nb::cast<double>(parts["alpha"]);
    curve.report.usable = nb::cast<bool>(parts["usable"]);
}

}  // namespace

void bindCurve(nb::module_& module) {
    const auto view = [](auto part) {
        return [part](nb::handle self) { return viewOf(part(nb::cast<const Curve&>(self)), self); };
    };
    nb::class_<Curve>(module, "Curve")
        .def_static(
            "restored",
            [](const nb::dict& parts,
               const Points& points,
               const Ids& faces,
               const Points& barycentrics,
               const Values& parameters,
               const Points& controlPoints) {
                Curve curve;
                restore(curve, parts, points, faces, barycentrics, parameters, controlPoints);
                return curve;
            }
        )
        .def_prop_ro("points", view([](const Curve& c) -> auto& { return c.polyline.points; }))
        .def_prop_ro("t", view([](const Curve& c) -> auto& { return c.polyline.parameters; }))
        .def_prop_ro("pick_vertices", view([](const Curve& c) -> auto& {
                         return c.polyline.picks;
                     }))
        .def_prop_ro("faces", facesOf, nb::rv_policy::automatic)
        .def_prop_ro("barycentrics", barycentricsOf, nb::rv_policy::automatic)
        .def_prop_ro("control_points", view([](const Curve& c) -> auto& {
                         return c.spline.controlPoints;
                     }))
        .def_prop_ro("knots", view([](const Curve& c) -> auto& { return c.spline.knots; }))
        .def_prop_ro("pick_parameters", view([](const Curve& c) -> auto& {
                         return c.spline.pickParameters;
                     }))
        .def_prop_ro("degree", [](const Curve& c) { return c.spline.degree; })
        .def_prop_ro("closed", [](const Curve& c) { return c.polyline.closed; })
        .def_prop_ro("usable", [](const Curve& c) { return c.report.usable; })
        .def_prop_ro("length", [](const Curve& curve) { return lengthOf(curve.polyline); })
        .def("report", reportDict)
        .def("why_unusable", [](const Curve& c) { return describeUnusable(c.report); });
}

}  // namespace bspline_curve::python
