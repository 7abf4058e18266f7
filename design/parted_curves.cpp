// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/parted_curves.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "design/detours.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

constexpr double kJoiningShare = 0.1;  // of the progress

/// The legs of a curve that is still to be drawn.
std::vector<CurveLeg> legsBetween(
    const TriangleTree& tree, const std::vector<Vec3>& picks, bool closed
) {
    std::vector<SurfacePoint> points;
    for (const Vec3& pick : picks) {
        points.push_back(tree.closestPoint(pick).point);
    }
    if (closed) {
        points.push_back(points.front());
    }
    std::vector<CurveLeg> legs;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        legs.push_back({points[i], points[i + 1], std::numeric_limits<double>::infinity()});
    }
    return legs;
}

/// The legs that go farther than they need. `isRejoined`: on the mesh that was joined for the ways.
std::vector<Detour> detoursOf(
    const SurfacePolyline& line, const RejoinedSurfaces::Ways& ways, bool isRejoined
) {
    const std::vector<CurveLeg> legs = curveLegsOf(line);
    std::vector<Detour> detours;
    const auto count = static_cast<int>(line.picks.size());
    const auto detourOf = [&](int leg, double ratio, Detour::Round round) {
        return Detour{.from = leg, .to = (leg + 1) % count, .ratio = ratio, .round = round};
    };
    for (const auto& [leg, before, shortest, isOverSlit] : ways.shorter) {
        if (isOverSlit || !isRejoined) {
            detours.push_back(detourOf(
                leg,
                legs[leg].length / shortest,
                isOverSlit ? Detour::Round::Slit : Detour::Round::Cut
            ));
        }
    }
    for (std::size_t i = 0; isRejoined && i < legs.size(); ++i) {
        const double ratio = legs[i].length / ways.lengths[i];
        if (ratio > kNotedDetour &&
            std::ranges::find(detours, static_cast<int>(i), &Detour::from) == detours.end()) {
            detours.push_back(detourOf(static_cast<int>(i), ratio, Detour::Round::Cut));
        }
    }
    std::ranges::sort(detours, {}, &Detour::from);
    return detours;
}

}  // namespace

Curve PartedCurves::design(
    const CurveTask& task, std::span<const int> avoid, const Progress& progress
) {
    std::optional<Curve> curve;
    std::optional<InputError> refusal;
    try {
        curve = curves_.design(task, progress);
    } catch (const InputError& error) {
        if (error.code() != InputErrorCode::PicksOnDifferentComponents &&
            error.code() != InputErrorCode::NoPath) {
            throw;
        }
        refusal = error;
    }
    const std::vector<CurveLeg> legs =
        curve ? curveLegsOf(curve->polyline)
              : legsBetween(curves_.tree(), task.picks, task.options.closed);
    if (curve) {
        curves_.surface().provenance().bringToInput(*curve);
    }
    const Progress rest = partOf(progress, curve ? 1.0 : 0.0, 1.0);
    const RejoinedSurfaces::Ways ways = rejoined_.waysFor(legs, task.avoid, rest);
    bool isRejoined = false;
    if (!ways.steps.empty()) {
        std::optional<Curve> other = designRejoined(ways.steps, task, avoid, rest);
        // With a field it is the field's matter how long a curve is.
        if (other && (!curve || (other->report.usable &&
                                 (!task.field.empty() || !curve->report.usable ||
                                  lengthOf(other->polyline) < lengthOf(curve->polyline))))) {
            curve = std::move(other);
            isRejoined = true;
        }
    }
    if (!curve) {
        const bool isSlit =
            std::ranges::any_of(ways.shorter, [](const auto& leg) { return leg.isOverSlit; });
        const std::string slits =
            isSlit ? "; slits part them, which are joined without the options strict and slits"
                   : "";
        throw InputError(refusal->code(), refusal->what() + slits, refusal->elements());
    }
    for (const Detour& detour : detoursOf(curve->polyline, ways, isRejoined)) {
        std::erase_if(curve->report.detours, [&](const Detour& d) {
            return d.from == detour.from;
        });
        curve->report.detours.push_back(detour);
    }
    std::ranges::sort(curve->report.detours, {}, &Detour::from);
    return *std::move(curve);
}

// Nothing where it does not help; with the ids of the input.
std::optional<Curve> PartedCurves::designRejoined(
    const std::vector<Step>& steps,
    const CurveTask& task,
    std::span<const int> avoid,
    const Progress& progress
) {
    const auto there =
        rejoined_.curvesFor(steps, curves_.options(), partOf(progress, 0.0, kJoiningShare));
    if (there == nullptr) {
        return std::nullopt;
    }
    const Provenance& provenance = there->surface().provenance();
    CurveTask same = task;
    same.field = rejoinedField(curves_.surface(), task.field, there->surface());
    same.avoid = provenance.facesFromInput(avoid);
    same.start = nullptr;
    try {
        Curve curve = there->design(same, partOf(progress, kJoiningShare, 1.0));
        provenance.bringToInput(curve);
        return curve;
    } catch (const InputError&) {
        return std::nullopt;  // what is wrong without the ways says more
    }
}

}  // namespace bspline_curve
