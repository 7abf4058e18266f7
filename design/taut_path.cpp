// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/taut_path.h"

#include "solver/foot_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace bspline_curve {
namespace {

using Matrix2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;
using Tangents = Eigen::Matrix<double, 3, 2>;

// Of a string. With 24 and 48 of them 72 random curves on three scans cost and bend as much within
// 3 %; paths with 48 take up to 40 % more.
constexpr int kSegments = 32;
constexpr int kMaxSteps = 16;
// Under a field more steps gain less than they take: the curve itself follows it better.
constexpr int kMaxFieldSteps = 6;
// The string is at rest where a step changes the energy by no more than this share of it, or on
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
        const ShellBase& base, const FieldTravel& field, std::span<const SurfacePoint> path
    ) {
        for (const SurfacePoint& point : path) {
            positions.push_back(base.position(point));
            if (costs.empty()) {
                costs.push_back(0.0);
                continue;
            }
            const double leg = (positions.back() - *(positions.end() - 2)).norm();
            const double cost = field.empty() ? 1.0 : field.costOf(base.faces[point.face]);
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

// A string of points on the surface. Its energy is half the sum of the squared lengths of its
// segments, each times the mean of the squared costs at its ends: least where the string runs along
// the cheapest path and its points lie evenly by cost.
class String {
public:
    String(
        const ShellBase& base,
        const PatchLevels* patches,
        const FieldTravel& field,
        std::span<const SurfacePoint> path
    )
        : base_(base), field_(field), finder_(base, patches) {
        const MeasuredPath measured(base, field, path);
        pathLength_ = measured.length;
        chord_ = (measured.positions.back() - measured.positions.front()).norm();
        now_.assign(kSegments + 1, {});
        std::array<FootFinder::Move, kSegments + 1> moves;
        for (int i = 0; i <= kSegments; ++i) {
            const double share = static_cast<double>(i) / kSegments;
            const SurfacePoint& near = i == kSegments ? path.back() : path[measured.indexAt(share)];
            Bead& bead = now_[i];
            bead.foot = {near.face, near.barycentric[1], near.barycentric[2], 0.0};
            moves[i] = {
                i == kSegments ? measured.positions.back() : measured.positionAt(share),
                &bead.foot,
                &bead.frame
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
    [[nodiscard]] std::optional<TautString> asFound(std::span<const SurfacePoint> path) const {
        double length = 0.0;
        TautString result{{path.front()}, {}};
        for (int i = 1; i <= kSegments; ++i) {
            const Bead& bead = now_[i];
            length += (bead.position - now_[i - 1].position).norm();
            if (bead.foot.face >= base_.surfaceFaceCount) {
                return std::nullopt;
            }
            if (!isJoined(now_[i - 1], bead)) {
                result.gaps.push_back(result.points.size() - 1);
            }
            const Vec3 barycentric = bead.foot.barycentric().cwiseMax(0.0);
            result.points.push_back({bead.foot.face, barycentric / barycentric.sum()});
        }
        result.points.back() = path.back();
        if (field_.empty() && length > kLongest * pathLength_) {
            return std::nullopt;
        }
        return result;
    }

private:
    struct Bead {
        FootPoint foot;
        FootFrame frame;
        Vec3 position = Vec3::Zero();
        double cost = 1.0;
    };

    [[nodiscard]] double costAt(int vertex) const {
        return field_.costAt(base_.surfaceVertex(vertex));
    }

    // Puts beads on the surface, at the feet of points.
    void place(std::span<const FootFinder::Move> moves, std::span<Bead> beads) const {
        finder_.moveAll(moves);
        std::ranges::for_each(beads, [this](Bead& bead) { settle(bead); });
    }

    void settle(Bead& bead) const {
        bead.foot.height = 0.0;
        bead.position = base_.position({bead.foot.face, bead.foot.barycentric()});
        if (!field_.empty()) {
            const Triangle& face = base_.faces[bead.foot.face];
            const Vec3 costs(costAt(face[0]), costAt(face[1]), costAt(face[2]));
            bead.cost = costs.dot(bead.foot.barycentric());
        }
    }

    // Whether a walk over the surface leads from one bead to the next, over sharp edges by short
    // steps. None leads over a right angle where fibres turn in less than a step; and a string may
    // have slipped off the rim of a thin plate, and then it passes through it.
    [[nodiscard]] bool isJoined(const Bead& from, const Bead& to) const {
        return arrives(from, to, 1) || arrives(from, to, kShortSteps);
    }

    [[nodiscard]] bool arrives(const Bead& from, const Bead& to, int steps) const {
        Bead walker = from;
        const Vec3 way = to.position - from.position;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            finder_.move(from.position + share * way, walker.foot, walker.frame);
        }
        const Vec3 reached = base_.position({walker.foot.face, walker.foot.barycentric()});
        return (reached - to.position).norm() <= kSameShare * way.norm() &&
               walker.frame.direction.dot(to.frame.direction) > 0.0;
    }

    [[nodiscard]] Vec3 costGradient(const Bead& bead) const {
        if (field_.empty()) {
            return Vec3::Zero();
        }
        const Triangle& face = base_.faces[bead.foot.face];
        const double corner = costAt(face[0]);
        return (costAt(face[1]) - corner) * bead.frame.u +
               (costAt(face[2]) - corner) * bead.frame.v;
    }

    [[nodiscard]] static double stiffness(const Bead& a, const Bead& b) {
        return 0.5 * (a.cost * a.cost + b.cost * b.cost);
    }

    [[nodiscard]] static double energy(const std::vector<Bead>& beads) {
        double sum = 0.0;
        for (std::size_t i = 1; i < beads.size(); ++i) {
            sum += 0.5 * stiffness(beads[i - 1], beads[i]) *
                   (beads[i].position - beads[i - 1].position).squaredNorm();
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

    // Newton's step, by elimination from the first bead to the last; false where the Hessian is not
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
            const Bead& bead = now_[i];
            const Bead& last = now_[i - 1];
            const Bead& next = now_[i + 1];
            Row& row = rows_[i];
            row.tangents = tangentsAt(bead.frame.direction);
            const double before = stiffness(last, bead);
            const double after = stiffness(bead, next);
            const Vec3 in = bead.position - last.position;
            const Vec3 out = next.position - bead.position;
            const Vec3 pull = after * out - before * in;
            const Vec2 slope = row.tangents.transpose() * costGradient(bead);
            const double share = 0.5 * (in.squaredNorm() + out.squaredNorm());
            row.force = row.tangents.transpose() * pull - bead.cost * share * slope;
            Matrix2 block =
                (before + after) * Matrix2::Identity() + share * slope * slope.transpose() +
                turningShare * pull.dot(bead.frame.direction) * bendingAt(bead.frame, row.tangents);
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
        std::array<FootFinder::Move, kSegments - 1> moves;
        for (int i = 1; i < kSegments; ++i) {
            const Row& row = rows_[i];
            Bead& bead = trial_[i] = now_[i];
            const Vec3 way = length * (row.tangents * row.solved);
            FootFinder::predict(way, bead.frame, bead.foot);
            moves[i - 1] = {bead.position + way, &bead.foot, &bead.frame};
        }
        place(moves, std::span(trial_).subspan(1, moves.size()));
    }

    // Moves as far as the energy falls, and returns whether the string is at rest. Without a field
    // the energy may rise by a little: the condition that the string pulls along the directions has
    // no kinks, so whole steps meet it to rounding, unlike the energy on flat faces.
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
        Matrix2 coupling, inverse;  // coupling: with the bead before
        Vec2 force, solved;
    };

    const ShellBase& base_;
    const FieldTravel& field_;
    FootFinder finder_;
    double pathLength_ = 0.0;
    double chord_ = 0.0;
    double decrement_ = 0.0;
    double firstLength_ = 1.0;  // of the next step, as a share of it
    std::vector<Bead> now_, trial_;
    std::array<Row, kSegments> rows_;
};

}  // namespace

std::optional<TautString> pullTaut(
    const ShellBase& base,
    const PatchLevels* patches,
    const FieldTravel& field,
    std::span<const SurfacePoint> path
) {
    String string(base, patches, field, path);
    return string.comesToRest() ? string.asFound(path) : std::nullopt;
}

}  // namespace bspline_curve
