// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/shortened_path.h"

#include "projection/fibre_projector.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace bspline_curve {
namespace {

using Matrix2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;
using Tangents = Eigen::Matrix<double, 3, 2>;

// Of a polyline. With 24 and 48 of them 72 random curves on three scans cost and bend as much
// within 3 %; paths with 48 take up to 40 % more.
constexpr int kSegments = 32;
constexpr int kMaxSteps = 16;
// Under a field more steps gain less than they take: the curve itself follows it better.
constexpr int kMaxFieldSteps = 6;
// The polyline is at rest where a step changes the energy by no more than this share of it, or on
// rough surfaces, where steps do not get any better, by this after a few.
constexpr double kRest = 1e-8;
constexpr double kSettledShare = 1e-4;
constexpr int kManySteps = 4;
constexpr double kRiseShare = 1e-4;
constexpr int kMaxAttempts = 6;
// Under a field whole steps go too far nearly always, so the next one is tried by so many times the
// length of the last at first.
constexpr double kStretch = 1.5;
constexpr double kLeastShortening = 0.1;
constexpr double kMostShortening = 0.5;
// Shares of the surface's bending that are tried in turn until the Hessian is positive.
constexpr std::array<double, 3> kTurningShares = {1.0, 0.5, 0.0};
// Points nearer than this share of their segment are one.
constexpr double kSameShare = 0.3;
constexpr int kShortSteps = 8;
// No path becomes longer by more.
constexpr double kLongest = 1.001;

// Points of a path by their share of what it costs.
struct MeasuredPath {
    std::vector<Vec3> positions;
    std::vector<double> costs;
    double length = 0.0;

    MeasuredPath(
        const ExtendedSurface& extended,
        const FieldTravel& field,
        std::span<const SurfacePoint> path
    ) {
        for (const SurfacePoint& point : path) {
            positions.push_back(extended.position(point));
            if (costs.empty()) {
                costs.push_back(0.0);
                continue;
            }
            const double leg = (positions.back() - *(positions.end() - 2)).norm();
            const double cost = field.empty() ? 1.0 : field.costOf(extended.faces[point.face]);
            length += leg;
            costs.push_back(costs.back() + leg * cost);
        }
    }

    // The last point before a share of the cost, but for the last of all.
    [[nodiscard]] std::size_t indexAt(double share) const {
        const auto above = std::ranges::upper_bound(costs, share * costs.back());
        const auto index = static_cast<std::size_t>(above - costs.begin());
        return std::clamp<std::size_t>(index, 1, costs.size() - 1) - 1;
    }

    [[nodiscard]] Vec3 positionAt(double share) const {
        const std::size_t i = indexAt(share);
        const double gap = costs[i + 1] - costs[i];
        const double s = gap > 0.0 ? (share * costs.back() - costs[i]) / gap : 0.0;
        return (1.0 - s) * positions[i] + s * positions[i + 1];
    }
};

// A polyline of points on the surface. Its energy is half the sum of the squared lengths of its
// segments, each times the mean of the squared costs at its ends: least where the polyline runs
// along the cheapest path and its points lie evenly by cost.
class GeodesicPolyline {
public:
    GeodesicPolyline(
        const ExtendedSurface& extended,
        const PatchLevels* patches,
        const FieldTravel& field,
        std::span<const SurfacePoint> path
    )
        : extended_(extended), field_(field), finder_(extended, patches) {
        const MeasuredPath measured(extended, field, path);
        pathLength_ = measured.length;
        chord_ = (measured.positions.back() - measured.positions.front()).norm();
        now_.assign(kSegments + 1, {});
        std::array<FibreProjector::Move, kSegments + 1> moves;
        for (int i = 0; i <= kSegments; ++i) {
            const double share = static_cast<double>(i) / kSegments;
            const SurfacePoint& near = i == kSegments ? path.back() : path[measured.indexAt(share)];
            Node& node = now_[i];
            node.foot = {near.face, near.barycentric[1], near.barycentric[2], 0.0};
            moves[i] = {
                i == kSegments ? measured.positions.back() : measured.positionAt(share),
                &node.foot,
                &node.frame
            };
        }
        place(moves, now_);
        now_.front().position = measured.positions.front();
        now_.back().position = measured.positions.back();
        trial_ = now_;
    }

    [[nodiscard]] bool comesToRest() {
        if (!(chord_ > 0.0)) {
            return false;
        }
        for (int step = 0; step < (field_.empty() ? kMaxSteps : kMaxFieldSteps); ++step) {
            if (!solve()) {
                return false;
            }
            if (move(step)) {
                break;
            }
        }
        return true;
    }

    // Its ends are those of the path. Nothing where a point is beyond a boundary.
    [[nodiscard]] std::optional<ShortenedPath> asFound(std::span<const SurfacePoint> path) const {
        double length = 0.0;
        ShortenedPath result{{path.front()}, {}};
        for (int i = 1; i <= kSegments; ++i) {
            const Node& node = now_[i];
            length += (node.position - now_[i - 1].position).norm();
            if (node.foot.face >= extended_.surfaceFaceCount) {
                return std::nullopt;
            }
            if (!isJoined(now_[i - 1], node)) {
                result.gaps.push_back(result.points.size() - 1);
            }
            const Vec3 barycentric = node.foot.barycentric().cwiseMax(0.0);
            result.points.push_back({node.foot.face, barycentric / barycentric.sum()});
        }
        result.points.back() = path.back();
        if (field_.empty() && length > kLongest * pathLength_) {
            return std::nullopt;
        }
        return result;
    }

private:
    struct Node {
        FootPoint foot;
        FootFrame frame;
        Vec3 position = Vec3::Zero();
        double cost = 1.0;
    };

    [[nodiscard]] double costAt(int vertex) const {
        return field_.costAt(extended_.surfaceVertex(vertex));
    }

    // Puts nodes on the surface, at the feet of points.
    void place(std::span<const FibreProjector::Move> moves, std::span<Node> nodes) const {
        finder_.moveAll(moves);
        std::ranges::for_each(nodes, [this](Node& node) { settle(node); });
    }

    void settle(Node& node) const {
        node.foot.height = 0.0;
        node.position = extended_.position({node.foot.face, node.foot.barycentric()});
        if (!field_.empty()) {
            const Triangle& face = extended_.faces[node.foot.face];
            const Vec3 costs(costAt(face[0]), costAt(face[1]), costAt(face[2]));
            node.cost = costs.dot(node.foot.barycentric());
        }
    }

    // Whether a walk over the surface leads from one node to the next, over sharp edges by short
    // steps. None leads over a right angle where fibres turn in less than a step; and a polyline
    // may have slipped off the rim of a thin plate, and then it passes through it.
    [[nodiscard]] bool isJoined(const Node& from, const Node& to) const {
        return arrives(from, to, 1) || arrives(from, to, kShortSteps);
    }

    [[nodiscard]] bool arrives(const Node& from, const Node& to, int steps) const {
        Node walker = from;
        const Vec3 way = to.position - from.position;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            finder_.move(from.position + share * way, walker.foot, walker.frame);
        }
        const Vec3 reached = extended_.position({walker.foot.face, walker.foot.barycentric()});
        return (reached - to.position).norm() <= kSameShare * way.norm() &&
               walker.frame.direction.dot(to.frame.direction) > 0.0;
    }

    [[nodiscard]] Vec3 costGradient(const Node& node) const {
        if (field_.empty()) {
            return Vec3::Zero();
        }
        const Triangle& face = extended_.faces[node.foot.face];
        const double corner = costAt(face[0]);
        return (costAt(face[1]) - corner) * node.frame.u +
               (costAt(face[2]) - corner) * node.frame.v;
    }

    [[nodiscard]] static double stiffness(const Node& a, const Node& b) {
        return 0.5 * (a.cost * a.cost + b.cost * b.cost);
    }

    [[nodiscard]] static double energy(const std::vector<Node>& nodes) {
        double sum = 0.0;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            sum += 0.5 * stiffness(nodes[i - 1], nodes[i]) *
                   (nodes[i].position - nodes[i - 1].position).squaredNorm();
        }
        return sum;
    }

    static Tangents tangentsAt(const Vec3& direction) {
        Tangents tangents;
        tangents.col(0) = direction.unitOrthogonal();
        tangents.col(1) = direction.cross(tangents.col(0));
        return tangents;
    }

    // The second fundamental form: how the direction turns along the surface.
    static Matrix2 bendingAt(const FootFrame& frame, const Tangents& tangents) {
        const Tangents turning = frame.turnU * (frame.u.transpose() * tangents) +
                                 frame.turnV * (frame.v.transpose() * tangents);
        const Matrix2 form = tangents.transpose() * turning;
        return 0.5 * (form + form.transpose());
    }

    // Newton's step, by elimination from the first node to the last; false where the Hessian is not
    // positive.
    [[nodiscard]] bool solve() {
        return std::ranges::any_of(kTurningShares, [this](double share) {
            return eliminate(share);
        });
    }

    [[nodiscard]] bool eliminate(double turningShare) {
        decrement_ = 0.0;
        Tangents tangentsBefore = Tangents::Zero();
        Matrix2 inverseBefore = Matrix2::Zero();
        Vec2 solvedBefore = Vec2::Zero();
        for (int i = 1; i < kSegments; ++i) {
            const Node& node = now_[i];
            const Node& last = now_[i - 1];
            const Node& next = now_[i + 1];
            Row& row = rows_[i];
            row.tangents = tangentsAt(node.frame.direction);
            const double before = stiffness(last, node);
            const double after = stiffness(node, next);
            const Vec3 in = node.position - last.position;
            const Vec3 out = next.position - node.position;
            const Vec3 pull = after * out - before * in;
            const Vec2 slope = row.tangents.transpose() * costGradient(node);
            const double share = 0.5 * (in.squaredNorm() + out.squaredNorm());
            row.force = row.tangents.transpose() * pull - node.cost * share * slope;
            Matrix2 block =
                (before + after) * Matrix2::Identity() + share * slope * slope.transpose() +
                turningShare * pull.dot(node.frame.direction) * bendingAt(node.frame, row.tangents);
            Vec2 right = row.force;
            row.coupling = -before * tangentsBefore.transpose() * row.tangents;
            if (i > 1) {
                block -= row.coupling.transpose() * inverseBefore * row.coupling;
                right -= row.coupling.transpose() * solvedBefore;
            }
            const double determinant = block.determinant();
            if (block(0, 0) <= 0.0 || !(determinant > kLeastDeterminant * block.squaredNorm())) {
                return false;
            }
            row.inverse = block.inverse();
            row.solved = row.inverse * right;
            tangentsBefore = row.tangents;
            inverseBefore = row.inverse;
            solvedBefore = row.solved;
        }
        for (int i = kSegments - 1; i > 0; --i) {
            Row& row = rows_[i];
            if (i + 1 < kSegments) {
                const Row& next = rows_[i + 1];
                row.solved -= row.inverse * (next.coupling * next.solved);
            }
            decrement_ += 0.5 * row.force.dot(row.solved);
        }
        return true;
    }

    void placeTrial(double length) {
        std::array<FibreProjector::Move, kSegments - 1> moves;
        for (int i = 1; i < kSegments; ++i) {
            const Row& row = rows_[i];
            Node& node = trial_[i] = now_[i];
            const Vec3 way = length * (row.tangents * row.solved);
            FibreProjector::predict(way, node.frame, node.foot);
            moves[i - 1] = {node.position + way, &node.foot, &node.frame};
        }
        place(moves, std::span(trial_).subspan(1, moves.size()));
    }

    // Moves as far as the energy falls, and returns whether the polyline is at rest. Without a
    // field the energy may rise by a little: the condition that the polyline pulls along the
    // directions has no kinks, so whole steps meet it to rounding, unlike the energy on flat faces.
    [[nodiscard]] bool move(int step) {
        const double before = energy(now_);
        if (!field_.empty() && decrement_ <= kSettledShare * before) {
            return true;
        }
        const double highest = field_.empty() ? (1.0 + kRiseShare) * before : before;
        double length = firstLength_;
        for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
            placeTrial(length);
            const double after = energy(trial_);
            if (after < highest) {
                firstLength_ = field_.empty() ? 1.0 : std::min(1.0, kStretch * length);
                std::swap(now_, trial_);
                const double change = std::abs(before - after) / before;
                return change <= kRest || (step >= kManySteps && change <= kSettledShare);
            }
            // To the bottom of the parabola through both energies and the slope at first.
            const double fall = 2.0 * decrement_ * length;
            const double bottom = 0.5 * fall / (after - before + fall);
            length *= std::clamp(bottom, kLeastShortening, kMostShortening);
        }
        return true;
    }

    static constexpr double kLeastDeterminant = 1e-9;

    struct Row {
        Tangents tangents;
        Matrix2 coupling, inverse;  // coupling: with the node before
        Vec2 force, solved;
    };

    const ExtendedSurface& extended_;
    const FieldTravel& field_;
    FibreProjector finder_;
    double pathLength_ = 0.0;
    double chord_ = 0.0;
    double decrement_ = 0.0;
    double firstLength_ = 1.0;  // of the next step, as a share of it
    std::vector<Node> now_, trial_;
    std::array<Row, kSegments> rows_;
};

}  // namespace

std::optional<ShortenedPath> shortenPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const FieldTravel& field,
    std::span<const SurfacePoint> path
) {
    GeodesicPolyline string(extended, patches, field, path);
    return string.comesToRest() ? string.asFound(path) : std::nullopt;
}

}  // namespace bspline_curve
