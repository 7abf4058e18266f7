// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/shadow_fairing.h"

#include "spline/band_cholesky.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using Vec2 = Eigen::Vector2d;

// Crossings are held where they are as if by springs that give way to kinks over fewer mean edges
// than this. Over 2 and more, they go to the bounds of the tolerance.
constexpr double kReach = 1.0;
// The share of the spline's own bending that is straightened with the kinks, up to so many times
// the kinks nearby, of which there are none where the surface is plane. Without it polylines
// bent 1.13 times as much as splines, with it 1.06 times.
constexpr double kStraightened = 0.5;
constexpr double kStraightenedKinks = 2.0;
// Crossings nearer to each other than so many mean edges move together: beside a vertex the kinks
// between them are those of a zigzag that nobody sees.
constexpr double kTogether = 0.02;
constexpr double kLargestGroup = 4.0;  // times as much, where faces are small
// Kinks of shorter pieces, in mean edges, weigh no more than theirs, and move by no less.
constexpr double kShortest = 0.05;
constexpr double kLeastStep = 1e-4;
// A crossing keeps this share of its edge from the ends, or what it has.
constexpr double kFromEnds = 1e-3;
// A curve that runs along an edge is not moved by its crossing: the sine between them.
constexpr double kLeastSine = 0.05;
// The share of the distance tolerance that may be used, since heights are known at a few places.
constexpr double kUsable = 0.98;
// The share of the way to the next pick that parameters keep from each other.
constexpr double kLeastAdvance = 1e-6;
// Where the spline advances by less than this share of the way between two crossings, as in a
// zigzag beside a vertex, directions between them say nothing about the curve. Over a ledge in the
// surface it advances by a third.
constexpr double kLeastPace = 0.2;
// The largest value of s (1 - s)^2.
constexpr double kCubicBulge = 4.0 / 27.0;
// Moves beyond their bounds by more than this share of these are drawn back, by springs that become
// so many times as strong, in so many rounds at most.
constexpr double kOverrun = 0.02;
constexpr double kStronger = 10.0;
constexpr int kMaxRounds = 8;
// What makes curvature of linear directions vanish: 2 (s - 1/2)' z' + (s - 1/2) z'' = 3 z'' (s -
// 1/2).
constexpr double kTwist = 1.0 / 3.0;

// A crossing or a pick.
struct Node {
    double parameter = 0.0;
    SurfacePoint point{-1, Vec3::Zero()};
    bool isCrossing = false;
    bool isFree = false;  // to move along its edge
    SplinePoint spline;
    Vec3 position = Vec3::Zero();
    std::array<Vec3, 3> normals{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // of the face's corners
    Vec3 normal = Vec3::Zero();
    Vec3 sideways = Vec3::Zero();  // unit
    // Of the edge: its corners in the face of the point, and its vector.
    int start = 0, end = 0;
    Vec3 edge = Vec3::Zero();
    double height = 0.0;   // of the spline over it
    double moved = 0.0;    // by how far along the edge
    double perMove = 0.0;  // share of the edge that is one unit sideways
    Vec3 before = Vec3::Zero(), after = Vec3::Zero();  // derivatives by the parameter

    [[nodiscard]] Vec3 move() const { return perMove * edge; }

    [[nodiscard]] double speed() const { return spline.derivative.norm(); }
};

// What moves together: nodes from first to last.
struct Group {
    int first, last;
    int unknown = -1;
    double low = -std::numeric_limits<double>::infinity();  // bounds of the move
    double high = std::numeric_limits<double>::infinity();
};

class CurveFairing {
public:
    CurveFairing(const CurveProblem& problem, const ProjectedCurve& shadow)
        : problem_(problem),
          shadow_(shadow),
          extended_(*problem.extended),
          closed_(problem.options.closed),
          edgeLength_(problem.averageEdgeLength) {}

    std::optional<FairedParts> run() {
        collectNodes();
        makePieces();
        groupNodes();
        boundGroups();
        const double before = sumOfKinks();
        if (move()) {
            groupNodes();
            followSpline();
            makePieces();
            if (!(sumOfKinks() <= before)) {
                return std::nullopt;
            }
        }
        straightenKinks();
        if (!isNear()) {
            return std::nullopt;
        }
        FairedParts parts;
        for (const Node& node : nodes_) {
            if (node.isCrossing) {
                parts.crossings.push_back({node.parameter, node.point});
            }
        }
        parts.pieces = std::move(pieces_);
        return parts;
    }

private:
    // ---- Crossings and picks ----

    void collectNodes() {
        const std::vector<EdgeCrossing>& crossings = shadow_.crossings();
        nodes_.reserve(crossings.size() + problem_.picks.size() + 1);
        auto next = crossings.begin();
        for (const PickConstraint& pick : problem_.picks) {
            for (; next != crossings.end() && next->parameter < pick.parameter; ++next) {
                addNode(next->parameter, next->point, true);
            }
            addNode(pick.parameter, pick.point, false);
        }
        for (; next != crossings.end(); ++next) {
            addNode(next->parameter, next->point, true);
        }
        if (closed_) {
            addNode(1.0, problem_.picks.front().point, false);
        }
        faces_.reserve(nodes_.size());
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
            const int face = shadow_.faceAt(0.5 * (nodes_[i].parameter + nodes_[i + 1].parameter));
            faces_.push_back(face < extended_.surfaceFaceCount ? face : -1);
        }
        for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
            nodes_[i].isFree = nodes_[i].isFree && faces_[i - 1] >= 0 && faces_[i] >= 0;
        }
    }

    void addNode(double parameter, const SurfacePoint& point, bool isCrossing) {
        Node node;
        node.parameter = parameter;
        node.point = point;
        node.isCrossing = isCrossing;
        node.spline = shadow_.splineAt(parameter);
        const Triangle& face = extended_.faces[point.face];
        int zeros = 0;
        for (int k = 0; k < 3; ++k) {
            if (point.barycentric[k] <= kOnEdgeBarycentric) {
                ++zeros;
                node.start = (k + 1) % 3;
                node.end = (k + 2) % 3;
            } else {
                node.normals[k] = extended_.vertexNormal(face[k]);
            }
        }
        place(node);
        node.height = (node.spline.position - node.position).norm();
        node.sideways = node.normal.cross(node.spline.derivative).normalized();
        if (isCrossing && zeros == 1) {
            node.edge = extended_.vertices[face[node.end]] - extended_.vertices[face[node.start]];
            const double across = node.edge.dot(node.sideways);
            node.isFree = std::abs(across) >= kLeastSine * node.edge.norm();
            node.perMove = node.isFree ? 1.0 / across : 0.0;
        }
        nodes_.push_back(node);
    }

    void place(Node& node) const {
        const Triangle& face = extended_.faces[node.point.face];
        node.position = node.normal = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            node.position += node.point.barycentric[k] * extended_.vertices[face[k]];
            node.normal += node.point.barycentric[k] * node.normals[k];
        }
    }

    // ---- Pieces between them ----

    void makePieces() {
        pieces_.clear();
        pieces_.reserve(faces_.size());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            addPiece(faces_[i], nodes_[i], nodes_[i + 1]);
        }
        if (closed_) {
            nodes_.front().before = nodes_.back().before;
            nodes_.back().after = nodes_.front().after;
        }
    }

    // Sets the derivatives at its ends.
    void addPiece(int face, Node& a, Node& b) {
        FairedPiece& piece = pieces_.emplace_back();
        piece.from = a.parameter;
        piece.to = b.parameter;
        a.after = a.spline.derivative;
        b.before = b.spline.derivative;
        const double length = piece.to - piece.from;
        if (face < 0) {
            return;
        }
        piece.face = face;
        piece.shifts = {coordinatesIn(face, a.point), coordinatesIn(face, b.point)};
        if (length <= 0.0) {
            return;
        }
        const Triangle& corners = extended_.faces[face];
        const Vec3 edgeU = extended_.vertices[corners[1]] - extended_.vertices[corners[0]];
        const Vec3 edgeV = extended_.vertices[corners[2]] - extended_.vertices[corners[0]];
        const Vec3 area = edgeU.cross(edgeV);
        const Vec3 direction = 0.5 * (a.normal + b.normal);
        const double determinant = direction.dot(area);
        if (!(determinant > 0.0)) {
            return;  // normals that face away from the face: straight
        }
        piece.u = edgeV.cross(direction) / determinant;
        piece.v = direction.cross(edgeU) / determinant;
        piece.z = area / determinant;
        piece.twist = kTwist * piece.uvOf(b.normal - a.normal);
        piece.heights = {piece.z.dot(a.spline.position), piece.z.dot(b.spline.position)};
        piece.shifts[0] -= piece.uvOf(a.spline.position);
        piece.shifts[1] -= piece.uvOf(b.spline.position);
        if (length * a.spline.derivative.norm() < kLeastPace * (b.position - a.position).norm()) {
            return;
        }
        const Vec2 shift = (piece.shifts[1] - piece.shifts[0]) / length;
        const double slope = (piece.heights[1] - piece.heights[0]) / length;
        const auto derivativeAt = [&](const Node& node, double middleToNode) -> Vec3 {
            const double rise = piece.z.dot(node.spline.derivative) - slope;
            const Vec2 uv =
                piece.uvOf(node.spline.derivative) + shift - middleToNode * rise * piece.twist;
            return uv[0] * edgeU + uv[1] * edgeV;
        };
        a.after = derivativeAt(a, -0.5);
        b.before = derivativeAt(b, 0.5);
    }

    [[nodiscard]] Vec2 coordinatesIn(int face, const SurfacePoint& point) const {
        Vec2 uv = Vec2::Zero();
        for (int k = 0; k < 3; ++k) {
            const int corner = cornerOf(extended_.faces[face], extended_.faces[point.face][k]);
            if (corner > 0) {
                uv[corner - 1] = point.barycentric[k];
            }
        }
        return uv;
    }

    // ---- Moving crossings ----

    void groupNodes() {
        groups_.clear();
        const double together = kTogether * edgeLength_;
        const int count = static_cast<int>(nodes_.size());
        const auto distance = [&](int i, int j) {
            return (nodes_[i].position - nodes_[j].position).norm();
        };
        for (int i = 0; i < count; ++i) {
            if (i == 0 || distance(i - 1, i) > together ||
                distance(groups_.back().first, i) > kLargestGroup * together) {
                groups_.push_back({i, i});
            }
            groups_.back().last = i;
        }
    }

    void boundGroups() {
        for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
            heights_.push_back(heightAmid(i));
        }
        for (Group& group : groups_) {
            bool isFree = true;
            for (int i = group.first; i <= group.last; ++i) {
                isFree = isFree && nodes_[i].isFree && bound(group, i);
            }
            if (isFree) {
                group.unknown = unknowns_++;
            }
        }
    }

    // Keeps the move of a node on its edge, and within the distance tolerance beside it. False
    // where it is beyond that.
    bool bound(Group& group, int i) const {
        const Node& node = nodes_[i];
        const double s = node.point.barycentric[node.end];
        const double fromEnds = std::min({kFromEnds, s, 1.0 - s});
        const double down = (fromEnds - s) / node.perMove;
        const double up = (1.0 - fromEnds - s) / node.perMove;
        group.low = std::max(group.low, std::min(down, up));
        group.high = std::min(group.high, std::max(down, up));
        const double usable = kUsable * problem_.distanceTolerance;
        const double height = std::max({node.height, heights_[i - 1], heights_[i]});
        if (!(height < usable)) {
            return false;
        }
        const double room = std::sqrt(usable * usable - height * height);
        group.low = std::max(group.low, -room);
        group.high = std::min(group.high, room);
        return true;
    }

    // Of the spline over the face of a piece, half way; infinite where the piece is straight, so
    // that nothing moves beside it.
    [[nodiscard]] double heightAmid(int i) const {
        const FairedPiece& piece = pieces_[i];
        if (piece.face < 0) {
            return 0.0;
        }
        if (piece.z.isZero(0.0)) {
            return std::numeric_limits<double>::infinity();
        }
        const Vec3 p = shadow_.splineAt(0.5 * (piece.from + piece.to)).position;
        return std::abs(piece.z.dot(p - extended_.vertices[extended_.faces[piece.face].front()]));
    }

    // A kink and how it depends on the moves of three groups.
    struct Kink {
        double angle, bend, weight, length;
        int terms = 0;
        std::array<int, 3> unknowns{};
        std::array<double, 3> derivatives{};

        void add(int unknown, double derivative) {
            if (unknown >= 0) {
                unknowns[terms] = unknown;
                derivatives[terms] = derivative;
                ++terms;
            }
        }
    };

    // What the derivative changes by sideways over the nodes of a group, beyond that of the spline.
    [[nodiscard]] double kinkOf(const Group& group) const {
        const Node& in = nodes_[group.first];
        const Node& out = nodes_[group.last];
        return out.sideways.dot(
            (out.after - out.spline.derivative) - (in.before - in.spline.derivative)
        );
    }

    // Of the nodes of a group, the derivative before it and that after it. `g`: not the first or
    // last of an open curve, nor the last of a closed one.
    [[nodiscard]] Kink kinkAt(std::size_t g) const {
        const Group& group = groups_[g];
        const Group& lastGroup = g > 0 ? groups_[g - 1] : groups_[groups_.size() - 2];
        const Group& nextGroup = groups_[g + 1];
        const Node& in = nodes_[group.first];
        const Node& out = nodes_[group.last];
        const Node& last = nodes_[lastGroup.last];
        const Node& next = nodes_[nextGroup.first];
        const double speed = out.speed();
        const double since = in.parameter - last.parameter + (g > 0 ? 0.0 : 1.0);
        const double lengthIn = std::max(speed * since, kLeastStep * edgeLength_);
        const double lengthOut =
            std::max(speed * (next.parameter - out.parameter), kLeastStep * edgeLength_);
        const Vec3& sideways = out.sideways;
        Kink kink{};
        kink.length = 0.5 * (lengthIn + lengthOut);
        kink.weight = edgeLength_ / std::max(kink.length, kShortest * edgeLength_);
        kink.angle = kinkOf(group) / speed;
        kink.bend = kStraightened * kink.length *
                    sideways.dot(shadow_.secondDerivativeAt(out.parameter)) / (speed * speed);
        kink.add(lastGroup.unknown, sideways.dot(last.move()) / lengthIn);
        kink.add(
            group.unknown,
            -sideways.dot(in.move()) / lengthIn - sideways.dot(out.move()) / lengthOut
        );
        kink.add(nextGroup.unknown, sideways.dot(next.move()) / lengthOut);
        return kink;
    }

    // Moves all crossings that may. False where none does.
    bool move() {
        if (unknowns_ == 0 || groups_.size() < 3) {
            return false;
        }
        // The first pick of a closed curve couples the last unknown with the first.
        constexpr int kCoupled = 2;
        BandCholesky<1> system(
            unknowns_,
            std::min(kCoupled, unknowns_ - 1),
            closed_ && unknowns_ > kCoupled + 1 ? 1 : 0
        );
        system.clear();
        Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns_);
        const double perLength = 1.0 / (kReach * kReach * edgeLength_ * edgeLength_);
        std::vector<Kink> kinks;
        kinks.reserve(groups_.size());
        const std::size_t firstGroup = closed_ ? 0 : 1;
        for (std::size_t g = firstGroup; g + 1 < groups_.size(); ++g) {
            kinks.push_back(kinkAt(g));
        }
        for (std::size_t k = 0; k < kinks.size(); ++k) {
            const Kink& kink = kinks[k];
            const std::size_t g = firstGroup + k;
            const double around = (std::abs(kinks[k > 0 ? k - 1 : k].angle) + std::abs(kink.angle) +
                                   std::abs(kinks[std::min(k + 1, kinks.size() - 1)].angle)) /
                                  3.0;
            const double most = kStraightenedKinks * around;
            const double angle = kink.angle + std::clamp(kink.bend, -most, most);
            for (int i = 0; i < kink.terms; ++i) {
                const double weighted = kink.weight * kink.derivatives[i];
                right[kink.unknowns[i]] -= weighted * angle;
                for (int j = 0; j <= i; ++j) {
                    const double value = weighted * kink.derivatives[j];
                    system.add(
                        std::max(kink.unknowns[i], kink.unknowns[j]),
                        std::min(kink.unknowns[i], kink.unknowns[j]),
                        &value,
                        1
                    );
                }
            }
            if (const int own = groups_[g].unknown; own >= 0) {
                const double share = kink.length * perLength;
                const double value = kink.weight * share * share;
                system.add(own, own, &value, 1);
            }
        }
        const std::optional<Eigen::VectorXd> moves = solveWithin(system, right);
        if (!moves) {
            return false;
        }
        for (const Group& group : groups_) {
            if (group.unknown >= 0) {
                apply(group, std::clamp((*moves)[group.unknown], group.low, group.high));
            }
        }
        return true;
    }

    // Moves that are nearly within their bounds.
    [[nodiscard]] std::optional<Eigen::VectorXd> solveWithin(
        const BandCholesky<1>& system, const Eigen::VectorXd& right
    ) const {
        const double first = 1.0 / (kReach * kReach * edgeLength_ * edgeLength_);
        std::vector<double> springs(unknowns_, 0.0);
        std::vector<double> ends(unknowns_, 0.0);
        for (int round = 0;; ++round) {
            BandCholesky<1> sprung = system;
            Eigen::VectorXd pulled = right;
            for (int i = 0; i < unknowns_; ++i) {
                sprung.add(i, i, &springs[i], 1);
                pulled[i] += springs[i] * ends[i];
            }
            if (!sprung.factorise()) {
                return std::nullopt;
            }
            Eigen::VectorXd moves = sprung.solve(std::move(pulled));
            bool isWithin = true;
            for (const Group& group : groups_) {
                const int i = group.unknown;
                const double margin = kOverrun * (group.high - group.low);
                if (i < 0 || (moves[i] >= group.low - margin && moves[i] <= group.high + margin)) {
                    continue;
                }
                springs[i] = springs[i] > 0.0 ? kStronger * springs[i] : first;
                ends[i] = moves[i] < group.low ? group.low : group.high;
                isWithin = false;
            }
            if (isWithin || round == kMaxRounds) {
                return moves;
            }
        }
    }

    void apply(const Group& group, double move) {
        for (int i = group.first; i <= group.last; ++i) {
            Node& node = nodes_[i];
            const double s = node.point.barycentric[node.end] + move * node.perMove;
            node.point.barycentric[node.end] = s;
            node.point.barycentric[node.start] = 1.0 - s;
            node.moved = std::abs(move * node.perMove) * node.edge.norm();
            place(node);
        }
    }

    // Gives crossings that moved the parameters at which the spline is nearest to them.
    void followSpline() {
        std::vector<double> limits(nodes_.size(), 1.0);  // of the next node that stays
        for (std::size_t i = nodes_.size() - 1; i-- > 0;) {
            limits[i] = nodes_[i + 1].isFree ? limits[i + 1] : nodes_[i + 1].parameter;
        }
        for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
            Node& node = nodes_[i];
            if (!node.isFree) {
                continue;
            }
            const Vec3& along = node.spline.derivative;
            const double step =
                (node.position - node.spline.position).dot(along) / along.squaredNorm();
            const double before = nodes_[i - 1].parameter;
            const double margin = kLeastAdvance * (limits[i] - before);
            node.parameter = std::clamp(node.parameter + step, before + margin, limits[i] - margin);
            node.spline = shadow_.splineAt(node.parameter);
            node.sideways = node.normal.cross(node.spline.derivative).normalized();
        }
    }

    // ---- Bending pieces ----

    // Makes what is left of kinks bending of the pieces beside them, most of the longer one.
    void straightenKinks() {
        const int lastNode = static_cast<int>(nodes_.size()) - 1;
        for (std::size_t g = closed_ ? 0 : 1; g + 1 < groups_.size(); ++g) {
            const int in = g > 0 ? groups_[g].first : lastNode;
            const int out = groups_[g].last;
            FairedPiece& before = pieces_[in - 1];
            FairedPiece& after = pieces_[out];
            if (before.face < 0 || after.face < 0) {
                continue;
            }
            const Vec3& sideways = nodes_[out].sideways;
            const double kink = kinkOf(groups_[g]);
            const double lengthIn = before.to - before.from;
            const double lengthOut = after.to - after.from;
            const double all = lengthIn + lengthOut;
            before.slopes[1] = kink * lengthIn * lengthIn / all * before.uvOf(sideways);
            after.slopes[0] = -kink * lengthOut * lengthOut / all * after.uvOf(sideways);
        }
    }

    [[nodiscard]] double sumOfKinks() const {
        double sum = 0.0;
        for (std::size_t g = closed_ ? 0 : 1; g + 1 < groups_.size(); ++g) {
            const double kink = kinkOf(groups_[g]) / nodes_[groups_[g].last].speed();
            sum += kink * kink;
        }
        return sum;
    }

    // Bends pieces no farther from the spline than the distance tolerance. False where one is
    // farther all the same, and the shadow is not.
    [[nodiscard]] bool isNear() {
        const double usable = kUsable * problem_.distanceTolerance;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            FairedPiece& piece = pieces_[i];
            if (piece.face < 0) {
                continue;
            }
            const Triangle& corners = extended_.faces[piece.face];
            const Vec3& corner = extended_.vertices[corners[0]];
            const Vec3 edgeU = extended_.vertices[corners[1]] - corner;
            const Vec3 edgeV = extended_.vertices[corners[2]] - corner;
            // Most pieces need no look.
            const Vec2 slopes = piece.slopes[0].cwiseAbs() + piece.slopes[1].cwiseAbs();
            const double aside =
                std::max(nodes_[i].moved, nodes_[i + 1].moved) +
                kCubicBulge * (slopes[0] * edgeU.norm() + slopes[1] * edgeV.norm());
            const double height = std::max({nodes_[i].height, nodes_[i + 1].height, heights_[i]});
            if (height * height + aside * aside < usable * usable) {
                continue;
            }
            FairedPiece straight = piece;
            straight.slopes = {Vec2::Zero(), Vec2::Zero()};
            double share = 1.0;
            for (const double s : {1.0 / 3.0, 2.0 / 3.0}) {
                const double t = std::lerp(piece.from, piece.to, s);
                const Vec3 p = shadow_.splineAt(t).position;
                const auto distanceOf = [&](const FairedPiece& way) {
                    const Vec2 uv = way.uvAt(s, p);
                    return (corner + uv[0] * edgeU + uv[1] * edgeV - p).norm();
                };
                const double bent = distanceOf(piece);
                if (!(bent > usable)) {
                    continue;
                }
                const double least = distanceOf(straight);
                if (least < usable) {
                    share = std::min(share, (usable - least) / (bent - least));
                } else if (least > problem_.distanceTolerance &&
                           (extended_.position(shadow_.at(t)) - p).norm() <=
                               problem_.distanceTolerance) {
                    return false;
                } else {
                    share = 0.0;
                }
            }
            piece.slopes = {share * piece.slopes[0], share * piece.slopes[1]};
        }
        return true;
    }

    const CurveProblem& problem_;
    const ProjectedCurve& shadow_;
    const ExtendedSurface& extended_;
    bool closed_;
    double edgeLength_;
    std::vector<Node> nodes_;
    std::vector<int> faces_;           // after each node but the last; -1: beyond the boundary
    std::vector<FairedPiece> pieces_;  // likewise
    std::vector<double> heights_;      // of the spline amid each piece before crossings move
    std::vector<Group> groups_;
    int unknowns_ = 0;
};

}  // namespace

std::optional<FairedParts> fairedParts(const CurveProblem& problem, const ProjectedCurve& shadow) {
    return CurveFairing(problem, shadow).run();
}

}  // namespace bspline_curve
