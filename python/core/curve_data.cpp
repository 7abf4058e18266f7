// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/curve.h"
#include "python/core/arrays.h"
#include "python/core/bindings.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <vector>

namespace bspline_curve::python {

namespace {

nb::list roundsOf(const SolveReport& report) {
    nb::list rounds;
    for (const RoundReport& round : report.rounds) {
        nb::dict entry;
        entry["alpha"] = round.alpha;
        entry["beta"] = round.beta;
        entry["knots"] = round.knots;
        entry["iterations"] = round.iterations;
        entry["status"] = name(round.status);
        entry["max_distance"] = round.maxDistance;
        rounds.append(entry);
    }
    return rounds;
}

nb::list iterationsOf(const SolveReport& report) {
    nb::list iterations;
    for (const IterationReport& iteration : report.iterations) {
        nb::dict entry;
        entry["round"] = iteration.round;
        entry["total"] = iteration.total;
        entry["internal"] = iteration.terms.internal;
        entry["external"] = iteration.terms.external;
        entry["distance"] = iteration.terms.distance;
        entry["fit"] = iteration.terms.fit;
        entry["avoidance"] = iteration.terms.avoidance;
        entry["decrement"] = iteration.decrement;
        entry["step"] = iteration.step;
        iterations.append(entry);
    }
    return iterations;
}

nb::dict secondsOf(const SolveReport::Seconds& seconds) {
    nb::dict entry;
    entry["path"] = seconds.path;
    entry["initial"] = seconds.initial;
    entry["minimise"] = seconds.minimise;
    entry["knots"] = seconds.knots;
    entry["polyline"] = seconds.polyline;
    entry["failed_attempts"] = seconds.failedAttempts;
    entry["shell"] = seconds.shell;
    return entry;
}

nb::object farPartOf(const SolveReport& report) {
    if (!report.farPart) {
        return nb::none();
    }
    nb::dict entry;
    entry["from"] = report.farPart->from;
    entry["to"] = report.farPart->to;
    entry["faces"] = report.farPart->faces;
    return entry;
}

nb::list detoursOf(const SolveReport& report) {
    nb::list detours;
    for (const Detour& detour : report.detours) {
        nb::dict entry;
        entry["picks"] = nb::make_tuple(detour.from, detour.to);
        entry["ratio"] = detour.ratio;
        entry["round"] = name(detour.round);
        detours.append(entry);
    }
    return detours;
}

nb::list tangentsOf(const SolveReport& report) {
    nb::list tangents;
    for (const MetTangent& tangent : report.tangents) {
        nb::dict entry;
        entry["pick"] = tangent.pick;
        entry["angle_of_spline"] = tangent.ofSpline;
        entry["angle_of_polyline"] = tangent.ofPolyline;
        tangents.append(entry);
    }
    return tangents;
}

// All of a report and what else is known of how a curve came about.
nb::dict reportDict(const DesignedCurve& drawn) {
    const Curve& curve = drawn.curve;
    const SolveReport& report = curve.report;
    nb::dict result;
    result["status"] = name(report.status);
    result["usable"] = report.usable;
    result["converged"] = report.status == SolveStatus::Converged;
    result["notes"] = drawn.notes;
    if (!report.usable && !drawn.notes.empty()) {
        result["why"] = drawn.notes.back();
    }
    result["far_part"] = farPartOf(report);
    result["max_distance"] = report.maxDistance;
    result["allowed_distance"] = report.allowedDistance;
    result["max_pick_gap"] = report.maxPickGap;
    result["knots_first"] = report.knotsFirst;
    result["knots_last"] = report.knotsLast;
    result["newton_iterations"] = report.newtonIterations;
    result["is_sampled"] = report.isSampled;
    result["field_cost"] = report.fieldCost;
    result["field_at_rest"] = report.fieldAtRest;
    result["field_share"] = report.fieldShare;
    result["repeated_picks"] = report.repeatedPicks;
    result["pick_distances"] = report.pickDistances;
    result["line_distance"] = report.lineDistance;
    result["corner_turns"] = report.cornerTurns;
    result["detours"] = detoursOf(report);
    result["tangents"] = tangentsOf(report);
    result["avoided_faces"] = report.avoidedFaces;
    result["clearance"] = report.clearance;
    result["shell"] = curve.shell ? nb::object(nb::str(name(*curve.shell))) : nb::none();
    result["prisms"] = curve.prisms;
    result["faces_passed"] = curve.facesPassed;
    result["seconds"] = secondsOf(report.seconds);
    result["rounds"] = roundsOf(report);
    result["iterations"] = iterationsOf(report);
    return result;
}

// From what a curve is kept by in files: enough to be shown, written and moved on from; its report
// is kept by the caller.
DesignedCurve restored(const nb::dict& parts) {
    const auto points = nb::cast<Points>(parts["points"]);
    const auto faces = nb::cast<Ids>(parts["faces"]);
    const auto barycentrics = nb::cast<Points>(parts["barycentrics"]);
    const auto parameters = nb::cast<Values>(parts["t"]);
    const std::size_t count = points.shape(0);
    if (faces.shape(0) != count || barycentrics.shape(0) != count || parameters.shape(0) != count) {
        throw nb::value_error("the parts of a curve have different lengths");
    }
    Curve curve;
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
    curve.spline.controlPoints = toVectors(nb::cast<Points>(parts["control_points"]));
    curve.report.isSampled = nb::cast<bool>(parts["is_sampled"]);
    // A curve that starts from this one goes on with its last weight of the distance.
    curve.report.rounds.resize(1);
    curve.report.rounds.back().alpha = nb::cast<double>(parts["alpha"]);
    curve.report.usable = nb::cast<bool>(parts["usable"]);
    return {.curve = std::move(curve)};
}

}  // namespace

void bindCurve(nb::module_& module) {
    using Drawn = DesignedCurve;
    const auto line = [](auto part) {
        return viewOf<Drawn>([part](const Drawn& d) -> auto& { return d.curve.polyline.*part; });
    };
    const auto spline = [](auto part) {
        return viewOf<Drawn>([part](const Drawn& d) -> auto& { return d.curve.spline.*part; });
    };
    nb::class_<Drawn>(module, "Curve")
        .def_static("restored", restored)
        .def_prop_ro("points", line(&SurfacePolyline::points))
        .def_prop_ro("t", line(&SurfacePolyline::parameters))
        .def_prop_ro("pick_vertices", line(&SurfacePolyline::picks))
        .def_prop_ro(
            "places", [](const Drawn& d) { return placesOf(d.curve.polyline.surfacePoints); }
        )
        .def_prop_ro("control_points", spline(&SplineData::controlPoints))
        .def_prop_ro("knots", spline(&SplineData::knots))
        .def_prop_ro("pick_parameters", spline(&SplineData::pickParameters))
        .def_prop_ro("degree", [](const Drawn& d) { return d.curve.spline.degree; })
        .def_prop_ro("closed", [](const Drawn& d) { return d.curve.polyline.closed; })
        .def_prop_ro("usable", [](const Drawn& d) { return d.curve.report.usable; })
        .def_prop_ro("length", [](const Drawn& d) { return lengthOf(d.curve.polyline); })
        .def("report", reportDict);
}

}  // namespace bspline_curve::python
