// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/foot_point.h"

#include "surface/closest_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Newton's method on a face: it converges quadratically, so what a step this small leaves is 1e-9
// at most, in barycentric coordinates.
constexpr double kLastStep = 1e-5;
constexpr int kMaxSteps = 6;
// The foot lies in another face for certain: no need to converge first.
constexpr double kFarOutside = -0.3;
// From so many faces away feet are sought by way of patches first.
constexpr double kManyFaces = 12.0;
// Rounding: a foot on an edge is in both of its faces.
constexpr double kOnEdge = -1e-9;
// Where a walk comes straight back, the foot lies in a gap or an overlap of the fibres of two faces
// this much wider than rounding.
constexpr double kInGap = -1e-3;
// Far more than any walk between neighbouring samples needs.
constexpr int kMaxCrossings = 200;
// The fibres of a face narrow with the height; where the area that they leave is less than this
// share, feet would run away.
constexpr double kLeastArea = 0.05;
constexpr int kMaxDescent = 1000;
constexpr int kMaxValence = 256;

double leastCoordinate(const Eigen::Array2d& uv) {
    return std::min(uv.minCoeff(), 1.0 - uv.sum());
}

// Which corner of a face a vertex is; -1: none.
int slotOf(const Triangle& face, int vertex) {
    for (int k = 0; k < 3; ++k) {
        if (face[at(k)] == vertex) {
            return k;
        }
    }
    return -1;
}

// The same point seen from the face across the edge opposite to corner k, moved onto that edge.
void carryOver(const Triangle& from, const Triangle& to, int k, FootPoint& foot) {
    const Vec3 before = foot.barycentric();
    Vec3 after = Vec3::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        const int slot = corner == k ? -1 : slotOf(to, from[at(corner)]);
        if (slot >= 0) {
            after[slot] = std::clamp(before[corner], 0.0, 1.0);
        }
    }
    const double sum = after.sum();
    if (sum > 0.0) {
        after /= sum;
    }
    foot.u = after[1];
    foot.v = after[2];
}

// The faces that share a point on the edge opposite to corner k of a face: the one across it, and
// where the point is a vertex those on around that, this way; the way from the other edge at it
// goes round the other side.
template <class Visit>
void forEachAcross(
    const ShellBase& base, int face, int k, const Vec3& barycentric, const Visit& visit
) {
    const bool isFirstEnd = barycentric[(k + 1) % 3] <= 0.0;
    const bool isVertex = isFirstEnd || barycentric[(k + 2) % 3] <= 0.0;
    const int centre = base.faces[at(face)][at((k + (isFirstEnd ? 2 : 1)) % 3)];
    int other = base.faceNeighbours[at(face)][at(k)];
    for (int turn = 0; other >= 0 && other != face && turn < kMaxValence; ++turn) {
        visit(other);
        if (!isVertex) {
            return;
        }
        const int slot = slotOf(base.faces[at(other)], centre);
        other = base.faceNeighbours[at(other)][at((slot + (isFirstEnd ? 1 : 2)) % 3)];
    }
}

}  // namespace

// Two vectors side by side, by u and by v, so that both are computed at once.
struct FootFinder::PairOfVectors {
    Eigen::Array2d x, y, z;

    static PairOfVectors of(const Vec3& u, const Vec3& v) {
        return {{u.x(), v.x()}, {u.y(), v.y()}, {u.z(), v.z()}};
    }

    [[nodiscard]] Vec3 u() const { return {x[0], y[0], z[0]}; }

    [[nodiscard]] Vec3 v() const { return {x[1], y[1], z[1]}; }

    [[nodiscard]] Vec3 times(const Eigen::Array2d& uv) const {
        return {(x * uv).sum(), (y * uv).sum(), (z * uv).sum()};
    }

    [[nodiscard]] PairOfVectors plus(double scale, const PairOfVectors& other) const {
        return {x + scale * other.x, y + scale * other.y, z + scale * other.z};
    }

    [[nodiscard]] PairOfVectors crossedFromLeftBy(const Vec3& a) const {
        return {a.y() * z - a.z() * y, a.z() * x - a.x() * z, a.x() * y - a.y() * x};
    }

    [[nodiscard]] Eigen::Array2d dot(const Vec3& a) const {
        return a.x() * x + a.y() * y + a.z() * z;
    }
};

// The corner 0 of a face with the edges from there, and the same of the directions.
struct FootFinder::Fibres {
    Vec3 corner, direction;
    PairOfVectors edges, turns;

    [[nodiscard]] Vec3 directionAt(const FootPoint& foot) const {
        return direction + turns.times({foot.u, foot.v});
    }
};

FootFinder::Fibres FootFinder::fibresOver(int face) const {
    const Triangle& corners = base_.faces[at(face)];
    const Vec3& origin = base_.vertices[at(corners[0])];
    const Vec3& direction = base_.directions[at(corners[0])];
    return {
        origin,
        direction,
        PairOfVectors::of(
            base_.vertices[at(corners[1])] - origin, base_.vertices[at(corners[2])] - origin
        ),
        PairOfVectors::of(
            base_.directions[at(corners[1])] - direction,
            base_.directions[at(corners[2])] - direction
        )
    };
}

void FootFinder::predict(const Vec3& moved, const FootFrame& frame, FootPoint& foot) {
    foot.u += frame.u.dot(moved);
    foot.v += frame.v.dot(moved);
    foot.height += frame.height.dot(moved);
}

void FootFinder::move(const Vec3& p, FootPoint& foot, FootFrame& frame) const {
    const int start = foot.face;
    if (!alongFibres(p, foot, frame)) {
        toNearest(p, start, foot, frame);
    }
}

// A face near p, by way of patches, or the same one. A way round a rim is left to walks, since the
// nearest patch may lie on the other side of a thin part.
int FootFinder::faceTowards(const Vec3& p, int face, double facesAway) const {
    if (patches_ == nullptr || face >= base_.surfaceFaceCount) {
        return face;
    }
    const PatchLevels::Samples* const samples =
        patches_->samplesTowards(base_.frame.toUser(p), face, facesAway);
    if (samples == nullptr) {
        return face;
    }
    const auto cornerOf = [&](int of) { return at(base_.faces[at(of)][0]); };
    int nearest = face;
    double least = (base_.vertices[cornerOf(face)] - p).squaredNorm();
    for (const int sample : *samples) {
        if (sample < 0) {
            break;
        }
        const double distance = (base_.vertices[cornerOf(sample)] - p).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = sample;
        }
    }
    const auto normalOf = [&](int of) {
        const PairOfVectors edges = fibresOver(of).edges;
        return Vec3(edges.u().cross(edges.v()));
    };
    return normalOf(nearest).dot(normalOf(face)) > 0.0 ? nearest : face;
}

// Walks on over faces that p is far outside of, seen along their normals: many times faster than
// along their fibres, and the last steps find the foot all the same. Returns the face before that
// where it ends.
int FootFinder::passFaces(const Vec3& p, int previous, FootPoint& foot) const {
    for (int crossing = 0; crossing < kMaxCrossings; ++crossing) {
        const Triangle& corners = base_.faces[at(foot.face)];
        const Vec3& corner = base_.vertices[at(corners[0])];
        const Vec3 edgeU = base_.vertices[at(corners[1])] - corner;
        const Vec3 edgeV = base_.vertices[at(corners[2])] - corner;
        const Vec3 gap = p - corner;
        const Vec3 normal = edgeU.cross(edgeV);
        const double area = normal.squaredNorm();
        const double u = gap.cross(edgeV).dot(normal);
        const double v = edgeU.cross(gap).dot(normal);
        const Vec3 barycentric(area - u - v, u, v);  // times the area
        int outer = 0;
        const double least = barycentric.minCoeff(&outer);
        if (crossing == 0 && least < -kManyFaces * area) {
            const int nearer = faceTowards(p, foot.face, -least / area);
            if (nearer != foot.face) {
                foot.face = nearer;
                previous = -1;
                continue;
            }
        }
        const bool isFar = least < kFarOutside * area;
        const int next = base_.faceNeighbours[at(foot.face)][at(outer)];
        if (!isFar || next < 0 || next == previous) {
            if (crossing > 0 && area > 0.0) {
                const Vec3 inside = barycentric.cwiseMax(1e-3 * area);
                foot.u = inside[1] / inside.sum();
                foot.v = inside[2] / inside.sum();
            }
            break;
        }
        previous = std::exchange(foot.face, next);
    }
    return previous;
}

// Solves q(u, v) + height n(u, v) = p face by face.
bool FootFinder::alongFibres(const Vec3& p, FootPoint& foot, FootFrame& frame) const {
    int previous = -1;
    for (int crossing = 0; crossing < kMaxCrossings; ++crossing) {
        const Fibres fibres = fibresOver(foot.face);
        const double flatArea = fibres.direction.dot(fibres.edges.u().cross(fibres.edges.v()));
        Eigen::Array2d uv(foot.u, foot.v);
        bool isFar = leastCoordinate(uv) < kFarOutside;
        for (int step = 0; step < kMaxSteps && !isFar; ++step) {
            const PairOfVectors by = fibres.edges.plus(foot.height, fibres.turns);
            const Vec3 direction = fibres.direction + fibres.turns.times(uv);
            const Vec3 area = by.u().cross(by.v());
            const double determinant = direction.dot(area);
            if (!(determinant > kLeastArea * flatArea)) {
                return false;
            }
            const double inverse = 1.0 / determinant;
            const PairOfVectors across = by.crossedFromLeftBy(direction);
            const Vec3 gap = p - fibres.corner - fibres.edges.times(uv) - foot.height * direction;
            const Eigen::Array2d turned = inverse * across.dot(gap);
            const Eigen::Array2d move(-turned[1], turned[0]);
            uv += move;
            foot.height += inverse * area.dot(gap);
            isFar = leastCoordinate(uv) < kFarOutside;
            if (move.abs().sum() < kLastStep || step + 1 == kMaxSteps) {
                frame.height = inverse * area;
                frame.u = -inverse * across.v();
                frame.v = inverse * across.u();
                frame.direction = direction;
                break;
            }
        }
        foot.u = uv[0];
        foot.v = uv[1];
        int outer = 0;
        const double least = foot.barycentric().minCoeff(&outer);
        const int next = base_.faceNeighbours[at(foot.face)][at(outer)];
        if (least >= kOnEdge || (least > kInGap && next == previous)) {
            frame.direction.normalize();
            frame.turnU = fibres.turns.u();
            frame.turnV = fibres.turns.v();
            return true;
        }
        if (next < 0) {
            return false;
        }
        previous = foot.face;
        carryOver(base_.faces[at(foot.face)], base_.faces[at(next)], outer, foot);
        foot.face = next;
        if (isFar) {
            previous = passFaces(p, previous, foot);
        }
    }
    return false;
}

// Descends from the face where the walk ended, or from that where it began if this is nearer.
void FootFinder::toNearest(const Vec3& p, int start, FootPoint& foot, FootFrame& frame) const {
    const auto nearestIn = [&](int face) {
        return closestPointOnTriangle(base_.vertices, base_.faces[at(face)], p);
    };
    int face = foot.face;
    ClosestPointOnTriangle nearest = nearestIn(face);
    if (start != face) {
        const ClosestPointOnTriangle there = nearestIn(start);
        if (there.squaredDistance < nearest.squaredDistance) {
            nearest = there;
            face = start;
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
        for (int k = 0; k < 3; ++k) {
            if (barycentric[k] <= 0.0) {
                forEachAcross(base_, here, k, barycentric, compare);
            }
        }
    }
    const Fibres fibres = fibresOver(face);
    foot.face = face;
    foot.u = nearest.barycentric[1];
    foot.v = nearest.barycentric[2];
    const Vec3 edgeU = fibres.edges.u();
    const Vec3 edgeV = fibres.edges.v();
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
    frame.direction = direction.normalized();
    frame.height = distance > 0.0 ? Vec3(side / distance * gap) : frame.direction;
    frame.u = inverse * edgeV.cross(direction);
    frame.v = inverse * direction.cross(edgeU);
    frame.turnU = fibres.turns.u();
    frame.turnV = fibres.turns.v();
}

}  // namespace bspline_curve
