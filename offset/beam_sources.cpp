// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/beam_sources.h"

#include "offset/face_layout.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kQuarterTurn = std::numbers::pi / 2;
/// Sectors narrower than this hold no way that counts: an angle of rounding.
constexpr double kLeastAngle = 1e-12;

/// A part of the surroundings of a point: what one side of one face subtends.
struct Wedge {
    int face, exit;
    Vec2 source, first, last;  ///< in the face's layout with frame 0; directions, counter-clockwise
    double start, width;       ///< angles
};

struct Fan {
    std::vector<Wedge> wedges;  ///< counter-clockwise
    double angle = 0.0;         ///< of all
    bool closed = true;         ///< false: the surface's boundary lies between last and first
};

double angleBetween(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), a.dot(b));
}

void addWedge(Fan& fan, const Surface& surface, const SurfacePoint& at, int exit) {
    const FaceLayout layout(surface.vertices(), surface.faces()[at.face], 0);
    const Vec2 source = layout.position(at.barycentric);
    const Vec2 first = (layout.corners[(exit + 1) % 3] - source).normalized();
    const Vec2 last = (layout.corners[(exit + 2) % 3] - source).normalized();
    const double width = angleBetween(first, last);
    fan.wedges.push_back(
        {.face = at.face,
         .exit = exit,
         .source = source,
         .first = first,
         .last = last,
         .start = fan.angle,
         .width = width}
    );
    fan.angle += width;
}

Fan fanOfVertex(const Surface& surface, int vertex) {
    Fan fan;
    fan.closed = !surface.isBoundaryVertex(vertex);
    for (const int f : surface.facesAround(vertex)) {
        const int corner = cornerOf(surface.faces()[f], vertex);
        addWedge(fan, surface, {.face = f, .barycentric = Vec3::Unit(corner)}, corner);
    }
    return fan;
}

Fan fanOf(const Surface& surface, const SurfacePoint& given) {
    const SurfacePoint point = snapped(given, kOnEdgeBarycentric);
    std::vector<int> zeros;
    for (int k = 0; k < 3; ++k) {
        if (point.barycentric[k] == 0.0) {
            zeros.push_back(k);
        }
    }
    if (zeros.size() == 2) {
        return fanOfVertex(surface, surface.faces()[point.face][3 - zeros[0] - zeros[1]]);
    }
    Fan fan;
    if (zeros.empty()) {
        for (int k = 0; k < 3; ++k) {
            addWedge(fan, surface, point, k);
        }
        return fan;
    }
    const int side = zeros.front();
    addWedge(fan, surface, point, (side + 1) % 3);
    addWedge(fan, surface, point, (side + 2) % 3);
    const int across = surface.faceNeighbours()[point.face][side];
    fan.closed = across >= 0;
    if (fan.closed) {
        const SurfacePoint there = inFace(surface, point, across);
        int thatSide = 0;
        there.barycentric.minCoeff(&thatSide);
        addWedge(fan, surface, there, (thatSide + 1) % 3);
        addWedge(fan, surface, there, (thatSide + 2) % 3);
    }
    return fan;
}

/// The angle in the fan at which another point lies that shares a face with the fan's point.
double angleTowards(
    const Surface& surface, const Fan& fan, const SurfacePoint& from, const SurfacePoint& to
) {
    const int face = commonFace(surface, from, to);
    const FaceLayout layout(surface.vertices(), surface.faces()[face], 0);
    const Vec2 target = layout.position(inFace(surface, to, face).barycentric);
    double best = std::numeric_limits<double>::infinity();
    double angle = 0.0;
    for (const Wedge& wedge : fan.wedges) {
        if (wedge.face == face) {
            const double within = angleBetween(wedge.first, target - wedge.source);
            const double outside = std::max({-within, within - wedge.width, 0.0});
            if (outside < best) {
                best = outside;
                angle = wedge.start + std::clamp(within, 0.0, wedge.width);
            }
        }
    }
    return angle;
}

/// Beams into the angles [from, to] of a fan.
void addSector(
    std::vector<DistanceBeam>& beams, const Fan& fan, double from, double to, SidedDistance distance
) {
    const double shift = fan.closed ? fan.angle : 0.0;
    for (const Wedge& wedge : fan.wedges) {
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
    const Fan& fan,
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
    } else {
        const double only = next ? *next : previous.value_or(0.0);
        around(only, only, CurveSide::Cap);
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
        const Fan fan = fanOf(surface, points[i]);
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
    const Surface& surface, int vertex, const SidedDistance& distance
) {
    const Fan fan = fanOfVertex(surface, vertex);
    const double whole = fan.closed ? 2 * std::numbers::pi : std::numbers::pi;
    std::vector<DistanceBeam> beams;
    if (fan.angle > whole * (1 + kLeastAngle)) {
        addSector(beams, fan, 0.0, fan.angle, distance);
    }
    return beams;
}

}  // namespace bspline_curve
