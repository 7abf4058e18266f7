// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/curve_report.h"

#include "bspline_curve/error.h"
#include "cli/reports/mesh_json.h"
#include "filters/curve_figures.h"
#include "text/json_text.h"
#include "text/text_parsing.h"

namespace bspline_curve::cli {

namespace {

Json secondsOf(const SolveReport& report, const RunFigures& figures) {
    const auto& solve = report.seconds;
    return {
        {"cold", figures.coldSeconds},
        {"warm", figures.warmSeconds ? Json(*figures.warmSeconds) : Json(nullptr)},
        {"read", figures.readSeconds},
        {"validate", figures.stages.validate},
        {"tree", figures.stages.tree},
        {"shell", figures.stages.shell},
        {"field", figures.fieldSeconds},
        {"design", figures.designSeconds},
        {"path", solve.path},
        {"initial", solve.initial},
        {"minimise", solve.minimise},
        {"knots", solve.knots},
        {"polyline", solve.polyline},
        {"failed_attempts", solve.failedAttempts},
    };
}

Json roundsOf(const SolveReport& report) {
    Json rounds = Json::array();
    for (const RoundReport& round : report.rounds) {
        rounds.push_back({
            {"alpha", round.alpha},
            {"beta", round.beta},
            {"knots", round.knots},
            {"iterations", round.iterations},
            {"status", name(round.status)},
            {"max_distance", round.maxDistance},
        });
    }
    return rounds;
}

Json iterationsOf(const SolveReport& report) {
    Json iterations = Json::array();
    for (const IterationReport& iteration : report.iterations) {
        iterations.push_back({
            {"round", iteration.round},
            {"total", iteration.total},
            {"internal", iteration.terms.internal},
            {"external", iteration.terms.external},
            {"distance", iteration.terms.distance},
            {"fit", iteration.terms.fit},
            {"avoidance", iteration.terms.avoidance},
            {"decrement", iteration.decrement},
            {"step", iteration.step},
        });
    }
    return iterations;
}

Json fieldOf(const SolveReport& report, const RunFigures& figures) {
    if (figures.field.empty()) {
        return nullptr;
    }
    return {
        {"kind", figures.field},
        {"cost", figures.fieldCost},
        {"mean_cost", report.fieldCost},
        {"at_rest", report.fieldAtRest},
        {"share", report.fieldShare},
    };
}

Json avoidanceOf(const SolveReport& report) {
    if (report.avoidedFaces == 0) {
        return nullptr;
    }
    return {{"faces", report.avoidedFaces}, {"clearance", report.clearance}};
}

Json farPartOf(const SolveReport& report) {
    if (!report.farPart) {
        return nullptr;
    }
    const FarPart& part = *report.farPart;
    return {{"from", part.from}, {"to", part.to}, {"faces", part.faces}};
}

Json detoursOf(const SolveReport& report) {
    Json list = Json::array();
    for (const Detour& detour : report.detours) {
        list.push_back(
            {{"picks", {detour.from, detour.to}},
             {"ratio", detour.ratio},
             {"round", name(detour.round)}}
        );
    }
    return list;
}

Json tangentsJson(const SolveReport& report) {
    Json list = Json::array();
    for (const MetTangent& tangent : report.tangents) {
        list.push_back(
            {{"pick", tangent.pick},
             {"angle_of_spline", tangent.ofSpline},
             {"angle_of_polyline", tangent.ofPolyline}}
        );
    }
    return list;
}

}  // namespace

std::string reportText(const Curve& curve, const Workpiece& workpiece, const RunFigures& figures) {
    const SolveReport& report = curve.report;
    const Json document = {
        {"status", name(report.status)},
        {"usable", report.usable},
        {"far_part", farPartOf(report)},
        {"shell", shellName(curve)},
        {"prisms", curve.prisms},
        {"faces_passed", curve.facesPassed},
        {"cached", curve.shell && figures.shell.isFromStore},
        {"notes", figures.notes},
        {"field", fieldOf(report, figures)},
        {"repeated_picks", report.repeatedPicks},
        {"pick_distances", report.pickDistances},
        {"detours", detoursOf(report)},
        {"tangents", tangentsJson(report)},
        {"avoid", avoidanceOf(report)},
        {"seconds", secondsOf(report, figures)},
        {"peak_memory_bytes",
         {{"read", figures.readMemoryBytes}, {"cold", figures.peakMemoryBytes}}},
        {"knots_first", report.knotsFirst},
        {"knots_last", report.knotsLast},
        {"max_distance", report.maxDistance},
        {"allowed_distance", report.allowedDistance},
        {"max_pick_gap", report.maxPickGap},
        {"newton_iterations", report.newtonIterations},
        {"curve",
         {{"closed", curve.polyline.closed},
          {"degree", curve.spline.degree},
          {"vertices", curve.polyline.points.size()},
          {"length", lengthOf(curve.polyline)}}},
        {"mesh", meshJson(workpiece, figures.meshFile)},
        {"repair", repairJson(workpiece.repair())},
        {"rounds", roundsOf(report)},
        {"iterations", iterationsOf(report)},
    };
    // A file name may hold bytes that are not UTF-8; they become replacement characters.
    return jsonText(document);
}

void checkReportExtension(const std::filesystem::path& file) {
    if (const std::string extension = lowerCaseExtension(file); extension != ".json") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": the extension " + inQuotes(extension) + " of the report is not .json"
        );
    }
}

}  // namespace bspline_curve::cli
