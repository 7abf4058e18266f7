// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_integrals.h"

#include "solver/energy_terms.h"
#include "solver/internal_energy.h"
#include "solver/term_takers.h"
#include "spline/gauss_rule.h"
#include "utility/worker_thread.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace bspline_curve {

struct BulgeValue {
    double value, slope, second;  // derivatives by tau
};

// How a span may bulge, by tau in [0, 1].
struct BulgeShape {
    double bend, stretch;  // the integrals of second^2 and slope^2 over tau
    bool isOfSlope;        // of derivative 1 by t at a break, in place of a value by itself
    BulgeValue (*at)(double tau);
};

namespace {

// Energies below this are rounding: a curve that strays from a straight one by 1e-7 of its length
// has more (E_int is dimensionless).
constexpr double kRoundingEnergy = 1e-12;

// At the samples of a span, one column each: derivatives of the powers of tau.
using SampleMatrix = Eigen::Matrix<
    double,
    kMaxBasis,
    Eigen::Dynamic,
    Eigen::ColMajor,
    kMaxBasis,
    2 * SampledIntegrals::kMostSegments>;

SampleMatrix powersAtSamples(int order, int segments) {
    SampleMatrix powers = SampleMatrix::Zero(kMaxBasis, 2 * segments);
    for (int i = 0; i < 2 * segments; ++i) {
        const double tau = sampleParameter(i, segments);
        double power = 1.0;
        for (int m = order; m < kMaxBasis; ++m, power *= tau) {
            powers(m, i) = power;
            for (int factor = m; factor > m - order; --factor) {
                powers(m, i) *= factor;
            }
        }
    }
    return powers;
}

// The same as a vector, to be computed with in registers.
using PackedMatrix = Eigen::Array<double, 6, 1>;

PackedMatrix packed(const SymmetricMatrix& m) {
    return Eigen::Map<const PackedMatrix>(m.data());
}

// tau^2 (1 - tau)^2, which no cubic spline has.
constexpr BulgeShape kBubble = {
    0.8, 2.0 / 105.0, false, [](double tau) -> BulgeValue {
        const double rest = 1.0 - tau;
        return {
            tau * tau * rest * rest, 2.0 * tau * rest * (1.0 - 2.0 * tau), 2.0 - 12.0 * tau * rest
        };
    }
};

// The halves of spans on both sides of a break have one quadratic spline that is 0 there and beyond
// the spans: with slope 1 at the break.
BulgeValue hatAfter(double tau) {
    const double rest = 1.0 - tau;
    return tau < 0.5 ? BulgeValue{tau - 1.5 * tau * tau, 1.0 - 3.0 * tau, -3.0}
                     : BulgeValue{0.5 * rest * rest, -rest, 1.0};
}

BulgeValue hatBefore(double tau) {
    const auto [value, slope, second] = hatAfter(1.0 - tau);
    return {-value, slope, -second};
}

// Where the curvature is linear, even spans gain 1/32 by halving, and hats by themselves 1/20, half
// of it at either end.
constexpr double kSharedGain = 0.5 * 20.0 / 32.0;

constexpr BulgeShape kHatAfter = {5.0, 1.0 / 6.0, true, hatAfter};
constexpr BulgeShape kHatBefore = {5.0, 1.0 / 6.0, true, hatBefore};

// Of E_int with all bending, on the j-th control point of a span.
inline Vec3 ambientForce(
    const SplineSpace::BasisMatrix& ambient, const SpanControls& controls, int count, int j
) {
    Vec3 force = ambient(0, j) * controls[0];
    for (int k = 1; k < count; ++k) {
        force += ambient(k, j) * controls[k];
    }
    return force;
}

// From a point that holds a spline to where it passes.
inline Vec3 gapTo(const HeldPoints::Point& point, const SpanControls& controls, int count) {
    Vec3 gap = -point.position;
    for (int j = 0; j < count; ++j) {
        gap += point.basis[j] * controls[j];
    }
    return gap;
}

// A sample on a pole has infinite energy.
inline void barUnless(bool isInside, EnergyTerms& terms) {
    if (!isInside) {
        terms.internal = std::numeric_limits<double>::infinity();
    }
}

}  // namespace

SampledIntegrals::SampledIntegrals(
    const CurveProblem& problem, const SplineSpace& space, double heightUnit, int segments
)
    : problem_(problem),
      space_(space),
      heightUnit_(heightUnit),
      segments_(segments),
      faired_(space.spanCount()),
      held_(problem.faired, space) {
    const double normalShare = problem.options.bending == Bending::Geodesic
                                   ? 1.0 - problem.options.normalBendingWeight
                                   : 0.0;
    const double bending =
        2.0 / (problem.chordLength * problem.chordLength) * (1.0 - problem.options.tension);
    const SampleMatrix powers = powersAtSamples(0, segments);
    const SampleMatrix secondPowers = powersAtSamples(2, segments);
    samples_.resize(sampleCount());
    ambient_.resize(space.spanCount());
    forEach(problem.side, space.spanCount(), kSpansAtOnce, [&](int span) {
        const double length = space.spanLength(span);
        const double weight = length / samplesPerSpan();
        const SampleMatrix values = space.basis(span) * powers;
        const SampleMatrix seconds = space.basis(span) * secondPowers / (length * length);
        for (int i = 0; i < samplesPerSpan(); ++i) {
            const double t = space.breaks()[span] + sampleParameter(i, segments) * length;
            Sample& sample = samples_[span * samplesPerSpan() + i];
            sample = {t, weight, -bending * normalShare * weight, {}, {}};
            std::ranges::copy(values.col(i), sample.basis.begin());
            std::ranges::copy(seconds.col(i), sample.second.begin());
        }
        ambient_[span] = ambientProducts(problem, space, span);
    });
    setFairedShape(bending);
}

// `bending`: the weight of |P''|^2 / 2.
void SampledIntegrals::setFairedShape(double bending) {
    for (FairedSpan& span : faired_) {
        span.forces.fill(Vec3::Zero());
    }
    if (problem_.faired.empty()) {
        return;
    }
    const double stretching =
        2.0 / (problem_.chordLength * problem_.chordLength) * problem_.options.tension;
    const SampleMatrix firstPowers = powersAtSamples(1, segments_);
    for (int span = 0; span < space_.spanCount(); ++span) {
        const SampleMatrix firsts = space_.basis(span) * firstPowers / space_.spanLength(span);
        auto& [energy, forces] = faired_[span];
        for (int i = 0; i < samplesPerSpan(); ++i) {
            Sample& sample = samples_[span * samplesPerSpan() + i];
            const auto [first, second] = problem_.faired.at(sample.parameter);
            sample.fairedSecond = second;
            const Vec3 bend = sample.weight * bending * second;
            const Vec3 stretch = sample.weight * stretching * first;
            energy += 0.5 * (bend.dot(second) + stretch.dot(first));
            for (int j = 0; j < space_.basisCount(); ++j) {
                forces[j] += sample.second[j] * bend + firsts(j, i) * stretch;
            }
        }
    }
}

template <class Take>
bool SampledIntegrals::take(
    const FootedSpline& spline,
    const EnergyWeights& weights,
    double turning,
    int sample,
    const Take& take
) const {
    const FootPoint& foot = spline.feet[sample];
    return PointTerms::add(
        FootGround{problem_, weights, heightUnit_, foot.face},
        FootSample{foot, spline.frames[sample], turning},
        samples_[sample].weight,
        take
    );
}

EnergyTerms SampledIntegrals::terms(
    const FootedSpline& spline, const std::vector<FootFrame>& frozen, const EnergyWeights& weights
) const {
    // In the order of differentiate(), so that both agree to the last digit.
    std::vector<EnergyTerms> shares(space_.spanCount());
    const int n = space_.basisCount();
    forEach(problem_.side, space_.spanCount(), kSpansAtOnce, [&](int span) {
        EnergyTerms& sum = shares[span];
        for (int sample = span * samplesPerSpan(); sample < (span + 1) * samplesPerSpan();
             ++sample) {
            barUnless(take(spline, weights, 0.0, sample, TakeValue{sum}), sum);
            const double along = frozen[sample].direction.dot(spline.seconds[sample]);
            sum.internal += 0.5 * samples_[sample].normalBending * along * along;
        }
        const SpanControls controls = controlsOf(space_, spline.controls, span);
        sum.internal += faired_[span].energy;
        for (int j = 0; j < n; ++j) {
            const Vec3 force = ambientForce(ambient_[span], controls, n, j);
            sum.internal += controls[j].dot(0.5 * force - faired_[span].forces[j]);
        }
        for (const HeldPoints::Point& point : held_.of(span)) {
            sum.internal += 0.5 * point.stiffness * gapTo(point, controls, n).squaredNorm();
        }
    });
    return std::accumulate(shares.begin(), shares.end(), EnergyTerms());
}

double SampledIntegrals::total(const EnergyTerms& terms, const EnergyWeights& weights) const {
    return PointTerms::sum(terms, problem_, weights);
}

double SampledIntegrals::scale(const EnergyTerms& terms, const EnergyWeights& weights) const {
    return PointTerms::scale(terms, problem_, weights, kRoundingEnergy + problem_.faired.energy);
}

PointDerivatives SampledIntegrals::pointDerivatives(
    const FootedSpline& spline,
    const EnergyWeights& weights,
    double turning,
    int sample,
    EnergyTerms& terms
) const {
    PointDerivatives point;
    barUnless(take(spline, weights, turning, sample, TakeDerivatives{terms, point}), terms);
    return point;
}

EnergyTerms SampledIntegrals::differentiate(
    const FootedSpline& spline,
    const EnergyWeights& weights,
    double turning,
    Eigen::VectorXd& gradient,
    std::vector<SpanBlocks>& hessian
) const {
    hessian.resize(space_.spanCount());
    std::vector<SpanForces> shares(space_.spanCount());
    forEach(problem_.side, space_.spanCount(), kSpansAtOnce, [&](int span) {
        shares[span] = differentiateSpan(spline, weights, turning, span, hessian[span]);
    });
    gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(space_.controlCount()));
    EnergyTerms terms;
    for (int span = 0; span < space_.spanCount(); ++span) {
        const SpanForces& share = shares[span];
        terms = terms + share.terms;
        for (int j = 0; j < space_.basisCount(); ++j) {
            gradient.segment<3>(3 * static_cast<Eigen::Index>(space_.control(span, j))) +=
                share.forces[j];
        }
    }
    return terms;
}

SampledIntegrals::SpanForces SampledIntegrals::differentiateSpan(
    const FootedSpline& spline,
    const EnergyWeights& weights,
    double turning,
    int span,
    SpanBlocks& blocks
) const {
    const int n = space_.basisCount();
    const int perSpan = samplesPerSpan();
    SpanForces result;
    EnergyTerms& terms = result.terms;
    std::array<Vec3, kMostSamples> forces;
    std::array<Vec3, kMostSamples> bendForces;
    std::array<PackedMatrix, kMostSamples> seconds;
    std::array<PackedMatrix, kMostSamples> bends;
    const Sample* const tables = &samples_[span * perSpan];
    for (int i = 0; i < perSpan; ++i) {
        const int sample = span * perSpan + i;
        const Vec3& direction = spline.frames[sample].direction;
        const PointDerivatives point = pointDerivatives(spline, weights, turning, sample, terms);
        forces[i] = point.force;
        seconds[i] = packed(point.second);
        bends[i] = packed(rankOne(direction, tables[i].normalBending));
        const double along = direction.dot(spline.seconds[sample]);
        bendForces[i] = tables[i].normalBending * along * direction;
        terms.internal += 0.5 * tables[i].normalBending * along * along;
    }
    SplineSpace::BasisMatrix ambient = ambient_[span];
    const SpanControls controls = controlsOf(space_, spline.controls, span);
    const FairedSpan& faired = faired_[span];
    result.forces.fill(Vec3::Zero());
    terms.internal += faired.energy;
    for (int j = 0; j < n; ++j) {
        const Vec3 force = ambientForce(ambient, controls, n, j);
        terms.internal += controls[j].dot(0.5 * force - faired.forces[j]);
        result.forces[j] = force - faired.forces[j];
    }
    for (const HeldPoints::Point& point : held_.of(span)) {
        const Vec3 gap = gapTo(point, controls, n);
        const Vec3 pull = point.stiffness * gap;
        terms.internal += 0.5 * point.stiffness * gap.squaredNorm();
        for (int j = 0; j < n; ++j) {
            result.forces[j] += point.basis[j] * pull;
            for (int k = 0; k <= j; ++k) {
                ambient(k, j) += point.stiffness * point.basis[j] * point.basis[k];
            }
        }
    }
    SymmetricMatrix* block = blocks.data();
    for (int j = 0; j < n; ++j) {
        Vec3& force = result.forces[j];
        for (int i = 0; i < perSpan; ++i) {
            force += tables[i].basis[j] * forces[i] + tables[i].second[j] * bendForces[i];
        }
        for (int k = 0; k <= j; ++k, ++block) {
            PackedMatrix sum = packed({ambient(k, j), 0.0, 0.0, ambient(k, j), 0.0, ambient(k, j)});
            for (int i = 0; i < perSpan; ++i) {
                sum += (tables[i].basis[j] * tables[i].basis[k]) * seconds[i] +
                       (tables[i].second[j] * tables[i].second[k]) * bends[i];
            }
            Eigen::Map<PackedMatrix>(block->data()) = sum;
        }
    }
    return result;
}

std::vector<SampledIntegrals::ModelError> SampledIntegrals::modelErrors(
    const FootedSpline& before, const FootedSpline& spline, const EnergyWeights& weights
) const {
    // All but the distance is quadratic, and of that the model leaves out how directions turn.
    std::vector<ModelError> result(space_.spanCount());
    for (int sample = 0; sample < sampleCount(); ++sample) {
        const double weight = samples_[sample].weight;
        const auto distanceOf = [&](const FootPoint& foot) {
            EnergyTerms terms;
            const FootGround ground{problem_, weights, heightUnit_, foot.face};
            const FootSample at{foot, before.frames[sample], 0.0};
            (void)DistanceTerm<FootGround>(ground).add(at, weight, TakeValue{terms});
            return terms.distance;
        };
        const Vec3 moved = spline.positions[sample] - before.positions[sample];
        FootPoint foreseen = before.feet[sample];
        FibreProjector::predict(moved, before.frames[sample], foreseen);
        ModelError& span = result[sample / samplesPerSpan()];
        span.energy += weights.alpha * (distanceOf(spline.feet[sample]) - distanceOf(foreseen));
        span.squaredWay += weight * moved.squaredNorm();
    }
    return result;
}

void SampledIntegrals::addDamping(
    const std::vector<double>& damping, std::vector<SpanBlocks>& hessian
) const {
    const int perSpan = samplesPerSpan();
    for (int span = 0; span < space_.spanCount(); ++span) {
        if (damping[span] == 0.0) {
            continue;
        }
        SymmetricMatrix* block = hessian[span].data();
        for (int j = 0; j < space_.basisCount(); ++j) {
            for (int k = 0; k <= j; ++k, ++block) {
                double product = 0.0;
                for (int sample = span * perSpan; sample < (span + 1) * perSpan; ++sample) {
                    const Sample& table = samples_[sample];
                    product += table.weight * table.basis[j] * table.basis[k];
                }
                const double sum = 2.0 * damping[span] * product;
                *block += {sum, 0.0, 0.0, sum, 0.0, sum};
            }
        }
    }
}

double SampledIntegrals::refinementGain(
    const FootedSpline& spline, const EnergyWeights& weights, int span
) const {
    if (space_.degree() > 2) {
        Bulge bulge;
        addBulge(spline, weights, span, kBubble, bulge);
        return gainOf(bulge);
    }
    return kSharedGain *
           (gainAtBreak(spline, weights, span) + gainAtBreak(spline, weights, span + 1));
}

double SampledIntegrals::gainOf(const Bulge& bulge) {
    const Vec3 step = dense(bulge.stiffness).llt().solve(bulge.force);
    return std::max(0.0, 0.5 * bulge.force.dot(step));
}

double SampledIntegrals::gainAtBreak(
    const FootedSpline& spline, const EnergyWeights& weights, int atBreak
) const {
    const int spans = space_.spanCount();
    Bulge bulge;
    if (atBreak > 0 || space_.closed()) {
        addBulge(spline, weights, (atBreak + spans - 1) % spans, kHatBefore, bulge);
    }
    if (atBreak < spans || space_.closed()) {
        addBulge(spline, weights, atBreak % spans, kHatAfter, bulge);
    }
    return gainOf(bulge);
}

void SampledIntegrals::addBulge(
    const FootedSpline& spline,
    const EnergyWeights& weights,
    int span,
    const BulgeShape& shape,
    Bulge& bulge
) const {
    const double length = space_.spanLength(span);
    const double size = shape.isOfSlope ? length : 1.0;
    const int perSpan = samplesPerSpan();
    const double tension = problem_.options.tension;
    const double scale = 2.0 / (problem_.chordLength * problem_.chordLength);
    const double own = scale * size * size *
                       ((1.0 - tension) * shape.bend / (length * length * length) +
                        tension * shape.stretch / length);
    EnergyTerms unused;
    bulge.stiffness += {own, 0.0, 0.0, own, 0.0, own};
    for (int i = 0; i < perSpan; ++i) {
        const int sample = span * perSpan + i;
        const Sample& table = samples_[sample];
        const BulgeValue at = shape.at(sampleParameter(i, segments_));
        const double value = size * at.value;
        const double second = size * at.second / (length * length);
        const PointDerivatives point = pointDerivatives(spline, weights, 0.0, sample, unused);
        const Vec3& direction = spline.frames[sample].direction;
        const Vec3& bending = spline.seconds[sample];
        bulge.force += value * point.force +
                       second * table.normalBending * direction.dot(bending) * direction +
                       (second * scale * (1.0 - tension) * table.weight) * bending;
        bulge.stiffness += (value * value) * point.second;
        bulge.stiffness += rankOne(direction, second * second * table.normalBending);
    }
    if (!problem_.faired.empty()) {
        const SpanControls controls = controlsOf(space_, spline.controls, span);
        for (const HeldPoints::Point& point : held_.of(span)) {
            const double value = size * shape.at(point.tau).value;
            bulge.force += value * point.stiffness * gapTo(point, controls, space_.basisCount());
            const double held = value * value * point.stiffness;
            bulge.stiffness += {held, 0.0, 0.0, held, 0.0, held};
        }
    }
    if (tension > 0.0) {
        const PolynomialCurve curve = space_.polynomial(spline.controls, span);
        for (int i = 0; i < perSpan; ++i) {
            const double tau = sampleParameter(i, segments_);
            const double slope = size * shape.at(tau).slope / length;
            const Vec3 faired = problem_.faired.at(samples_[span * perSpan + i].parameter).first;
            const Vec3 stretch = curve.derivativeAt(tau) - length * faired;
            bulge.force += slope * scale * tension / perSpan * stretch;
        }
    }
}

std::vector<SeenSample> SampledIntegrals::seen(const FootedSpline& spline) const {
    std::vector<SeenSample> result;
    result.reserve(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const FootPoint& foot = spline.feet[i];
        result.push_back(
            {samples_[i].parameter,
             samples_[i].weight,
             spline.positions[i],
             spline.seconds[i] + samples_[i].fairedSecond,
             problem_.extended->normalAt(foot.face, foot.barycentric()).normalized(),
             foot.height}
        );
    }
    return result;
}

double SampledIntegrals::largestHeight(const FootedSpline& spline) const {
    double largest = 0.0;
    for (const FootPoint& foot : spline.feet) {
        largest = std::max(largest, std::abs(foot.height));
    }
    return largest;
}

}  // namespace bspline_curve
