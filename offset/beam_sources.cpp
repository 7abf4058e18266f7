// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/beam_sources.h"

#include "offset/face_layout.h"
#include "offset/surface_fan.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kQuarterTurn = std::numbers::pi / 2;
/// Sectors narrower than this hold no way that counts: an angle of rounding.
constexpr double kLeastAngle = 1e-12;
/// Beams from a vertex are this much wider, so that rounding opens no gaps beside them.
constexpr double kSpread = 1e-8;

/// Beams into the angles [from, to] of a fan.
void addSector(
    std::vector<DistanceBeam>& beams,
    const SurfaceFan& fan,
    double from,
    double to,
    SidedDistance distance
) {
    const double shift = fan.closed ? fan.angle : 0.0;
    for (const FanWedge& wedge : fan.wedges) {
        for (const double turn : {-shift, 0.0, shift}) {
            const double low = std::max(from + turn - wedge.start, 0.0);
            const double high = std::min(to + turn - wedge.start, wedge.width);
            if (high - low <= kLeastAngle) {
                continue;
            }
            DistanceBeam beam;
            beam.face = wedge.face;
            beam.exits = static_cast<std::uint8_t>(1U << static_cast<unsigned>(wedge.exit));
            beam.side = distance.side;
            beam.source = beam.leftOrigin = beam.rightOrigin = wedge.source;
            beam.before = distance.distance;
            beam.right = low == 0.0 ? wedge.first : Eigen::Rotation2Dd(low) * wedge.first;
            beam.left = high == wedge.width ? wedge.last : Eigen::Rotation2Dd(high) * wedge.first;
            beams.push_back(beam);
            if (shift == 0.0) {
                break;
            }
        }
    }
}

void addPoint(
    std::vector<DistanceBeam>& beams,
    const SurfaceFan& fan,
    std::optional<double> next,
    std::optional<double> previous
) {
    const auto sector = [&](double from, double to, CurveSide side) {
        // From one direction counter-clockwise to the other; an open fan may part it.
        from += kQuarterTurn;
        to -= kQuarterTurn;
        addSector(beams, fan, from, to, {.distance = 0.0, .side = side});
    };
    const auto around = [&](double from, double to, CurveSide side) {
        if (from < to) {
            sector(from, to, side);
        } else if (fan.closed) {
            sector(from, to + fan.angle, side);
        } else {
            sector(from, fan.angle + kQuarterTurn, side);
            sector(-kQuarterTurn, to, side);
        }
    };
    if (next && previous) {
        around(*next, *previous, CurveSide::Left);
        around(*previous, *next, CurveSide::Right);
    } else if (next || previous) {
        const double only = next ? *next : *previous;
        around(only, only, CurveSide::Cap);
    } else {
        addSector(beams, fan, 0.0, fan.angle, {.distance = 0.0, .side = CurveSide::Cap});
    }
}

void addSegment(
    std::vector<DistanceBeam>& beams,
    const Surface& surface,
    const SurfacePoint& begin,
    const SurfacePoint& end
) {
    const int face = commonFace(surface, begin, end);
    const FaceLayout layout(surface.vertices(), surface.faces()[face], 0);
    const Vec2 p = layout.position(inFace(surface, begin, face).barycentric);
    const Vec2 q = layout.position(inFace(surface, end, face).barycentric);
    const Vec2 left = turnedLeft((q - p).normalized());
    for (const CurveSide side : {CurveSide::Left, CurveSide::Right}) {
        DistanceBeam beam;
        beam.face = face;
        beam.fromLine = true;
        beam.side = side;
        beam.source = p;
        beam.normal = beam.left = beam.right = side == CurveSide::Left ? left : Vec2(-left);
        beam.leftOrigin = side == CurveSide::Left ? p : q;
        beam.rightOrigin = side == CurveSide::Left ? q : p;
        for (int k = 0; k < 3; ++k) {
            const Vec2 along = layout.corners[(k + 2) % 3] - layout.corners[(k + 1) % 3];
            if (cross(beam.normal, along) > kLeastAngle * along.norm()) {
                beam.exits |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(k));
            }
        }
        beams.push_back(beam);
    }
}

}  // namespace

std::vector<DistanceBeam> beamsOfPolyline(const Surface& surface, const SurfacePolyline& line) {
    std::vector<DistanceBeam> beams;
    // Vertices that do not move the curve on have no direction.
    std::vector<SurfacePoint> points;
    std::vector<Vec3> positions;
    for (const SurfacePoint& point : line.surfacePoints) {
        const Vec3 position = surface.position(point);
        if (positions.empty() || positions.back() != position) {
            points.push_back(point);
            positions.push_back(position);
        }
    }
    while (line.closed && points.size() > 1 && positions.back() == positions.front()) {
        points.pop_back();
        positions.pop_back();
    }
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        const bool hasNext = line.closed || i + 1 < count;
        const bool hasPrevious = line.closed || i > 0;
        const SurfacePoint& next = points[(i + 1) % count];
        const SurfacePoint& previous = points[(i + count - 1) % count];
        const SurfaceFan fan = fanOf(surface, points[i]);
        std::optional<double> ahead;
        std::optional<double> behind;
        if (hasNext) {
            addSegment(beams, surface, points[i], next);
            ahead = angleTowards(surface, fan, points[i], next);
        }
        if (hasPrevious) {
            behind = angleTowards(surface, fan, points[i], previous);
        }
        addPoint(beams, fan, ahead, behind);
    }
    return beams;
}

std::vector<DistanceBeam> beamsOfVertex(
    const Surface& surface, int vertex, const SidedDistance& distance, const VertexArrival& arrival
) {
    const SurfaceFan fan = fanOfVertex(surface, vertex);
    const double halfTurn = std::numbers::pi;
    const double whole = fan.closed ? 2 * halfTurn : halfTurn;
    std::vector<DistanceBeam> beams;
    if (fan.angle <= whole * (1 + kLeastAngle)) {
        return beams;
    }
    const auto wedge = std::ranges::find(fan.wedges, arrival.face, &FanWedge::face);
    if (wedge == fan.wedges.end()) {
        addSector(beams, fan, 0.0, fan.angle, distance);
        return beams;
    }
    const double came = wedge->start + std::clamp(arrival.angle, 0.0, wedge->width);
    const double first = came + halfTurn - kSpread;
    const double last = came - halfTurn + kSpread;
    if (fan.closed) {
        addSector(beams, fan, first, last + fan.angle, distance);
    } else {
        addSector(beams, fan, first, fan.angle, distance);
        addSector(beams, fan, 0.0, last, distance);
    }
    return beams;
}

}  // namespace bspline_curve
