// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/solved_curve.h"

#include "design/spline_data.h"
#include "design/strict_polyline.h"
#include "projection/fibre_tracer.h"
#include "projection/projected_curve.h"
#include "solver/problem_traces.h"
#include "utility/index_sets.h"
#include "utility/sparse_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bspline_curve {
namespace {

// Says in which shell the curve was drawn, or how many faces its fibres met.
void describeShell(const CurveProblem& problem, const Solution& solution, Curve& curve) {
    if (problem.shell != nullptr) {
        curve.shell =
            problem.shell->isFullResolution() ? ShellKind::FullResolution : ShellKind::Simplified;
        curve.prisms = problem.shell->prismCount();
        return;
    }
    SparseMap<char> faces;
    for (const int face : facesPassed(solution)) {
        faces.at(face, 1);
    }
    curve.facesPassed = static_cast<int>(faces.size());
}

// `trace`: of this spline, in the problem's shell or along the fibres; none: of the cells.
SurfacePolyline polylineOf(
    const Surface& surface,
    const CurveProblem& problem,
    const SplineCurve& spline,
    std::optional<CurveTrace> trace,
    const SamplingOptions& sampling
) {
    const auto& [space, controls] = spline;
    if (problem.shell != nullptr && !problem.shell->isFullResolution()) {
        // The fibres of a simplified shell are oblique to the surface, so a spline that is smooth
        // and within its tolerance has a shadow along them that is less smooth.
        CurveDistance fine = measureAlongFibres(fibreStartOf(problem), space, controls);
        // Other fibres may lead into what the curve avoids.
        const auto isAvoided = [&](int f) { return problem.obstacles->isAvoided(f); };
        if (std::isfinite(fine.largest) &&
            (problem.obstacles == nullptr ||
             std::ranges::none_of(facesPassed(fine.trace), isAvoided))) {
            trace = std::move(fine.trace);
        }
    }
    if (!trace) {
        trace = traceCells(traceStartOf(problem), space, controls);
    }
    if (!progressOf(*trace).isWhole) {
        throw std::logic_error("the polyline was asked of a spline that leaves its shell");
    }
    const ProjectedCurve shadow(
        *problem.extended, problem.shell, space, controls, std::move(*trace)
    );
    return makeStrictPolyline(surface, problem, FairedShadow(problem, shadow), sampling);
}

// The part of a curve whose polyline is farther from its spline than the tolerance.
std::optional<FarPart> farPartOf(
    const CurveProblem& problem, const SplineCurve& spline, const SurfacePolyline& line
) {
    const ShellFrame& frame = problem.extended->frame;
    std::optional<FarPart> part;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double t = line.parameters[i];
        const Vec3 position = spline.space.evaluate(spline.controls, t);
        if ((position - frame.toUnit(line.points[i])).norm() < problem.distanceTolerance) {
            continue;
        }
        if (!part) {
            part.emplace();
            part->from = t;
        }
        part->to = t;
        part->faces.push_back(line.surfacePoints[i].face);
    }
    if (part) {
        sortUnique(part->faces);
    }
    return part;
}

}  // namespace

Curve curveOf(const Surface& surface, Solved& solved, const SamplingOptions& sampling) {
    auto& [problem, solution] = solved;
    Curve curve;
    describeShell(problem, solution, curve);
    curve.polyline =
        polylineOf(surface, problem, solution.curve, std::move(solution.trace), sampling);
    curve.spline = splineDataOf(solution.curve, problem.extended->frame, pickParametersOf(problem));
    curve.report = solution.report;
    if (!curve.report.usable) {
        curve.report.farPart = farPartOf(problem, solution.curve, curve.polyline);
    }
    return curve;
}

}  // namespace bspline_curve
