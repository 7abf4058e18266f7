// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/shortened_path.h"

#include "design/surface_walk.h"
#include "projection/fibre_projector.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace bspline_curve {
namespace {

using Matrix2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;
using Tangents = Eigen::Matrix<double, 3, 2>;

struct ShorteningConstants {
    int segments = 32;             // of the polyline; curves from 24 or 48 bend as much
    int maxSteps = 16;             // of Newton's method
    int maxFieldSteps = 6;         // likewise under a field, which the curve follows better itself
    double restShare = 1e-8;       // of the energy: a step that changes less is the last one
    double settledShare = 1e-4;    // likewise after `manySteps`: no step helps on rough surfaces
    int manySteps = 4;             // steps
    double riseShare = 1e-4;       // of the energy, by which it may rise without a field
    int maxAttempts = 6;           // at one step, each shorter
    double stretch = 1.5;          // of the last step under a field: whole ones go too far there
    double leastShortening = 0.1;  // of a step that went too far, ...
    double mostShortening = 0.5;   // ... as shares of it
    double leastDeterminant = 1e-9;  // of a block, in squared norms: below it is singular
    double longest = 1.001;          // times the path's length: nothing becomes longer than that
};

constexpr ShorteningConstants kShortening;
constexpr int kSegments = kShortening.segments;
// Shares of the surface's bending that are tried in turn until the Hessian is positive.
constexpr std::array<double, 3> kTurningShares = {1.0, 0.5, 0.0};

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
        std::vector<Vec3> positions;
        std::vector<double> costs = {0.0};
        for (const SurfacePoint& point : path) {
            positions.push_back(extended.position(point));
            if (positions.size() > 1) {
                const double leg = (positions.back() - *(positions.end() - 2)).norm();
                pathLength_ += leg;
                costs.push_back(costs.back() + leg * costOver(point.face));
            }
        }
        chord_ = (positions.back() - positions.front()).norm();
        placeEvenly(path, positions, costs);
        now_.front().position = positions.front();
        now_.back().position = positions.back();
        trial_ = now_;
    }

    [[nodiscard]] bool comesToRest() {
        const int steps = field_.empty() ? kShortening.maxSteps : kShortening.maxFieldSteps;
        bool canGoOn = chord_ > 0.0;
        for (int step = 0; canGoOn && step < steps; ++step) {
            canGoOn = solve();
            if (canGoOn && move(step)) {
                break;
            }
        }
        return canGoOn;
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
            if (!areJoined(extended_, finder_, now_[i - 1], node)) {
                result.gaps.push_back(result.points.size() - 1);
            }
            result.points.push_back(node.foot.surfacePoint());
        }
        result.points.back() = path.back();
        if (field_.empty() && length > kShortening.longest * pathLength_) {
            return std::nullopt;
        }
        return result;
    }

private:
    struct Node : SurfaceNode {
        double cost = 1.0;
    };

    [[nodiscard]] double costOver(int face) const {
        return field_.empty() ? 1.0 : field_.costOf(extended_.faces[face]);
    }

    // Puts the nodes at equal shares of the costs, each near the last point of the path before it.
    void placeEvenly(
        std::span<const SurfacePoint> path,
        const std::vector<Vec3>& positions,
        const std::vector<double>& costs
    ) {
        std::array<FibreProjector::Move, kSegments + 1> moves;
        for (int i = 0; i <= kSegments; ++i) {
            const double cost = static_cast<double>(i) / kSegments * costs.back();
            const auto above = std::ranges::upper_bound(costs, cost) - costs.begin();
            const auto k = std::clamp<std::ptrdiff_t>(above, 1, std::ssize(costs) - 1) - 1;
            const double gap = costs[k + 1] - costs[k];
            const double s = gap > 0.0 ? (cost - costs[k]) / gap : 0.0;
            const bool isLast = i == kSegments;
            const SurfacePoint& near = isLast ? path.back() : path[k];
            now_[i].foot = FootPoint::at(near);
            moves[i] = {
                isLast ? positions.back() : (1.0 - s) * positions[k] + s * positions[k + 1],
                &now_[i].foot,
                &now_[i].frame
            };
        }
        place(moves, now_);
    }

    [[nodiscard]] double costAt(int vertex) const {
        return field_.costAt(extended_.surfaceVertex(vertex));
    }

    // Puts nodes on the surface, at the feet of points.
    void place(std::span<const FibreProjector::Move> moves, std::span<Node> nodes) const {
        static_cast<void>(finder_.moveAll(moves));
        for (Node& node : nodes) {
            node.foot.height = 0.0;
            node.position = positionOf(node);
            if (!field_.empty()) {
                const Triangle& face = extended_.faces[node.foot.face];
                const Vec3 costs(costAt(face[0]), costAt(face[1]), costAt(face[2]));
                node.cost = costs.dot(node.foot.barycentric());
            }
        }
    }

    [[nodiscard]] Vec3 positionOf(const Node& node) const {
        return extended_.position({node.foot.face, node.foot.barycentric()});
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
        for (int i = 1; i < kSegments; ++i) {
            const Node& node = now_[i];
            const Node& last = now_[i - 1];
            const Node& next = now_[i + 1];
            const Row& rowBefore = rows_[i - 1];
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
            row.coupling = -before * rowBefore.tangents.transpose() * row.tangents;
            Matrix2 block =
                (before + after) * Matrix2::Identity() + share * slope * slope.transpose() +
                turningShare * pull.dot(node.frame.direction) * bendingAt(node.frame, row.tangents);
            block -= row.coupling.transpose() * rowBefore.inverse * row.coupling;
            const double least = kShortening.leastDeterminant * block.squaredNorm();
            if (block(0, 0) <= 0.0 || !(block.determinant() > least)) {
                return false;
            }
            row.inverse = block.inverse();
            row.solved = row.inverse * (row.force - row.coupling.transpose() * rowBefore.solved);
        }
        decrement_ = 0.0;
        for (int i = kSegments - 1; i > 0; --i) {
            const Row& next = rows_[i + 1];
            rows_[i].solved -= rows_[i].inverse * (next.coupling * next.solved);
            decrement_ += 0.5 * rows_[i].force.dot(rows_[i].solved);
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
        if (!field_.empty() && decrement_ <= kShortening.settledShare * before) {
            return true;
        }
        const double highest = field_.empty() ? (1.0 + kShortening.riseShare) * before : before;
        double length = firstLength_;
        for (int attempt = 0; attempt < kShortening.maxAttempts; ++attempt) {
            placeTrial(length);
            const double after = energy(trial_);
            if (after < highest) {
                firstLength_ = field_.empty() ? 1.0 : std::min(1.0, kShortening.stretch * length);
                std::swap(now_, trial_);
                const double change = std::abs(before - after) / before;
                return change <= kShortening.restShare ||
                       (step >= kShortening.manySteps && change <= kShortening.settledShare);
            }
            // To the bottom of the parabola through both energies and the slope at first.
            const double fall = 2.0 * decrement_ * length;
            const double bottom = 0.5 * fall / (after - before + fall);
            length *= std::clamp(bottom, kShortening.leastShortening, kShortening.mostShortening);
        }
        return true;
    }

    // Of a node; the first and the last, which stay, have zeros.
    struct Row {
        Tangents tangents = Tangents::Zero();
        Matrix2 coupling = Matrix2::Zero(),
                inverse = Matrix2::Zero();  // coupling: with the node before
        Vec2 force = Vec2::Zero(), solved = Vec2::Zero();
    };

    const ExtendedSurface& extended_;
    const FieldTravel& field_;
    FibreProjector finder_;
    double pathLength_ = 0.0;
    double chord_ = 0.0;
    double decrement_ = 0.0;
    double firstLength_ = 1.0;  // of the next step, as a share of it
    std::vector<Node> now_ = std::vector<Node>(kSegments + 1), trial_;
    std::array<Row, kSegments + 1> rows_;
};

}  // namespace

std::optional<ShortenedPath> shortenPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const FieldTravel& field,
    std::span<const SurfacePoint> path
) {
    GeodesicPolyline polyline(extended, patches, field, path);
    return polyline.comesToRest() ? polyline.asFound(path) : std::nullopt;
}

}  // namespace bspline_curve
