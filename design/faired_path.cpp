// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/faired_path.h"

#include "design/fairing_energy.h"
#include "design/near_picks.h"
#include "design/node_spread.h"
#include "design/surface_walk.h"
#include "projection/curve_trace.h"
#include "spline/band_cholesky.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

struct FairingLevel {
    int segments;    // of the whole polyline, about
    int leastOfLeg;  // between two picks
    int mostSteps;
    double restShare;  // of the energy: no step is made that would gain less, by the last two
};

struct FairingConstants {
    /// Points are spread evenly anew once steps are short. With 45 at first the path leaves the
    /// surface at thin limbs. With 128 at last curves bend by 0.7 % less, and a pick that moves by
    /// little makes them jump more often.
    std::array<FairingLevel, 2> levels = {{{64, 3, 20, 3e-2}, {80, 6, 12, 1e-5}}};
    /// Of the Hessian's diagonal: the first and least, which hardly shortens a step, and the factor
    /// by which it grows where a step fails, and falls after one.
    double leastDamping = 1e-5, dampingFactor = 30.0;
    int mostTrials = 6;  // of a step, each damped more
    /// Paths that gain more than this share in a step go on, up to so many steps: they unfold.
    double unfoldingShare = 0.02;
    int mostUnfoldingSteps = 60;
    /// Of a point, in mean segments: farther away the derivatives say nothing of the surface.
    double longestStep = 1.5;
    /// A step is halved, so many times at most, where a point comes to lie farther from where it
    /// was sent, in mean segments, or a segment grows by more than this factor and share of a mean
    /// one: it has come to another part of the surface.
    int mostHalvings = 6;
    double farthest = 0.5, longestGrowth = 1.5, growthShare = 0.5;
    /// Cosine of the turn at a point beyond which a path is stuck in a cusp: from there no small
    /// step unfolds it.
    double cuspCosine = 0.0;
    /// Of a segment: what is farther from its target on it may have gone another way.
    double astray = 0.1;
    /// Of the length of the path: the radius of an arc that passes along the boundary at a pick.
    double radiusShare = 0.25;
    /// Cosine between the way of a point and the way out, above which it does not slide along.
    double straight = 0.5;
    /// Times the length of the path before, and no longer: far round, it bends hardly less.
    double longest = 1.5;
    /// Of the energy, by which the bounds of picks hold a path back: on each level one after the
    /// other. The last leaves a path a hundredth of the bound inside.
    std::array<std::array<double, 2>, 2> barrierShares = {{{0.1, 0.01}, {1e-3, 1e-4}}};
};

constexpr FairingConstants kFairing;

class FairingPolyline {
public:
    FairingPolyline(
        const ExtendedSurface& extended,
        const PatchLevels* patches,
        const PickPath& path,
        const SolverOptions& options,
        double clearance,
        std::span<const PickLeeway> leeways,
        const PathField& field
    )
        : extended_(extended),
          finder_(extended, patches),
          options_(options),
          clearance_(clearance),
          picks_(path.picks),
          lengthBefore_(path.path.length()),
          chord_(polygonLength(path.picks, options.closed)),
          term_(extended, options, field, chord_) {
        const std::vector<InitialPath::Point>& points = path.path.points;
        for (const InitialPath::Point& point : points) {
            Node node;
            node.foot = FootPoint::at(point.point);
            node.position = point.position;
            setNormal(node);
            now_.push_back(node);
        }
        if (options.closed) {
            now_.pop_back();
        }
        const std::size_t lastSegment = row().segmentCount() - 1;
        std::size_t node = 0;
        for (std::size_t pick = 0; pick < picks_.size(); ++pick) {
            while (points[node].parameter < picks_[pick].parameter) {
                ++node;
            }
            const bool isExact = leeways.empty() || leeways[pick].bound == 0.0;
            isExact_.push_back(isExact ? 1 : 0);
            const bool isAtNode = pick == 0 || (!options.closed && pick + 1 == picks_.size());
            if (isExact || isAtNode) {
                stops_.push_back({node, isExact ? static_cast<int>(pick) : -1});
            }
            if (!isExact) {
                const bool isPastEnd = node > lastSegment;
                near_.add(
                    {picks_[pick].position,
                     leeways[pick],
                     isPastEnd ? lastSegment : node,
                     isPastEnd ? 1.0 : 0.0,
                     isAtNode}
                );
                nearNumbers_.push_back(pick);
            }
        }
    }

    [[nodiscard]] bool hasLength() const { return chord_ > 0.0; }

    void comeToRest(std::size_t level) {
        const FairingLevel& at = kFairing.levels[level];
        placeEvenly(at, level == 0);
        if (near_.empty()) {
            relax(at);
            return;
        }
        for (const double share : kFairing.barrierShares[level]) {
            barrier_ = share * energy_.own;
            energy_ = term_.valueOf(now_, near_, barrier_);
            relax(at);
        }
    }

    /// Nothing where points lie on parts of the surface that no short way joins, or in a cusp.
    [[nodiscard]] std::optional<PickPath> result() const {
        PickPath faired;
        faired.picks.resize(picks_.size());
        double length = 0.0;
        auto stop = stops_.begin();
        for (std::size_t k = 0; k <= row().segmentCount(); ++k) {
            const Node& node = now_[k % size()];
            if (isBeyond(node) || isCusp(k % size())) {
                return std::nullopt;
            }
            if (k > 0) {
                const Node& last = now_[k - 1];
                if (!areJoined(extended_, finder_, last, node)) {
                    return std::nullopt;
                }
                length += (node.position - last.position).norm();
            }
            InitialPath::Point point{length, node.foot.surfacePoint(), node.position};
            if (k < size() && isFixed(k)) {
                while (stop->node != k) {
                    ++stop;
                }
                const PickConstraint& pick = picks_[stop->pick];
                point.point = pick.point;
                faired.picks[stop->pick] = pick;
                faired.picks[stop->pick].parameter = length;
            }
            faired.path.points.push_back(point);
        }
        if (options_.closed && isFixed(0)) {
            faired.path.points.back().point = faired.path.points.front().point;
        }
        passNearPicks(faired);
        faired.divideParameters(length, options_.closed);
        return faired;
    }

private:
    using Node = FairingNode;

    // The points of a path that are nearest to the picks beside it, in the order of the picks.
    void passNearPicks(PickPath& faired) const {
        const auto nearPicks = near_.picks();
        for (std::size_t i = 0; i < nearPicks.size(); ++i) {
            const auto& [position, leeway, segmentOf, share, isAtNode] = nearPicks[i];
            const InitialPath::Point& from = faired.path.points[segmentOf];
            const InitialPath::Point& to = faired.path.points[segmentOf + 1];
            const Node& node = now_[segmentOf];
            FootPoint foot = node.foot;
            FootFrame frame = node.frame;
            finder_.move(from.position + share * (to.position - from.position), foot, frame);
            PickConstraint& pick = faired.picks[nearNumbers_[i]];
            pick.parameter = std::lerp(from.parameter, to.parameter, share);
            if (foot.face >= extended_.surfaceFaceCount) {
                const InitialPath::Point& end = share > 0.5 ? to : from;
                pick = {end.point, end.position, end.parameter};
                continue;
            }
            pick.point = foot.surfacePoint();
            pick.position = extended_.position(pick.point);
        }
        // In order, where two lie the other way round along the path; exact ones stay.
        bool isLimit = false;
        for (std::size_t i = faired.picks.size() - 1; i > 0; --i) {
            isLimit = isLimit || isExact_[i] != 0;
            if (isLimit && faired.picks[i - 1].parameter > faired.picks[i].parameter) {
                faired.picks[i - 1] = faired.picks[i];
            } else {
                isLimit = false;
            }
        }
        for (std::size_t i = 1; i < faired.picks.size(); ++i) {
            if (faired.picks[i].parameter < faired.picks[i - 1].parameter) {
                faired.picks[i] = faired.picks[i - 1];
            }
        }
    }

    [[nodiscard]] BoundaryGuard guard() const { return {extended_, finder_}; }

    // Of a node. Beside a pick at the boundary it is none, since an arc passes along it there.
    [[nodiscard]] double clearanceOf(const Node& node) const {
        const double free = std::sqrt(kFairing.radiusShare * lengthBefore_ * 2.0 * clearance_);
        double share = 1.0;
        for (const Vec3& pick : picksAtBoundary_) {
            share = std::min(share, (node.position - pick).norm() / free - 1.0);
        }
        return std::max(0.0, share) * clearance_;
    }

    [[nodiscard]] bool isBeyond(const Node& node) const {
        return node.foot.face >= extended_.surfaceFaceCount;
    }

    // Of the nodes of the first polyline.
    void findPicksAtBoundary() {
        for (const auto& [node, pick] : stops_) {
            if (pick >= 0 && guard().isNear(now_[node], clearance_)) {
                picksAtBoundary_.push_back(picks_[pick].position);
            }
        }
    }

    [[nodiscard]] std::size_t size() const { return now_.size(); }

    [[nodiscard]] NodeRow row() const { return {size(), options_.closed}; }

    [[nodiscard]] bool isFixed(std::size_t i) const { return isFixed_[i] != 0; }

    [[nodiscard]] bool isCusp(std::size_t i) const {
        if (term_.hasTangent(i)) {
            return std::ranges::any_of(term_.halfTurnsAt(i, now_), [](const auto& half) {
                return std::abs(half.second.value) > 0.5 * std::numbers::pi;
            });
        }
        if (!row().hasTurn(i)) {
            return false;
        }
        const Vec3 in = row().segment(now_, row().before(i));
        const Vec3 out = row().segment(now_, i);
        return in.dot(out) < kFairing.cuspCosine * in.norm() * out.norm();
    }

    // That of the fibres where the faces around have none.
    void setNormal(Node& node) const {
        const Triangle& face = extended_.faces[node.foot.face];
        const Vec3& first = extended_.vertexNormal(face[0]);
        const Vec3 byU = extended_.vertexNormal(face[1]) - first;
        const Vec3 byV = extended_.vertexNormal(face[2]) - first;
        const Vec3 normal = first + node.foot.u * byU + node.foot.v * byV;
        const double length = normal.norm();
        const double perLength = length > 0.0 ? 1.0 / length : 0.0;
        node.normal = length > 0.0 ? Vec3(perLength * normal) : node.frame.direction;
        node.normalByU = perLength * byU;
        node.normalByV = perLength * byV;
    }

    // Puts a node that has been moved onto the surface.
    void settle(Node& node) const {
        if (isBeyond(node)) {
            node.position =
                extended_.position(onSurface(extended_, node.foot.face, node.foot.barycentric()));
            guard().putBack(node, clearanceOf(node));
        }
        node.foot.height = 0.0;
        node.position = extended_.position({node.foot.face, node.foot.barycentric()});
        setNormal(node);
    }

    // A node that has come from the start of a segment and is far from its target comes from the
    // segment's end, where that leads nearer.
    void comeFromNearer(
        const std::vector<Node>& polyline, double place, const Vec3& target, Node& node
    ) const {
        const auto start = static_cast<std::size_t>(place);
        const Node& end = polyline[(start + 1) % polyline.size()];
        const double missed = (node.position - target).norm();
        if (missed <= kFairing.astray * (end.position - polyline[start].position).norm()) {
            return;
        }
        Node other = end;
        finder_.move(target, other.foot, other.frame);
        settle(other);
        if ((other.position - target).norm() < missed) {
            node = other;
        }
    }

    // Gives near picks the segments of the new polyline at the same places.
    void placeNearPicks(const std::vector<double>& places) {
        for (NearPicks::Pick& pick : near_.picks()) {
            const double place = static_cast<double>(pick.segment) + pick.share;
            const auto above = std::ranges::upper_bound(places, place);
            const auto segment =
                static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, above - places.begin() - 1));
            const bool isPastEnd = segment >= row().segmentCount();
            pick.segment = isPastEnd ? row().segmentCount() - 1 : segment;
            pick.share = isPastEnd ? 1.0 : 0.0;
        }
        near_.follow(now_, options_.closed);
    }

    void placeEvenly(const FairingLevel& level, bool isFirst) {
        NodePlacement placement =
            spreadNodes(now_, options_.closed, stops_, picks_, level.segments, level.leastOfLeg);
        if (isFirst) {
            bendToTangents(placement, picks_);
        }
        const std::vector<Node> before = std::exchange(now_, std::move(placement.nodes));
        stops_ = std::move(placement.stops);
        isFixed_.assign(size(), 0);
        std::vector<Vec3> tangents(size(), Vec3::Zero());
        for (const auto& [node, pick] : stops_) {
            if (pick >= 0) {
                const SurfacePoint& point = picks_[pick].point;
                isFixed_[node] = 1;
                tangents[node] = picks_[pick].tangent;
                now_[node].foot = {point.face, point.barycentric[1], point.barycentric[2], 0.0};
            }
        }
        term_.setTangents(std::move(tangents));
        std::vector<FibreProjector::Move> moves;
        for (std::size_t i = 0; i < size(); ++i) {
            moves.push_back({placement.targets[i], &now_[i].foot, &now_[i].frame});
        }
        static_cast<void>(finder_.moveAll(moves));
        for (std::size_t i = 0; i < size(); ++i) {
            settle(now_[i]);
            comeFromNearer(before, placement.places[i], placement.targets[i], now_[i]);
        }
        for (const auto& [node, pick] : stops_) {
            if (pick >= 0) {
                now_[node].position = picks_[pick].position;
            }
        }
        if (isFirst) {
            findPicksAtBoundary();
        }
        placeNearPicks(placement.places);
        trial_ = now_;
        energy_ = term_.valueOf(now_, near_, barrier_);
        const auto isFree = [](const Vec3& tangent) { return tangent.isZero(0.0); };
        if (isFirst && !std::ranges::all_of(term_.tangents(), isFree)) {
            lengthBefore_ = std::max(lengthBefore_, energy_.length);  // it has been bent to them
        }
    }

    // Newton's step with the diagonal damped; nothing where the Hessian is not positive.
    [[nodiscard]] std::optional<Eigen::VectorXd> stepWith(double damping) const {
        BandCholesky<1> factor(static_cast<int>(size()), 2, options_.closed ? 2 : 0);
        factor.clear();
        const auto add = [&](std::size_t i, std::size_t j, double value) {
            const auto [low, high] = std::minmax(i, j);
            if (!isHeld(i) && !isHeld(j)) {
                factor.add(static_cast<int>(high), static_cast<int>(low), &value, 1);
            }
        };
        Eigen::VectorXd right = -term_.gradient();
        for (std::size_t i = 0; i < size(); ++i) {
            if (isHeld(i)) {
                const double one = 1.0;
                factor.add(static_cast<int>(i), static_cast<int>(i), &one, 1);
                right[static_cast<Eigen::Index>(i)] = 0.0;
                continue;
            }
            const auto& [diagonal, first, second] = term_.rows()[i];
            add(i, i, (1.0 + damping) * diagonal);
            add(i, row().after(i), first);
            add(i, row().after(row().after(i)), second);
        }
        return factor.factorise() ? std::optional(factor.solve(std::move(right))) : std::nullopt;
    }

    void relax(const FairingLevel& level) {
        double damping = kFairing.leastDamping;
        double gain = 1.0;
        for (int step = 0; step < level.mostSteps ||
                           (gain > kFairing.unfoldingShare && step < kFairing.mostUnfoldingSteps);
             ++step) {
            const double before = std::exchange(gain, descend(damping));
            if (gain * std::min(1.0, gain / before) <= level.restShare) {
                break;
            }
        }
    }

    // Settles a node that has moved. Whether it came too near to the boundary, or nearer than it
    // was, and was put back.
    [[nodiscard]] bool stopAtBoundary(const Node& from, Node& to) const {
        const bool isOut = isBeyond(to);
        settle(to);
        if (!guard().isBeside(to.foot.face)) {
            return isOut;
        }
        const double clearance = std::min(clearanceOf(to), guard().distanceOf(from));
        if (guard().distanceOf(to) >= clearance || guard().inwardsAt(to, clearance).isZero(0.0)) {
            return isOut;
        }
        guard().putBack(to, clearance);
        settle(to);
        return true;
    }

    // Nodes at the boundary stay where the step would take them straight over it.
    void holdAtBoundary() {
        isHeld_ = isFixed_;
        for (std::size_t i = 0; i < size(); ++i) {
            if (!isFixed(i) && guard().isBeside(now_[i].foot.face)) {
                const Vec3& across = term_.ways()[i].across;
                const double inwards = across.dot(guard().inwardsAt(now_[i], clearanceOf(now_[i])));
                const bool isStraight = std::abs(inwards) > kFairing.straight * across.norm();
                isHeld_[i] = static_cast<char>(
                    isStraight && term_.gradient()[static_cast<Eigen::Index>(i)] * inwards > 0.0
                );
            }
        }
    }

    [[nodiscard]] bool isHeld(std::size_t i) const { return isHeld_[i] != 0; }

    // One step; returns the share of the energy that it gains.
    double descend(double& damping) {
        term_.differentiate(now_, isFixed_, energy_, near_, barrier_);
        holdAtBoundary();
        const double mean = energy_.length / static_cast<double>(row().segmentCount());
        for (int trial = 0; trial < kFairing.mostTrials; ++trial) {
            if (std::optional<Eigen::VectorXd> step = stepWith(damping)) {
                const double longest = step->lpNorm<Eigen::Infinity>();
                *step *= std::min(1.0, kFairing.longestStep * mean / longest);
                for (int i = 0; !tryStep(*step, mean) && i < kFairing.mostHalvings; ++i) {
                    *step *= 0.5;
                }
                NearPicks near = near_;
                near.follow(trial_, options_.closed);
                const PathEnergy after = term_.valueOf(trial_, near, barrier_);
                if (isTrialNear_ && after.total < energy_.total &&
                    after.length <= kFairing.longest * lengthBefore_) {
                    const double gain = (energy_.total - after.total) / energy_.total;
                    std::swap(now_, trial_);
                    near_ = std::move(near);
                    energy_ = after;
                    damping = std::max(kFairing.leastDamping, damping / kFairing.dampingFactor);
                    return gain;
                }
            }
            damping *= kFairing.dampingFactor;
        }
        return 0.0;
    }

    // Whether all points of the trial came to lie where they were sent.
    bool tryStep(const Eigen::VectorXd& step, double mean) {
        trial_ = now_;
        targets_.resize(size());
        std::vector<FibreProjector::Move> moves;
        for (std::size_t i = 0; i < size(); ++i) {
            if (!isHeld(i)) {
                const NodeWay& way = term_.ways()[i];
                const double share = step[static_cast<Eigen::Index>(i)];
                trial_[i].foot.u += share * way.u;
                trial_[i].foot.v += share * way.v;
                targets_[i] = now_[i].position + share * way.across;
                if (!finder_.stayInFace(trial_[i].foot, trial_[i].frame)) {
                    moves.push_back({targets_[i], &trial_[i].foot, &trial_[i].frame});
                }
            }
        }
        static_cast<void>(finder_.moveAll(moves));
        isTrialNear_ = true;
        for (std::size_t i = 0; i < size(); ++i) {
            if (!isHeld(i)) {
                const bool isStopped = stopAtBoundary(now_[i], trial_[i]);
                const double missed = (trial_[i].position - targets_[i]).norm();
                isTrialNear_ = isTrialNear_ && (isStopped || missed <= kFairing.farthest * mean);
            }
        }
        for (std::size_t i = 0; i < row().segmentCount(); ++i) {
            const double longest = kFairing.longestGrowth * row().segment(now_, i).norm() +
                                   kFairing.growthShare * mean;
            isTrialNear_ = isTrialNear_ && row().segment(trial_, i).norm() <= longest;
        }
        return isTrialNear_;
    }

    const ExtendedSurface& extended_;
    FibreProjector finder_;
    const SolverOptions& options_;
    double clearance_;                   // from the boundary
    std::vector<Vec3> picksAtBoundary_;  // no farther from it than that
    const std::vector<PickConstraint>& picks_;
    double lengthBefore_;  // of the path, before it is faired
    double chord_;         // length of the polygon of picks
    std::vector<Node> now_, trial_;
    std::vector<Vec3> targets_;  // of the nodes of the trial
    bool isTrialNear_ = false;
    std::vector<NodeStop> stops_;
    NearPicks near_;
    std::vector<char> isExact_;             // by pick
    std::vector<std::size_t> nearNumbers_;  // of each of these, its index among the picks
    double barrier_ = 0.0;                  // strength, see NearPicks
    std::vector<char> isFixed_;             // by node: it is a pick
    std::vector<char> isHeld_;              // by node: likewise, or at the boundary in this step
    FairingEnergy term_;
    PathEnergy energy_;
};

}  // namespace

std::optional<PickPath> fairedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const PickPath& path,
    const SolverOptions& options,
    double clearance,
    std::span<const PickLeeway> leeways,
    const PathField& field
) {
    FairingPolyline polyline(extended, patches, path, options, clearance, leeways, field);
    if (!polyline.hasLength()) {
        return std::nullopt;
    }
    polyline.comeToRest(0);
    // Around thin parts of the surface new points may come to lie elsewhere.
    const FairingPolyline coarse = polyline;
    polyline.comeToRest(1);
    std::optional<PickPath> fine = polyline.result();
    return fine ? std::move(fine) : coarse.result();
}

}  // namespace bspline_curve
