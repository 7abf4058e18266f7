// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/detours.h"

#include "design/initial_path.h"

#include <cstddef>
#include <vector>

namespace bspline_curve {
namespace {

double shortestLength(
    const PreparedSurface& prepared, const SurfacePoint& from, const SurfacePoint& to
) {
    const PickPath path = makePickPath(
        prepared.surface(),
        *prepared.extended(),
        {from, to},
        false,
        {.blockedFaces = {}, .patches = &prepared.patches()}
    );
    double length = 0.0;
    Vec3 before = prepared.surface().position(from);
    for (const InitialPath::Point& point : path.path.points) {
        const Vec3 here = prepared.surface().position(point.point);
        length += (here - before).norm();
        before = here;
    }
    return length;
}

}  // namespace

std::vector<CurveLeg> curveLegsOf(const SurfacePolyline& line) {
    std::vector<CurveLeg> legs;
    const auto count = static_cast<int>(line.points.size());
    const auto picks = static_cast<int>(line.picks.size());
    for (int i = 0; i + (line.closed ? 0 : 1) < picks; ++i) {
        const int from = line.picks[i];
        const int to = line.picks[(i + 1) % picks];
        double length = 0.0;
        for (int v = from; v != to; v = (v + 1) % count) {
            length += (line.points[(v + 1) % count] - line.points[v]).norm();
        }
        legs.push_back({line.surfacePoints[from], line.surfacePoints[to], length});
    }
    return legs;
}

std::optional<Detour> worstDetour(const PreparedSurface& prepared, const SurfacePolyline& line) {
    std::optional<Detour> worst;
    const std::vector<CurveLeg> legs = curveLegsOf(line);
    const auto picks = static_cast<int>(line.picks.size());
    for (int i = 0; i < static_cast<int>(legs.size()); ++i) {
        const auto& [from, to, length] = legs[i];
        const Surface& surface = prepared.surface();
        const double chord = (surface.position(to) - surface.position(from)).norm();
        if (length <= kNotedDetour * chord) {
            continue;
        }
        const double ratio = length / shortestLength(prepared, from, to);
        if (ratio > (worst ? worst->ratio : kNotedDetour)) {
            worst = Detour{.from = i, .to = (i + 1) % picks, .ratio = ratio};
        }
    }
    return worst;
}

}  // namespace bspline_curve
