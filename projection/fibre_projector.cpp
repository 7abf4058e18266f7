// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/fibre_projector.h"

#include "projection/face_fibres.h"
#include "surface/closest_point.h"
#include "utility/prefetch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace bspline_curve {
namespace {

// From so many faces away feet are sought by way of patches first.
constexpr double kManyFaces = 12.0;
// Rounding: a foot on an edge is in both of its faces.
constexpr double kOnEdge = -1e-9;
// Where a walk comes straight back, the foot lies in a gap or an overlap of the fibres of two faces
// this much wider than rounding.
constexpr double kInGap = -1e-3;
// Far more than any walk between neighbouring samples needs.
constexpr int kMostFaces = 200;
constexpr int kMostFibres = 200;
// Cycles are looked for only after so many, which few walks take.
constexpr int kManyFibres = 8;
constexpr int kMaxDescent = 1000;
constexpr int kMaxValence = 256;
// So many walks go in turns; with 32 and 64 curves take as long.
constexpr std::size_t kTogether = 16;

// The faces that share a point on the edge opposite to corner k of a face: the one across it, and
// where the point is a vertex those on around that, this way; the way from the other edge at it
// goes round the other side. Tells whether these are all around a vertex.
template <class Visit>
bool forEachAcross(
    const ExtendedSurface& extended, int face, int k, const Vec3& barycentric, const Visit& visit
) {
    const bool isFirstEnd = barycentric[(k + 1) % 3] <= 0.0;
    const bool isVertex = isFirstEnd || barycentric[(k + 2) % 3] <= 0.0;
    const int centre = extended.faces[face][(k + (isFirstEnd ? 2 : 1)) % 3];
    int other = extended.faceNeighbours[face][k];
    for (int turn = 0; other >= 0 && other != face && turn < kMaxValence; ++turn) {
        visit(other);
        if (!isVertex) {
            return false;
        }
        const int slot = cornerOf(extended.faces[other], centre);
        other = extended.faceNeighbours[other][(slot + (isFirstEnd ? 1 : 2)) % 3];
    }
    return other == face;
}

}  // namespace

// The edge that a foot lies farthest outside of, or nearest to.
struct FibreProjector::WayOut {
    int corner = 0;  // opposite to it
    double least;    // barycentric coordinate
    int face;        // across it

    WayOut(const ExtendedSurface& extended, const FootPoint& foot)
        : least(foot.barycentric().minCoeff(&corner)),
          face(extended.faceNeighbours[foot.face][corner]) {}
};

void FibreProjector::predict(const Vec3& moved, const FootFrame& frame, FootPoint& foot) {
    foot.u += frame.u.dot(moved);
    foot.v += frame.v.dot(moved);
    foot.height += frame.height.dot(moved);
}

bool FibreProjector::stayInFace(const FootPoint& foot, FootFrame& frame) const {
    if (foot.barycentric().minCoeff() < 0.0) {
        return false;
    }
    const FaceFibres fibres(extended_, foot.face);
    if (!fibres.frameAt(foot, frame)) {
        return false;
    }
    fibres.complete(frame);
    return true;
}

void FibreProjector::move(const Vec3& p, FootPoint& foot, FootFrame& frame) const {
    Walk walk{{p, &foot, &frame}, foot.face};
    while (!walk.isAtEnd) {
        step(walk);
    }
}

std::int64_t FibreProjector::moveAll(std::span<const Move> moves) const {
    std::int64_t facesSeen = 0;
    std::array<Walk, kTogether> walks;
    while (!moves.empty()) {
        const std::span<const Move> group = moves.first(std::min(kTogether, moves.size()));
        moves = moves.subspan(group.size());
        std::size_t count = 0;
        for (const Move& to : group) {
            walks[count++] = {to, to.foot->face};
            prefetchFace(to.foot->face);
        }
        while (count > 0) {
            const std::span<Walk> going(walks.data(), count);
            std::ranges::for_each(going, [&](const Walk& walk) { prefetchCorners(walk); });
            for (Walk& walk : going) {
                step(walk);
                facesSeen += walk.isAtEnd ? walk.facesSeen : 0;
            }
            count -= std::ranges::remove_if(going, &Walk::isAtEnd).size();
        }
    }
    return facesSeen;
}

void FibreProjector::prefetchFace(int face) const {
    prefetch(&extended_.faces[face]);
    prefetch(&extended_.faceNeighbours[face]);
}

void FibreProjector::prefetchCorners(const Walk& walk) const {
    if (!walk.isFar && FaceFibres::isFarOutside(*walk.to.foot)) {
        return;
    }
    for (const int corner : extended_.faces[walk.to.foot->face]) {
        prefetch(&extended_.vertices[corner]);
        if (!walk.isFar) {
            prefetch(&extended_.directions[corner]);
        }
    }
}

void FibreProjector::step(Walk& walk) const {
    ++walk.facesSeen;
    if (walk.isFar) {
        overFace(walk);
    } else {
        alongFibres(walk);
    }
}

// A face near p, by way of patches, or the same one. A way round a rim is left to walks, since the
// nearest patch may lie on the other side of a thin part.
int FibreProjector::faceTowards(const Vec3& p, int face, double facesAway) const {
    if (patches_ == nullptr || face >= extended_.surfaceFaceCount) {
        return face;
    }
    const PatchLevels::Samples* const samples =
        patches_->samplesTowards(extended_.frame.toUser(p), face, facesAway);
    if (samples == nullptr) {
        return face;
    }
    const auto cornerOf = [&](int of) { return (extended_.faces[of][0]); };
    int nearest = face;
    double least = (extended_.vertices[cornerOf(face)] - p).squaredNorm();
    for (const int sample : *samples) {
        if (sample < 0) {
            break;
        }
        const double distance = (extended_.vertices[cornerOf(sample)] - p).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = sample;
        }
    }
    const auto normalOf = [&](int of) {
        const FaceFibres fibres(extended_, of);
        return Vec3(fibres.edgeU().cross(fibres.edgeV()));
    };
    return normalOf(nearest).dot(normalOf(face)) > 0.0 ? nearest : face;
}

// Passes a face that p is far outside of, seen along its normal: many times faster than along its
// fibres, and the last steps find the foot all the same.
void FibreProjector::overFace(Walk& walk) const {
    const Vec3& p = walk.to.p;
    FootPoint& foot = *walk.to.foot;
    const Triangle& corners = extended_.faces[foot.face];
    const Vec3& corner = extended_.vertices[corners[0]];
    const Vec3 edgeU = extended_.vertices[corners[1]] - corner;
    const Vec3 edgeV = extended_.vertices[corners[2]] - corner;
    const Vec3 gap = p - corner;
    const Vec3 normal = edgeU.cross(edgeV);
    const double area = normal.squaredNorm();
    const double u = gap.cross(edgeV).dot(normal);
    const double v = edgeU.cross(gap).dot(normal);
    const Vec3 barycentric(area - u - v, u, v);  // times the area
    int outer = 0;
    const double least = barycentric.minCoeff(&outer);
    if (walk.facesPassed == 0 && least < -kManyFaces * area) {
        const int nearer = faceTowards(p, foot.face, -least / area);
        if (nearer != foot.face) {
            walk.previous = -1;
            enter(nearer, walk);
            return;
        }
    }
    const int next = extended_.faceNeighbours[foot.face][outer];
    if (least < FaceFibres::kFarOutside * area && next >= 0 && next != walk.previous) {
        walk.previous = foot.face;
        enter(next, walk);
        return;
    }
    if (walk.facesPassed > 0 && area > 0.0) {
        const Vec3 inside = barycentric.cwiseMax(1e-3 * area);
        foot.u = inside[1] / inside.sum();
        foot.v = inside[2] / inside.sum();
    }
    walk.isFar = false;
}

void FibreProjector::enter(int face, Walk& walk) const {
    walk.to.foot->face = face;
    walk.isFar = ++walk.facesPassed < kMostFaces;
    prefetchFace(face);
}

// Solves q(u, v) + height n(u, v) = p over one face.
void FibreProjector::alongFibres(Walk& walk) const {
    const auto& [p, foot, frame] = walk.to;
    if (isInCycle(walk)) {
        toNearest(walk);
        return;
    }
    if (FaceFibres::isFarOutside(*foot)) {
        walk.isFar = true;
        leave(WayOut(extended_, *foot), walk);
        return;
    }
    const FaceFibres fibres(extended_, foot->face);
    const FaceFibres::Outcome outcome = fibres.find<FaceFibres::Search::OnTheWay>(p, *foot, *frame);
    if (outcome == FaceFibres::Outcome::Crossed) {
        toNearest(walk);
        return;
    }
    const WayOut way(extended_, *foot);
    if (way.least >= kOnEdge || (way.least > kInGap && way.face == walk.previous)) {
        fibres.complete(*frame);
        walk.isAtEnd = true;
        return;
    }
    walk.isFar = outcome == FaceFibres::Outcome::FarOutside;
    leave(way, walk);
}

void FibreProjector::leave(const WayOut& way, Walk& walk) const {
    if (way.face < 0) {
        toNearest(walk);
        return;
    }
    walk.previous = walk.to.foot->face;
    walk.facesPassed = 0;
    carryOver(extended_, way.corner, way.face, *walk.to.foot);
    prefetchFace(way.face);
}

// Where fibres cross, a walk may come round to the same faces again and again.
bool FibreProjector::isInCycle(Walk& walk) {
    const int face = walk.to.foot->face;
    const int number = walk.fibresTried++;
    if (number < kManyFibres) {
        return false;
    }
    if (face == walk.marked || number == kMostFibres) {
        return true;
    }
    if (std::has_single_bit(static_cast<unsigned>(number))) {
        walk.marked = face;
    }
    return false;
}

// Ends a walk that fibres are of no use for: descends from the face where it is, or from that where
// it began if this is nearer.
void FibreProjector::toNearest(Walk& walk) const {
    walk.isAtEnd = true;
    const Vec3& p = walk.to.p;
    FootPoint& foot = *walk.to.foot;
    FootFrame& frame = *walk.to.frame;
    const auto nearestIn = [&](int face) {
        ++walk.facesSeen;
        return closestPointOnTriangle(extended_.vertices, extended_.faces[face], p);
    };
    int face = foot.face;
    ClosestPointOnTriangle nearest = nearestIn(face);
    if (walk.start != face) {
        const ClosestPointOnTriangle there = nearestIn(walk.start);
        if (there.squaredDistance < nearest.squaredDistance) {
            nearest = there;
            face = walk.start;
        }
    }
    bool found = true;
    for (int step = 0; found && step < kMaxDescent; ++step) {
        found = false;
        const auto compare = [&](int other) {
            const ClosestPointOnTriangle there = nearestIn(other);
            if (there.squaredDistance < nearest.squaredDistance) {
                nearest = there;
                face = other;
                found = true;
            }
        };
        const int here = face;
        const Vec3 barycentric = nearest.barycentric;
        bool areAllAround = false;
        for (int k = 0; k < 3 && !areAllAround; ++k) {
            if (barycentric[k] <= 0.0) {
                areAllAround = forEachAcross(extended_, here, k, barycentric, compare);
            }
        }
    }
    const FaceFibres fibres(extended_, face);
    foot.face = face;
    foot.u = nearest.barycentric[1];
    foot.v = nearest.barycentric[2];
    const Vec3 edgeU = fibres.edgeU();
    const Vec3 edgeV = fibres.edgeV();
    const Vec3 normal = edgeU.cross(edgeV);
    Vec3 direction = fibres.directionAt(foot);
    if (!(direction.dot(normal) > 0.0)) {
        direction = normal;  // a vertex that no direction sees all faces of
    }
    const Vec3 gap = p - nearest.position;
    const double distance = std::sqrt(nearest.squaredDistance);
    const double side = gap.dot(direction) < 0.0 ? -1.0 : 1.0;
    foot.height = side * distance;
    const double inverse = 1.0 / direction.dot(normal);
    frame.direction = direction;
    fibres.complete(frame);
    frame.height = distance > 0.0 ? Vec3(side / distance * gap) : frame.direction;
    frame.u = inverse * edgeV.cross(direction);
    frame.v = inverse * direction.cross(edgeU);
}

}  // namespace bspline_curve
