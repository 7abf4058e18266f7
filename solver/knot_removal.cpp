// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/knot_removal.h"

#include "solver/spline_fit.h"
#include "spline/constrained_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>

namespace bspline_curve {
namespace {

struct RemovalConstants {
    /// Of squared second derivatives in the fit, relative to squared distances, in units of a mean
    /// span to the fourth. With a tenth of it the noise of positions keeps a tenth more knots.
    double secondsWeight = 0.1;
    /// A fit misses the picks by less, in the unit frame; by more where too few control points are
    /// left for them.
    double pickAccuracy = 1e-9;
    /// Of the bending that may still be added one knot may take this share, and a batch that one:
    /// with more, what is taken first leaves nothing for the others.
    double shareOfKnot = 0.25, shareOfBatch = 0.5;
    /// What a knot adds is felt on so many spans to either side: fits decay by half and more from
    /// span to span. With 6 as many knots are left.
    int reach = 4;
    /// After so many trials in turn that failed all knots that are left are taken as needed: on
    /// curves with thousands of knots hundreds of trials would bring little.
    int patience = 16;
};

constexpr RemovalConstants kRemoval;

// The squared geodesic curvature times the speed, of turn = n . (P' x P'').
double bendOf(double turn, double squaredSpeed) {
    return turn * turn / (squaredSpeed * squaredSpeed * std::sqrt(squaredSpeed));
}

// Calls `act` with the number of basis functions on a span, as a constant: loops over them are
// most of the work.
template <typename Act>
void withBasisCount(const SplineSpace& space, const Act& act) {
    static_assert(kMaxBasis == 5);
    switch (space.basisCount()) {
        case 3:
            act(std::integral_constant<int, 3>{});
            break;
        case 4:
            act(std::integral_constant<int, 4>{});
            break;
        default:
            act(std::integral_constant<int, 5>{});
    }
}

}  // namespace

KnotRemoval::KnotRemoval(
    const SplineCurve& curve,
    const std::vector<PickConstraint>& picks,
    std::vector<SeenSample> samples,
    const RemovalLimits& limits
)
    : curve_(curve),
      picks_(picks),
      samples_(std::move(samples)),
      limits_(limits),
      isLocked_(curve.space.breaks().size(), 0),
      kept_(curve.space.breaks().size()) {
    isLocked_.front() = isLocked_.back() = 1;
    std::iota(kept_.begin(), kept_.end(), 0);
    for (const double from : curve.space.breaks()) {
        const auto first = std::ranges::lower_bound(samples_, from, {}, &SeenSample::parameter);
        firstSamples_.push_back(static_cast<int>(first - samples_.begin()));
    }
    firstSamples_.back() = static_cast<int>(samples_.size());
}

SplineCurve KnotRemoval::run() {
    std::optional<Fit> fit = fitOn(kept_, nullptr);
    if (!fit) {
        return curve_;
    }
    mostBending_ = fit->bending + limits_.bendingShare * (fit->bending + limits_.bendingFloor);
    std::vector<Candidate> batch = nextBatch(*fit);
    int failures = 0;
    while (!batch.empty() && failures < kRemoval.patience) {
        std::vector<int> rest;
        std::size_t next = 0;
        std::vector<char> isOut(fit->kept.size(), 0);
        for (const Candidate& candidate : batch) {
            isOut[candidate.index] = 1;
        }
        for (const int atBreak : fit->kept) {
            if (isOut[next++] == 0) {
                rest.push_back(atBreak);
            }
        }
        std::optional<Fit> trial = fitOn(std::move(rest), &*fit);
        if (trial && isWithin(*trial)) {
            fit = std::move(trial);
            batch = nextBatch(*fit);
            failures = 0;
        } else {
            shorten(trial ? &*trial : nullptr, batch);
            ++failures;
            if (batch.empty()) {
                batch = nextBatch(*fit);
            }
        }
    }
    kept_ = fit->kept;
    return curveOf(*fit);
}

SplineCurve KnotRemoval::withKnotsBack(const std::vector<char>& spans) {
    std::vector<int> kept;
    for (std::size_t span = 0; span + 1 < kept_.size(); ++span) {
        kept.push_back(kept_[span]);
        for (int i = kept_[span] + 1; spans[span] != 0 && i < kept_[span + 1]; ++i) {
            kept.push_back(i);
        }
    }
    kept.push_back(kept_.back());
    kept_ = std::move(kept);
    const std::optional<Fit> fit = fitOn(kept_, nullptr);
    return fit ? curveOf(*fit) : curve_;
}

SplineCurve KnotRemoval::curveOf(const Fit& fit) const {
    SplineCurve result{fit.space, fit.controls};
    PickConstraints(result.space, interpolationRows(result.space, picks_)).meet(result.controls);
    return result;
}

// Nothing where no spline on these breaks passes the picks. `like`: a fit that has some of its
// spans, or null.
std::optional<KnotRemoval::Fit> KnotRemoval::fitOn(std::vector<int> kept, const Fit* like) const {
    const SplineSpace& before = curve_.space;
    std::vector<double> breaks;
    breaks.reserve(kept.size());
    for (const int index : kept) {
        breaks.push_back(before.breaks()[index]);
    }
    SplineSpace space(before.degree(), before.closed(), std::move(breaks));
    BandCholesky<1> factor = bandCholeskyOf<1>(space);
    Fit fit{std::move(kept), std::move(space), std::move(factor), {}, {}, {}, {}, {}, {}, {}};
    const PickConstraints picks(fit.space, interpolationRows(fit.space, picks_));
    ControlPoints right = ControlPoints::Zero(fit.space.controlCount(), 3);
    sumSamples(fit, like);
    addSums(fit, right);
    addProducts(fit.factor, fit.space, picks, kFitConstraintWeight);
    if (!fit.factor.factorise()) {
        return std::nullopt;
    }
    if (fit.kept.size() == before.breaks().size()) {
        fit.controls = curve_.controls;
    } else {
        fit.controls = constrainedFit(fit.factor, picks, right, kFitConstraintWeight);
    }
    if (!(picks.residual(fit.controls).lpNorm<Eigen::Infinity>() < kRemoval.pickAccuracy)) {
        return std::nullopt;
    }
    withBasisCount(fit.space, [&](auto count) { measure<count()>(fit); });
    return fit;
}

// The samples of a span, from the first to behind the last.
std::pair<int, int> KnotRemoval::samplesOf(const Fit& fit, int span) const {
    return {firstSamples_[fit.kept[span]], firstSamples_[fit.kept[span + 1]]};
}

// Rows and sums; of spans that `like` has as well, with the same basis functions, its own.
void KnotRemoval::sumSamples(Fit& fit, const Fit* like) const {
    fit.rows.resize(samples_.size());
    fit.sums.resize(fit.space.spanCount());
    int other = 0;
    for (int span = 0; span < fit.space.spanCount(); ++span) {
        while (like != nullptr && like->kept[other] < fit.kept[span]) {
            ++other;
        }
        if (like == nullptr || like->kept[other + 1] != fit.kept[span + 1] ||
            like->space.basis(other) != fit.space.basis(span)) {
            withBasisCount(fit.space, [&](auto count) { sumSpan<count()>(fit, span); });
            continue;
        }
        fit.sums[span] = like->sums[other];
        const auto [begin, end] = samplesOf(fit, span);
        std::copy(like->rows.begin() + begin, like->rows.begin() + end, fit.rows.begin() + begin);
    }
}

template <int kBasis>
void KnotRemoval::sumSpan(Fit& fit, int span) const {
    const SplineSpace& space = fit.space;
    const SplineSpace::BasisMatrix& table = space.basis(span);
    const double perLength = 1.0 / space.spanLength(span);
    SpanSums& sums = fit.sums[span];
    sums.near.setZero();
    sums.bent.setZero();
    sums.nearRight.fill(Vec3::Zero());
    sums.bentRight.fill(Vec3::Zero());
    const auto [begin, end] = samplesOf(fit, span);
    for (int i = begin; i < end; ++i) {
        const SeenSample& sample = samples_[i];
        Row& row = fit.rows[i];
        const double tau = (sample.parameter - space.breaks()[span]) * perLength;
        for (int j = 0; j < kBasis; ++j) {
            // Horner's scheme for a polynomial and its derivatives.
            double value = 0.0;
            double first = 0.0;
            double halfSecond = 0.0;
            for (int m = kBasis - 1; m >= 0; --m) {
                halfSecond = halfSecond * tau + first;
                first = first * tau + value;
                value = value * tau + table(j, m);
            }
            row.basis[j] = value;
            row.first[j] = first * perLength;
            row.second[j] = 2.0 * halfSecond * perLength * perLength;
            const double near = sample.weight * row.basis[j];
            const double bent = sample.weight * row.second[j];
            sums.nearRight[j] += near * sample.position;
            sums.bentRight[j] += bent * sample.second;
            for (int k = 0; k <= j; ++k) {
                sums.near(j, k) += near * row.basis[k];
                sums.bent(j, k) += bent * row.second[k];
            }
        }
    }
}

void KnotRemoval::addSums(Fit& fit, ControlPoints& right) const {
    const SplineSpace& space = fit.space;
    const double stiffness = kRemoval.secondsWeight / std::pow(space.spanCount(), 4);
    for (int span = 0; span < space.spanCount(); ++span) {
        const SpanSums& sums = fit.sums[span];
        for (int j = 0; j < space.basisCount(); ++j) {
            right.row(space.control(span, j)) +=
                (sums.nearRight[j] + stiffness * sums.bentRight[j]).transpose();
        }
        const SplineSpace::BasisMatrix products = sums.near + stiffness * sums.bent;
        addProducts(fit.factor, space, span, products.selfadjointView<Eigen::Lower>());
    }
}

template <int kBasis>
void KnotRemoval::measure(Fit& fit) const {
    const SplineSpace& space = fit.space;
    fit.firsts.reserve(samples_.size());
    fit.seconds.reserve(samples_.size());
    fit.ways.reserve(samples_.size());
    fit.bends.reserve(samples_.size());
    double sum = 0.0;
    for (int span = 0; span < space.spanCount(); ++span) {
        std::array<Vec3, kBasis> controls;
        for (int j = 0; j < kBasis; ++j) {
            controls[j] = fit.controls.row(space.control(span, j)).transpose();
        }
        const auto [begin, end] = samplesOf(fit, span);
        for (int i = begin; i < end; ++i) {
            const SeenSample& sample = samples_[i];
            const Row& row = fit.rows[i];
            Vec3 position = Vec3::Zero();
            Vec3 first = Vec3::Zero();
            Vec3 second = Vec3::Zero();
            for (int j = 0; j < kBasis; ++j) {
                position += row.basis[j] * controls[j];
                first += row.first[j] * controls[j];
                second += row.second[j] * controls[j];
            }
            const double squaredSpeed = first.squaredNorm();
            fit.firsts.push_back(first);
            fit.seconds.push_back(second);
            fit.ways.emplace_back(position - sample.position);
            fit.bends.push_back(bendOf(sample.normal.dot(first.cross(second)), squaredSpeed));
            fit.length += sample.weight * std::sqrt(squaredSpeed);
            sum += sample.weight * fit.bends.back();
        }
    }
    fit.bending = fit.length * sum;
}

// Of a sample's height and way, relative to their limits.
double KnotRemoval::farness(const SeenSample& sample, const Vec3& way) const {
    const double height = sample.height + sample.normal.dot(way);
    return std::max(std::abs(height) / limits_.height, way.norm() / limits_.way);
}

bool KnotRemoval::isWithin(const Fit& fit) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (farness(samples_[i], fit.ways[i]) > 1.0) {
            return false;
        }
    }
    return fit.bending <= mostBending_;
}

// The knots to take out next, cheapest first, no two of them neighbours.
std::vector<KnotRemoval::Candidate> KnotRemoval::nextBatch(const Fit& fit) {
    const double left = mostBending_ - fit.bending;
    std::vector<Candidate> all;
    for (std::size_t i = 1; i + 1 < fit.kept.size(); ++i) {
        const int atBreak = fit.kept[i];
        if (isLocked_[atBreak] != 0) {
            continue;
        }
        const Cost cost = costOf(fit, static_cast<int>(i));
        if (cost.farthest >= 1.0 || cost.bending >= left) {
            isLocked_[atBreak] = 1;  // without others it costs more, and less is left
        } else if (cost.bending < kRemoval.shareOfKnot * left) {
            const double share = std::max(cost.farthest, cost.bending / left);
            all.push_back({static_cast<int>(i), atBreak, share, cost.bending});
        }
    }
    std::ranges::stable_sort(all, {}, &Candidate::cost);
    // As many control points as picks must be left, and for a closed spline a span for each of the
    // basis functions on it.
    const int needed = std::max(fit.space.basisCount(), static_cast<int>(picks_.size()));
    const auto most = static_cast<std::size_t>(std::max(0, fit.space.controlCount() - needed));
    std::vector<char> isTaken(fit.kept.size(), 0);
    std::vector<Candidate> batch;
    double leftOfBatch = kRemoval.shareOfBatch * left;
    for (const Candidate& candidate : all) {
        const int i = candidate.index;
        if (batch.size() < most && candidate.bending <= leftOfBatch && isTaken[i - 1] == 0 &&
            isTaken[i + 1] == 0) {
            isTaken[i] = 1;
            leftOfBatch -= candidate.bending;
            batch.push_back(candidate);
        }
    }
    return batch;
}

// The least change of the fit without a jump of the highest derivative at a knot: of the control
// points within reach of it, answer_ times what is returned.
Vec3 KnotRemoval::moveWithout(const Fit& fit, int index) {
    const SplineSpace& space = fit.space;
    const int controls = space.controlCount();
    const int border = space.closed() ? space.degree() : 0;
    int first = index - kRemoval.reach;
    int last = index - 1 + kRemoval.reach + space.degree();
    const bool isAcross = space.closed() && (first < 0 || last >= controls - border);
    first = isAcross ? 0 : std::max(0, first);
    last = isAcross ? controls - 1 : std::min(controls - 1, last);
    if (answer_.size() < controls) {
        answer_.resize(controls);
    }
    answer_.segment(first, last - first + 1).setZero();
    std::array<double, kMaxBasis + 1> jump{};
    for (int j = 0; j < space.basisCount(); ++j) {
        const auto highest = [&](int span) {
            return space.basis(span)(j, space.degree()) /
                   std::pow(space.spanLength(span), space.degree());
        };
        jump[j] -= highest(index - 1);
        jump[j + 1] += highest(index);
    }
    const auto control = [&](int j) { return space.control(index - 1, j); };
    for (int j = 0; j <= space.basisCount(); ++j) {
        answer_[control(j)] += jump[j];
    }
    if (isAcross) {
        answer_.head(controls) = fit.factor.solve(answer_.head(controls));
    } else {
        fit.factor.solveBetween(first, last, answer_);
    }
    Vec3 all = Vec3::Zero();
    double share = 0.0;
    for (int j = 0; j <= space.basisCount(); ++j) {
        all += jump[j] * fit.controls.row(control(j)).transpose();
        share += jump[j] * answer_[control(j)];
    }
    return -all / share;
}

KnotRemoval::Cost KnotRemoval::costOf(const Fit& fit, int index) {
    const Vec3 step = moveWithout(fit, index);
    const int spans = fit.space.spanCount();
    const bool isRound = fit.space.closed() && spans > 2 * kRemoval.reach;
    Cost cost{0.0, 0.0};
    // Outwards from the knot, so that most of those which are needed are soon known.
    for (int k = 0; k < kRemoval.reach && cost.farthest < 1.0; ++k) {
        for (const int at : {index - 1 - k, index + k}) {
            if (isRound || (at >= 0 && at < spans)) {
                withBasisCount(fit.space, [&](auto count) {
                    addCost<count()>(fit, (at + spans) % spans, step, cost);
                });
            }
        }
    }
    cost.bending *= fit.length;
    return cost;
}

// What samples of a span add to the cost of a knot, whose answer_ moves them by `step`.
template <int kBasis>
void KnotRemoval::addCost(const Fit& fit, int span, const Vec3& step, Cost& cost) const {
    const SplineSpace& space = fit.space;
    std::array<double, kBasis> shares;
    for (int j = 0; j < kBasis; ++j) {
        shares[j] = answer_[space.control(span, j)];
    }
    const auto [first, last] = samplesOf(fit, span);
    for (int i = first; i < last; ++i) {
        const SeenSample& sample = samples_[i];
        const Row& row = fit.rows[i];
        double moved = 0.0;
        double faster = 0.0;
        double bent = 0.0;
        for (int j = 0; j < kBasis; ++j) {
            moved += row.basis[j] * shares[j];
            faster += row.first[j] * shares[j];
            bent += row.second[j] * shares[j];
        }
        cost.farthest = std::max(cost.farthest, farness(sample, fit.ways[i] + moved * step));
        if (cost.farthest >= 1.0) {
            return;  // it is needed
        }
        const Vec3 velocity = fit.firsts[i] + faster * step;
        const Vec3 second = fit.seconds[i] + bent * step;
        const double turn = sample.normal.dot(velocity.cross(second));
        cost.bending += sample.weight * (bendOf(turn, velocity.squaredNorm()) - fit.bends[i]);
    }
}

// Takes out of a batch, and keeps for good, the knots nearest to where its trial is too far away;
// where it is not, or there is no trial, the dearest one, and half of the batch waits.
void KnotRemoval::shorten(const Fit* trial, std::vector<Candidate>& batch) {
    std::vector<char> isNeeded(batch.size(), 0);
    bool isAny = false;
    for (std::size_t i = 0; trial != nullptr && i < samples_.size(); ++i) {
        if (farness(samples_[i], trial->ways[i]) > 1.0) {
            const auto gap = [&](const Candidate& candidate) {
                return std::abs(curve_.space.breaks()[candidate.atBreak] - samples_[i].parameter);
            };
            isNeeded[std::ranges::min_element(batch, {}, gap) - batch.begin()] = 1;
            isAny = true;
        }
    }
    if (!isAny) {
        isLocked_[batch.back().atBreak] = 1;
        batch.resize(batch.size() / 2);
        return;
    }
    std::vector<Candidate> rest;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        if (isNeeded[i] != 0) {
            isLocked_[batch[i].atBreak] = 1;
        } else {
            rest.push_back(batch[i]);
        }
    }
    batch = std::move(rest);
}

}  // namespace bspline_curve
