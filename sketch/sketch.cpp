// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/sketch.h"

#include "utility/index_sets.h"

#include <algorithm>

namespace bspline_curve {

bool SketchCurve::asksForTheSame(const SketchCurve& other) const {
    const auto samePick = [](const SketchPick& a, const SketchPick& b) {
        return a.point.face == b.point.face && a.point.barycentric == b.point.barycentric &&
               a.position == b.position && a.isCorner == b.isCorner && a.tangent == b.tangent;
    };
    return options.solver == other.options.solver && options.guides == other.options.guides &&
           std::ranges::equal(picks, other.picks, samePick);
}

std::vector<Vec3> SketchCurve::positions() const {
    std::vector<Vec3> positions;
    for (const SketchPick& pick : picks) {
        positions.push_back(pick.position);
    }
    return positions;
}

std::vector<int> SketchCurve::corners() const {
    return indicesWhere<int>(picks.size(), [this](std::size_t i) { return picks[i].isCorner; });
}

std::vector<PickTangent> SketchCurve::tangents() const {
    std::vector<PickTangent> tangents;
    for (const SketchPick& pick : picks) {
        tangents.push_back(pick.tangent);
    }
    const bool areAny = std::ranges::all_of(tangents, &PickTangent::isAny);
    return areAny ? std::vector<PickTangent>() : tangents;
}

std::vector<Vec3> SketchCurve::shownPoints() const {
    const Curve* const curve = settled ? settled.get() : last.get();
    if (curve == nullptr) {
        return {};
    }
    const SurfacePolyline& line = curve->polyline;
    std::vector<Vec3> points = line.points;
    if (settled || lastPicks.size() != picks.size() || line.closed != options.solver.closed) {
        return points;
    }
    // Between two picks by what is between their displacements.
    const std::size_t pieces = line.closed ? picks.size() : picks.size() - 1;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        const std::size_t next = (piece + 1) % picks.size();
        const auto first = static_cast<std::size_t>(line.picks[piece]);
        const std::size_t end = next == 0 ? points.size() : line.picks[next];
        const double begin = line.parameters[first];
        const double length = (next == 0 ? 1.0 : line.parameters[end]) - begin;
        for (std::size_t i = first; i < end; ++i) {
            const double s = (line.parameters[i] - begin) / length;
            points[i] += (1.0 - s) * (picks[piece].position - lastPicks[piece]) +
                         s * (picks[next].position - lastPicks[next]);
        }
    }
    if (!line.closed) {
        points.back() += picks.back().position - lastPicks.back();
    }
    return points;
}

void SketchHistory::add(const Sketch& state) {
    if (state == now()) {
        return;
    }
    states_.resize(position_ + 1);
    states_.push_back(state);
    if (states_.size() > kMostStates) {
        states_.erase(states_.begin());
    }
    position_ = states_.size() - 1;
}

}  // namespace bspline_curve
