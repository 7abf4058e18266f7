// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/report_dict.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

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

}  // namespace

nb::dict reportDict(const Curve& curve) {
    const SolveReport& report = curve.report;
    nb::dict result;
    result["status"] = name(report.status);
    result["usable"] = report.usable;
    result["converged"] = report.status == SolveStatus::Converged;
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

}  // namespace bspline_curve::python
