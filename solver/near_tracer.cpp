// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/near_tracer.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Of all places at once, each time by as many rings as it takes.
constexpr int kMostWidenings = 3;
constexpr int kMostRings = 8;

bool leaves(const CurveDistance& distance) {
    return !std::isfinite(distance.largest);
}

}  // namespace

CurveDistance NearTracer::measure(
    const SplineSpace& space, const ControlPoints& controls, const std::vector<FootAt>& feet
) {
    const Spline spline{space, controls};
    std::vector<int> below = facesBelow(problem_, space, controls, feet);
    addFacesAroundPicks(0.0, 1.0, below);
    CurveDistance distance = measureOver(below, spline);
    for (int widening = 0; widening < kMostWidenings && leaves(distance); ++widening) {
        if (!widenWhereLeft(distance.trace, spline, feet)) {
            break;
        }
        distance = measureOver(below, spline);
    }
    return distance;
}

NearShell NearTracer::shellOver(const std::vector<int>& faces) const {
    return {
        *problem_.surface,
        *problem_.base,
        faces,
        NearShellSize{
            .rings = 0,
            .thickness = problem_.nearThickness,
            .least = kLeastNearTolerances * problem_.distanceTolerance
        }
    };
}

CurveDistance NearTracer::measureOver(std::vector<int> faces, const Spline& spline) {
    faces.insert(faces.end(), widened_.begin(), widened_.end());
    near_ = std::make_shared<const NearShell>(shellOver(faces));
    return measureDistance(
        tracedShellOf(*near_, problem_.picks.front()), spline.space, spline.controls
    );
}

// About the place where the trace ended, and beyond that wherever a stretch of the curve leaves the
// prisms. Returns whether any faces were added: not where it leaves through the top or the bottom
// alone.
bool NearTracer::widenWhereLeft(
    const ShadowTrace& trace, const Spline& spline, const std::vector<FootAt>& feet
) {
    const std::size_t before = widened_.size();
    if (!trace.pieces.empty()) {
        addMissing(ringAbout(near_->faces[at(trace.pieces.back().face)]));
    }
    for (const Stretch& stretch :
         stretchesFrom(std::max(0, trace.wholeSpans - 1), spline.space, feet)) {
        if (placeLeft(*near_, stretch, spline)) {
            widenUnder(stretch, spline);
        }
    }
    return widened_.size() > before;
}

void NearTracer::addMissing(const std::vector<int>& faces) {
    std::ranges::copy_if(faces, std::back_inserter(widened_), [this](int face) {
        return near_->indexOf(face) < 0;
    });
}

// Adds rings about where the curve leaves the prisms over a stretch of it until it leaves them no
// longer, or through the top or the bottom alone; that takes no more than prisms over this stretch.
void NearTracer::widenUnder(const Stretch& stretch, const Spline& spline) {
    std::vector<int> faces = facesBelow(*problem_.base, spline.space, spline.controls, stretch);
    addFacesAroundPicks(stretch.front().parameter, stretch.back().parameter, faces);
    for (int ring = 0; ring < kMostRings; ++ring) {
        const NearShell near = shellOver(faces);
        const std::optional<int> place = placeLeft(near, stretch, spline);
        if (!place) {
            return;
        }
        const std::vector<int> added = ringAbout(*place);
        if (std::ranges::all_of(added, [&](int face) { return near.indexOf(face) >= 0; })) {
            return;
        }
        faces.insert(faces.end(), added.begin(), added.end());
        addMissing(added);
    }
}

// From the first foot of each span to the first of the next one that has any; of the last to the
// last.
std::vector<NearTracer::Stretch> NearTracer::stretchesFrom(
    int firstSpan, const SplineSpace& space, const std::vector<FootAt>& feet
) {
    const auto firstFootOf = [&](int span) {
        return std::ranges::lower_bound(feet, space.breaks()[at(span)], {}, &FootAt::parameter);
    };
    std::vector<Stretch> stretches;
    auto begin = firstFootOf(firstSpan);
    for (int span = firstSpan; span < space.spanCount() && begin != feet.end(); ++span) {
        const auto next = firstFootOf(span + 1);
        const auto end = next != feet.end() ? next + 1 : next;
        if (next != begin) {
            stretches.emplace_back(begin, end);
        }
        begin = next;
    }
    return stretches;
}

// The face over which the curve leaves the prisms on a stretch, as the whole base calls it, if it
// does.
std::optional<int> NearTracer::placeLeft(
    const NearShell& near, const Stretch& stretch, const Spline& spline
) {
    const auto ignorePiece = [](const ShellCell&, double, double) {};
    const auto ignoreCrossing = [](const ShellCell&, const ShellCell&, double, int) {};
    const auto& [space, controls] = spline;
    const FootAt& first = stretch.front();
    const double last = stretch.back().parameter;
    const SurfacePoint point = near.here({first.foot.face, first.foot.barycentric()});
    if (point.face < 0) {
        return first.foot.face;
    }
    TraceState state{ShellCell(near.shell, point)};
    Vec3 position = near.base.position(point);
    double parameter = first.parameter;
    for (int span = space.spanAt(parameter); span < space.spanCount(); ++span) {
        const double begin = space.breaks()[at(span)];
        const double length = space.spanLength(span);
        const double tau = (parameter - begin) / length;
        const double end = std::min(1.0, (last - begin) / length);
        const PolynomialCurve curve = space.polynomial(controls, span).shifted(tau);
        // From the foot to the curve; between spans it is rounding.
        if (!walkStraight(near.shell, position, curve.coefficients[0], state) ||
            !tracePolynomial(near.shell, curve, end - tau, state, ignorePiece, ignoreCrossing)) {
            return near.faces[at(state.cell.face)];
        }
        if (end < 1.0) {
            break;
        }
        parameter = space.breaks()[at(span) + 1];
        position = curve.at(end - tau);
    }
    return std::nullopt;
}

// The faces of the surface that share a vertex with one.
std::vector<int> NearTracer::ringAbout(int face) const {
    std::vector<int> ring;
    if (face < problem_.base->surfaceFaceCount) {
        for (const int vertex : problem_.base->faces[at(face)]) {
            const Surface::FaceRange around = problem_.surface->facesAround(vertex);
            ring.insert(ring.end(), around.begin(), around.end());
        }
    }
    return ring;
}

// A curve through a vertex may pass any of the faces there.
void NearTracer::addFacesAroundPicks(double begin, double end, std::vector<int>& faces) const {
    for (const PickConstraint& pick : problem_.picks) {
        if (pick.parameter < begin || pick.parameter > end) {
            continue;
        }
        const std::vector<int> there = facesHolding(*problem_.surface, pick.point);
        faces.insert(faces.end(), there.begin(), there.end());
    }
}

}  // namespace bspline_curve
