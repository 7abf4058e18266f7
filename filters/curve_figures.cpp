// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_figures.h"

#include "bspline_curve/curve.h"

namespace bspline_curve {

namespace {

/// x, y, z of each point in turn: hosts keep vectors, but no matrix of n rows.
std::vector<double> flattened(const std::vector<Vec3>& points) {
    std::vector<double> values;
    for (const Vec3& p : points) {
        values.insert(values.end(), {p.x(), p.y(), p.z()});
    }
    return values;
}

std::vector<double> asNumbers(const std::vector<int>& indices) {
    return {indices.begin(), indices.end()};
}

}  // namespace

const char* shellName(const Curve& curve) {
    return curve.shell ? name(*curve.shell) : "fibres";
}

double secondsOf(const SolveReport& report) {
    const auto& part = report.seconds;
    return part.path + part.initial + part.minimise + part.knots + part.polyline +
           part.failedAttempts;
}

Figures curveFigures(const Curve& curve, const WorkpieceCache::Found& found, double seconds) {
    const SolveReport& report = curve.report;
    const ShellSummary shell = found->shell();
    const StageSeconds stages = found.isKept ? StageSeconds() : found->seconds();
    return {
        {"usable", report.usable},
        {"converged", report.status == SolveStatus::Converged},
        {"closed", curve.polyline.closed},
        {"degree", curve.spline.degree},
        {"vertices", static_cast<int>(curve.polyline.points.size())},
        {"length", lengthOf(curve.polyline)},
        {"knots_first", report.knotsFirst},
        {"knots_last", report.knotsLast},
        {"max_distance", report.maxDistance},
        {"allowed_distance", report.allowedDistance},
        {"max_pick_gap", report.maxPickGap},
        {"rounds", static_cast<int>(report.rounds.size())},
        {"newton_iterations", report.newtonIterations},
        {"field_cost", report.fieldCost},
        {"field_at_rest", report.fieldAtRest},
        {"field_share", report.fieldShare},
        {"avoided_faces", report.avoidedFaces},
        {"clearance", report.clearance},
        {"prisms", curve.prisms},
        {"faces_passed", curve.facesPassed},
        {"shell_cached",
         curve.shell && report.seconds.shell == 0.0 && (shell.isFromStore || found.isKept)},
        {"surface_kept", found.isKept},
        {"seconds", seconds},
        {"seconds_surface", stages.validate + stages.tree},
        {"seconds_shell", found.isKept ? report.seconds.shell : stages.shell},
        {"seconds_curve", secondsOf(report)},
        {"knots", curve.spline.knots},
        {"control_points", flattened(curve.spline.controlPoints)},
        {"pick_parameters", curve.spline.pickParameters},
        {"pick_vertices", asNumbers(curve.polyline.picks)},
    };
}

}  // namespace bspline_curve
