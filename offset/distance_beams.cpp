// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/distance_beams.h"

#include "bspline_curve/progress.h"
#include "offset/beam_sources.h"
#include "offset/face_layout.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

/// Beams are this much wider than they are, and a bound must be this much better to drop one
/// (relative to the face), so that rounding opens no gaps between neighbours.
constexpr double kSlack = 1e-9;

constexpr std::size_t kEventsPerReport = 4096;
/// Of events whose distances are alike, in mean edge lengths: less spares no work.
constexpr double kBucketWidth = 0.25;
constexpr double kMostBuckets = 65536;

/// The part of a side of a face that a beam reaches, as fractions from its first corner.
struct Window {
    double from = 0.0, to = 1.0;
};

/// What a half-plane, given by the signed distances of a side's ends from it, leaves of a window.
void clip(Window& window, double atFirst, double atLast) {
    if (atFirst >= 0 && atLast >= 0) {
        return;
    }
    if (atFirst < 0 && atLast < 0) {
        window = {.from = 1.0, .to = 0.0};
        return;
    }
    const double crossing = atFirst / (atFirst - atLast);
    if (atFirst < 0) {
        window.from = std::max(window.from, crossing);
    } else {
        window.to = std::min(window.to, crossing);
    }
}

/// A beam that comes to a face through the side on its x axis, or a vertex that was reached. Small,
/// since there are as many at once as sides that a front crosses, times tens.
struct Event {
    double key = 0.0;  ///< distance of what it reaches first
    int face = -1;     ///< or the vertex
    std::uint8_t frame = 0;
    bool isVertex = false;
    bool fromLine = false;
    CurveSide side = CurveSide::Left;
    double before = 0.0;
    double from = 0.0, to = 0.0;  ///< the beam's part of the x axis
    Vec2 source = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
    Vec2 apex = Vec2::Zero();  ///< corner of the face
    double length = 0.0;
};

/// Events, by buckets of keys, in the order of creation within one. It need not be sharper: an
/// order only spares work, since what is found too late is found again.
class EventQueue {
public:
    EventQueue(double width, double longest)
        : width_(width), buckets_(static_cast<std::size_t>(longest / width) + 1) {}

    void push(const Event& event) {
        const auto place = static_cast<std::size_t>(event.key / width_);
        Bucket& bucket = buckets_[std::clamp(place, current_, buckets_.size() - 1)];
        if (bucket.capacity() == 0 && !spare_.empty()) {
            bucket = std::move(spare_.back());
            spare_.pop_back();
        }
        bucket.push_back(event);
    }

    /// False where nothing is left.
    bool advance() {
        while (next_ == buckets_[current_].size()) {
            if (current_ + 1 == buckets_.size()) {
                return false;
            }
            Bucket& done = buckets_[current_++];
            next_ = 0;
            if (done.capacity() > 0) {
                done.clear();
                spare_.push_back(std::move(done));
            }
        }
        return true;
    }

    /// The next one, after advance().
    Event pop() { return buckets_[current_][next_++]; }

private:
    using Bucket = std::vector<Event>;

    double width_;
    std::vector<Bucket> buckets_;
    std::vector<Bucket> spare_;  // empty ones, whose memory is used again
    std::size_t current_ = 0, next_ = 0;
};

class Propagation {
public:
    Propagation(
        const Surface& surface,
        const DistanceRange& range,
        std::vector<std::vector<DistanceBeam>>& beams,
        std::vector<char>& isReached,
        std::vector<SidedDistance>& vertices
    )
        : surface_(surface),
          range_(range),
          beams_(beams),
          isReached_(isReached),
          vertices_(vertices),
          arrivals_(vertices.size()),
          queue_(
              std::max(kBucketWidth * surface.averageEdgeLength(), range.to / kMostBuckets),
              range.to
          ) {}

    void start(std::span<const DistanceBeam> beams) {
        for (const DistanceBeam& beam : beams) {
            reachCorners(beam, layout(beam), true);
        }
        for (const DistanceBeam& beam : beams) {
            goOn(beam, layout(beam));
        }
    }

    void run(const Progress& progress) {
        double reached = 0.0;
        for (std::size_t count = 0; queue_.advance(); ++count) {
            const Event event = queue_.pop();
            reached = std::max(reached, event.key);
            if (count % kEventsPerReport == 0) {
                report(progress, reached / range_.to, "measuring distances");
            }
            if (!event.isVertex) {
                goOn(beamOf(event), FaceLayout(event.length, event.apex, event.frame));
            } else if (const SidedDistance& vertex = vertices_[event.face];
                       event.key == vertex.distance) {
                start(beamsOfVertex(surface_, event.face, vertex, arrivals_[event.face]));
            }
        }
    }

private:
    /// Where all of the beam in its face is nearer than the range, the corners bound distances.
    void keep(const DistanceBeam& beam, const FaceLayout& face) {
        isReached_[beam.face] = 1;
        if (range_.from == std::numeric_limits<double>::infinity()) {
            return;
        }
        double most = 0.0;
        for (const Vec2& corner : face.corners) {
            most = std::max(most, beam.distance(corner));
        }
        if (most + face.size() >= range_.from) {
            beams_[beam.face].push_back(beam);
        }
    }

    [[nodiscard]] FaceLayout layout(const DistanceBeam& beam) const {
        return {surface_.vertices(), surface_.faces()[beam.face], beam.frame};
    }

    void reachCorners(const DistanceBeam& beam, const FaceLayout& face, bool all) {
        const double tolerance = kSlack * face.extent();
        for (int k = 0; k < 3; ++k) {
            if ((all || k == beam.frame) && beam.contains(face.corners[k], tolerance)) {
                const int vertex = surface_.faces()[beam.face][k];
                // A line's distances are negative behind it, by rounding.
                const double distance = std::max(beam.distance(face.corners[k]), 0.0);
                const bool ahead = beam.distance(face.corners[k]) >= -tolerance;
                if (ahead && distance < vertices_[vertex].distance) {
                    vertices_[vertex] = {.distance = distance, .side = beam.side};
                    arrivals_[vertex] = arrivalOf(beam, face, k);
                    if (distance <= range_.to) {
                        queue_.push({.key = distance, .face = vertex, .isVertex = true});
                    }
                }
            }
        }
    }

    /// At a corner of the beam's face; not known where the beam starts there.
    [[nodiscard]] static VertexArrival arrivalOf(
        const DistanceBeam& beam, const FaceLayout& face, int corner
    ) {
        const Vec2& at = face.corners[corner];
        const Vec2 back = beam.fromLine ? Vec2(-beam.normal) : Vec2(beam.source - at);
        if (beam.distance(at) <= 0.0 || back.isZero()) {
            return {};
        }
        return {
            .face = beam.face, .angle = angleBetween(face.corners[(corner + 1) % 3] - at, back)
        };
    }

    /// Whether ways along the x axis, from its ends, are shorter than all of a beam.
    [[nodiscard]] bool isHopeless(const Event& beam, const FaceLayout& face, double length) const {
        const Triangle& corners = surface_.faces()[beam.face];
        const double slack = kSlack * face.extent();
        // Squares save the roots.
        const auto isLonger = [&](double x, double than) {
            if (beam.fromLine) {
                return beam.normal.dot(Vec2(x, 0.0) - beam.source) > than;
            }
            than -= beam.before;
            return than < 0.0 || (Vec2(x, 0.0) - beam.source).squaredNorm() > than * than;
        };
        const double first = vertices_[corners[(beam.frame + 1) % 3]].distance + slack;
        const double last = vertices_[corners[(beam.frame + 2) % 3]].distance + slack;
        return isLonger(beam.to, first + beam.to) ||
               isLonger(beam.from, last + (length - beam.from));
    }

    /// The beam of an event.
    [[nodiscard]] static DistanceBeam beamOf(const Event& event) {
        DistanceBeam beam;
        beam.face = event.face;
        beam.frame = event.frame;
        beam.exits = static_cast<std::uint8_t>(7U & ~(1U << static_cast<unsigned>(event.frame)));
        beam.fromLine = event.fromLine;
        beam.side = event.side;
        beam.source = event.source;
        beam.normal = event.normal;
        beam.before = event.before;
        beam.leftOrigin = {event.from, 0.0};
        beam.rightOrigin = {event.to, 0.0};
        beam.left = event.fromLine ? event.normal : Vec2(beam.leftOrigin - event.source);
        beam.right = event.fromLine ? event.normal : Vec2(beam.rightOrigin - event.source);
        return beam;
    }

    void goOn(const DistanceBeam& beam, const FaceLayout& face) {
        keep(beam, face);
        leave(beam, face);
    }

    /// Hands a beam on to the faces across the sides that it may leave through.
    void leave(const DistanceBeam& beam, const FaceLayout& face) {
        for (int k = 0; k < 3; ++k) {
            const int across = surface_.faceNeighbours()[beam.face][k];
            if (((beam.exits >> static_cast<unsigned>(k)) & 1U) == 0 || across < 0) {
                continue;
            }
            // As the neighbour sees the side: from corner k + 2 to corner k + 1.
            const Vec2& first = face.corners[(k + 2) % 3];
            const Vec2& last = face.corners[(k + 1) % 3];
            Window window;
            clip(
                window,
                -cross(beam.left, first - beam.leftOrigin),
                -cross(beam.left, last - beam.leftOrigin)
            );
            clip(
                window,
                cross(beam.right, first - beam.rightOrigin),
                cross(beam.right, last - beam.rightOrigin)
            );
            if (window.from < window.to) {
                enter(beam, first, last, window, across);
            }
        }
    }

    void enter(
        const DistanceBeam& beam,
        const Vec2& first,
        const Vec2& last,
        const Window& window,
        int across
    ) {
        const double length = (last - first).norm();
        const Vec2 x = (last - first) / length;
        const Vec2 y = turnedLeft(x);
        const auto turned = [&](const Vec2& v) { return Vec2(v.dot(x), v.dot(y)); };
        Event next{
            .face = across,
            .frame = static_cast<std::uint8_t>(frameOf(across, beam, first)),
            .fromLine = beam.fromLine,
            .side = beam.side,
            .before = beam.before,
            .from = window.from * length,
            .to = window.to * length,
            .source = turned(beam.source - first),
            .normal = turned(beam.normal)
        };
        const DistanceBeam there = beamOf(next);
        const FaceLayout face = layout(there);
        if (isHopeless(next, face, length)) {
            return;
        }
        const double least =
            beam.fromLine
                ? std::min(there.distance(there.leftOrigin), there.distance(there.rightOrigin))
                : there.distance({std::clamp(next.source.x(), next.from, next.to), 0.0});
        if (least <= range_.to) {
            reachCorners(there, face, false);
            next.key = std::max(least, 0.0);
            next.apex = face.corners[there.frame];
            next.length = face.corners[(there.frame + 2) % 3].x();
            queue_.push(next);
        }
    }

    /// The side of a face that a beam comes through, which begins at `first`.
    [[nodiscard]] int frameOf(int face, const DistanceBeam& beam, const Vec2& first) const {
        const Triangle& neighbours = surface_.faceNeighbours()[face];
        int frame = 0;
        for (int k = 0; k < 3; ++k) {
            // Two faces may share two sides.
            if (neighbours[k] == beam.face && (std::ranges::count(neighbours, beam.face) == 1 ||
                                               sharesSide(face, k, beam, first))) {
                frame = k;
            }
        }
        return frame;
    }

    /// Whether side k of a face starts at the corner of the beam's face that lies at `first`.
    [[nodiscard]] bool sharesSide(
        int face, int k, const DistanceBeam& beam, const Vec2& first
    ) const {
        const FaceLayout from = layout(beam);
        const int corner =
            cornerOf(surface_.faces()[beam.face], surface_.faces()[face][(k + 1) % 3]);
        return corner >= 0 && from.corners[corner] == first;
    }

    const Surface& surface_;
    DistanceRange range_;
    std::vector<std::vector<DistanceBeam>>& beams_;
    std::vector<char>& isReached_;
    std::vector<SidedDistance>& vertices_;
    std::vector<VertexArrival> arrivals_;
    EventQueue queue_;
};

}  // namespace

bool DistanceBeam::contains(const Vec2& point, double tolerance) const {
    return cross(left, point - leftOrigin) <= tolerance * left.lpNorm<1>() &&
           cross(right, point - rightOrigin) >= -tolerance * right.lpNorm<1>();
}

DistanceBeams::DistanceBeams(
    const Surface& surface,
    std::span<const SurfacePolyline> lines,
    const DistanceRange& range,
    const Progress& progress
)
    : surface_(&surface),
      beams_(surface.faceCount()),
      isReached_(surface.faceCount(), 0),
      vertices_(surface.vertexCount()) {
    Propagation propagation(surface, range, beams_, isReached_, vertices_);
    for (const SurfacePolyline& line : lines) {
        propagation.start(beamsOfPolyline(surface, line));
    }
    propagation.run(progress);
}

SidedDistance DistanceBeams::inOneFace(const SurfacePoint& point) const {
    const Triangle& face = surface_->faces()[point.face];
    SidedDistance best;
    if (!beams_[point.face].empty()) {
        std::array<Vec2, 3> positions;
        double size = 0.0;
        for (int frame = 0; frame < 3; ++frame) {
            const FaceLayout layout(surface_->vertices(), face, frame);
            positions[frame] = layout.position(point.barycentric);
            size = layout.size();
        }
        for (const DistanceBeam& beam : beams_[point.face]) {
            const Vec2& q = positions[beam.frame];
            const double distance = beam.distance(q);
            if (distance < best.distance && distance >= -kSlack * size &&
                beam.contains(q, kSlack * size)) {
                best = {.distance = std::max(distance, 0.0), .side = beam.side};
            }
        }
    }
    // A vertex has one side, also where a line passes through it: beams from there know better.
    const Vec3 position = surface_->position(point);
    for (const int vertex : face) {
        const SidedDistance& corner = vertices_[vertex];
        const double distance = corner.distance + (position - surface_->vertices()[vertex]).norm();
        if (distance < (1.0 - kSlack) * best.distance) {
            best = {.distance = distance, .side = corner.side};
        }
    }
    return best;
}

double DistanceBeams::leastNear(const SurfacePoint& point, double radius) const {
    const Triangle& face = surface_->faces()[point.face];
    double least = std::numeric_limits<double>::infinity();
    if (!beams_[point.face].empty()) {
        std::array<Vec2, 3> positions;
        double reach = radius;
        for (int frame = 0; frame < 3; ++frame) {
            const FaceLayout layout(surface_->vertices(), face, frame);
            positions[frame] = layout.position(point.barycentric);
            reach = std::max(reach, radius + kSlack * layout.size());
        }
        for (const DistanceBeam& beam : beams_[point.face]) {
            const Vec2& q = positions[beam.frame];
            const double distance = beam.distance(q);
            if (distance - reach < least && distance >= -reach && beam.contains(q, reach)) {
                least = distance - reach;
            }
        }
    }
    const Vec3 position = surface_->position(point);
    for (const int vertex : face) {
        const double way = (position - surface_->vertices()[vertex]).norm() - radius;
        least = std::min(least, vertices_[vertex].distance + way);
    }
    return least;
}

SidedDistance DistanceBeams::at(const SurfacePoint& point) const {
    SidedDistance best;
    for (const int face : facesHolding(*surface_, point)) {
        const SidedDistance here = inOneFace(inFace(*surface_, point, face));
        if (here.distance < best.distance) {
            best = here;
        }
    }
    return best;
}

std::vector<int> DistanceBeams::reachedFaces() const {
    std::vector<int> faces;
    for (int f = 0; f < static_cast<int>(isReached_.size()); ++f) {
        if (isReached_[f] != 0) {
            faces.push_back(f);
        }
    }
    return faces;
}

}  // namespace bspline_curve
