// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/near_tracer.h"

#include "surface/surface_point.h"

#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr int kMostWidenings = 3;

bool leaves(const CurveDistance& distance) {
    return !std::isfinite(distance.largest);
}

}  // namespace

CurveDistance NearTracer::measure(
    const SplineSpace& space, const ControlPoints& controls, const std::vector<FootAt>& feet
) {
    std::vector<int> below = facesBelow(problem_, space, controls, feet);
    addFacesAroundPicks(below);
    CurveDistance distance = measureOver(below, space, controls);
    for (int widening = 0; widening < kMostWidenings && leaves(distance); ++widening) {
        std::vector<int> places = placesFrom(distance.trace.wholeSpans + 1, space, controls, feet);
        if (!distance.trace.pieces.empty()) {
            places.push_back(near_->faces[at(distance.trace.pieces.back().face)]);
        }
        if (!widenAbout(places)) {
            break;
        }
        distance = measureOver(below, space, controls);
    }
    return distance;
}

CurveDistance NearTracer::measureOver(
    std::vector<int> faces, const SplineSpace& space, const ControlPoints& controls
) {
    faces.insert(faces.end(), widened_.begin(), widened_.end());
    near_ = std::make_shared<const NearShell>(
        *problem_.surface,
        *problem_.base,
        faces,
        NearShellSize{
            .rings = 0,
            .thickness = problem_.nearThickness,
            .least = kLeastNearTolerances * problem_.distanceTolerance
        }
    );
    return measureDistance(tracedShellOf(*near_, problem_.picks.front()), space, controls);
}

// Where the curve leaves its prisms on these spans, each traced by itself from its first foot.
std::vector<int> NearTracer::placesFrom(
    int firstSpan,
    const SplineSpace& space,
    const ControlPoints& controls,
    const std::vector<FootAt>& feet
) const {
    const auto ignorePiece = [](const ShellCell&, double, double) {};
    const auto ignoreCrossing = [](const ShellCell&, const ShellCell&, double, int) {};
    std::vector<int> places;
    auto foot = feet.begin();
    for (int span = firstSpan; span < space.spanCount(); ++span) {
        const double begin = space.breaks()[at(span)];
        while (foot != feet.end() && foot->parameter < begin) {
            ++foot;
        }
        if (foot == feet.end()) {
            break;
        }
        const double tau = (foot->parameter - begin) / space.spanLength(span);
        const SurfacePoint point = near_->here({foot->foot.face, foot->foot.barycentric()});
        if (tau >= 1.0 || point.face < 0) {
            continue;
        }
        TraceState state{ShellCell(near_->shell, point)};
        const PolynomialCurve curve = space.polynomial(controls, span).shifted(tau);
        const bool isInside =
            walkStraight(near_->shell, near_->base.position(point), curve.coefficients[0], state) &&
            tracePolynomial(near_->shell, curve, 1.0 - tau, state, ignorePiece, ignoreCrossing);
        if (!isInside) {
            places.push_back(near_->faces[at(state.cell.face)]);
        }
    }
    return places;
}

// Adds the faces that share a vertex with one of these. Returns whether any had no prism before:
// not where the curve leaves through the top or the bottom.
bool NearTracer::widenAbout(const std::vector<int>& places) {
    bool isNew = false;
    for (const int place : places) {
        if (place >= problem_.base->surfaceFaceCount) {
            continue;
        }
        for (const int vertex : problem_.base->faces[at(place)]) {
            for (const int face : problem_.surface->facesAround(vertex)) {
                isNew = isNew || near_->indexOf(face) < 0;
                widened_.push_back(face);
            }
        }
    }
    return isNew;
}

// A curve through a vertex may pass any of the faces there.
void NearTracer::addFacesAroundPicks(std::vector<int>& faces) const {
    for (const PickConstraint& pick : problem_.picks) {
        const std::vector<int> there = facesHolding(*problem_.surface, pick.point);
        faces.insert(faces.end(), there.begin(), there.end());
    }
}

}  // namespace bspline_curve
