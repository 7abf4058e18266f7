// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of (7) that are means over the curve of what lies beneath each of its points: each is
// one class, and PointTerms lists them. To add one, write it here, list it, and give it a member of
// EnergyTerms.
//
// A term is a function g of some x that depends on the point: the barrier of the relative height,
// the cost of the field. On a ground, which is a cell of the shell or the face of a sample's foot,
// it holds what it needs there. Its method `add` names g and x once; what is asked for (the value,
// the derivatives, the room below a pole, the pull) is the business of `take`, one of those in
// solver/term_takers.h. All of it is inlined.
//
// A class of a term has
//   kShare                            its member of EnergyTerms
//   weight(problem, weights)          that it has in (7)
//   scale(values, problem, weights)   its part of EnergyValue::scale
//   isOn(ground)                      whether it has a say there
//   Term(ground)                      what it holds there
//   add(point, weight, take)          calls take(kShare, weight, weight in (7), g, x), for one x or
//                                     more; returns whether all of them were taken
// g has
//   kHasPole, pole()         |x| stays below, where there is a pole
//   kMayTouch                with a pole: whether roundings may put a crossing of a wall there
//   value(weight, x)         weight g
//   jet(weight, factor, x)   weight g, factor g', factor g''
// x has
//   value
//   addDerivatives(slope, curvature, derivatives)   g' and g'' being the slope and the curvature
#pragma once

#include "bspline_curve/report.h"
#include "solver/barrier.h"
#include "solver/field_cost.h"
#include "solver/ground.h"
#include "solver/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace bspline_curve {

/// weight g, factor g' and factor g''.
struct TermJet {
    double value, slope, curvature;
};

/// An x that is linear over the face.
template <class Ground>
struct LinearArgument {
    double value;
    const Ground::Linear& form;
    const Ground::Point& point;

    LinearArgument(const Ground::Linear& linear, const Ground::Point& at)
        : value(linear.at(at)), form(linear), point(at) {}

    template <class Derivatives>
    void addDerivatives(double slope, double curvature, Derivatives& derivatives) const {
        const Vec3 gradient = gradientAt(form, point);
        derivatives.force += slope * gradient;
        derivatives.addRankOne(gradient, curvature);
    }
};

// ---- E_dist (8) ----

/// g_h of (11).
struct BarrierFunction {
    static constexpr bool kHasPole = true;
    static constexpr bool kMayTouch = false;
    double width;

    [[nodiscard]] double pole() const { return width; }

    [[nodiscard]] double value(double weight, double x) const {
        return weight * barrierValue(x, width);
    }

    [[nodiscard]] TermJet jet(double weight, double factor, double x) const {
        const Barrier g = barrier(x, width);
        return {weight * g.value, factor * g.slope, factor * g.curvature};
    }
};

/// (x / unit)^2.
struct SquareFunction {
    static constexpr bool kHasPole = false;
    double unit;

    [[nodiscard]] double value(double weight, double x) const {
        return weight / (unit * unit) * x * x;
    }

    [[nodiscard]] TermJet jet(double weight, double factor, double x) const {
        const double curvature = 2.0 * factor / (unit * unit);
        return {value(weight, x), curvature * x, curvature};
    }
};

/// The height d relative to the surface in a cell; with its derivatives by the heights w of the
/// point and v of the surface.
struct CellHeight {
    const AffineForm& height;
    const AffineForm* surface;  // null: 0, in a shell of full resolution
    double value = 0.0;
    double byHeight = 1.0, bySurface = 0.0;
    double byHeightTwice = 0.0, byBoth = 0.0, bySurfaceTwice = 0.0;

    template <class Derivatives>
    void addDerivatives(double slope, double curvature, Derivatives& derivatives) const {
        const Vec3& byP = height.gradient;
        derivatives.force += slope * byHeight * byP;
        derivatives.addRankOne(byP, curvature * byHeight * byHeight + slope * byHeightTwice);
        if (surface == nullptr) {
            return;
        }
        const Vec3& surfaceByP = surface->gradient;
        derivatives.force += slope * bySurface * surfaceByP;
        derivatives.addRankOne(
            surfaceByP, curvature * bySurface * bySurface + slope * bySurfaceTwice
        );
        derivatives.addProduct(byP, surfaceByP, curvature * byHeight * bySurface + slope * byBoth);
    }
};

/// The height of a sample over its foot.
struct FootHeight {
    double value;
    const FootSample& sample;

    explicit FootHeight(const FootSample& at) : value(at.foot.height), sample(at) {}

    template <class Derivatives>
    void addDerivatives(double slope, double curvature, Derivatives& derivatives) const {
        const FootFrame& frame = sample.frame;
        derivatives.force += slope * frame.height;
        derivatives.addRankOne(frame.height, curvature);
        derivatives.addProduct(frame.turnU, frame.u, 0.5 * sample.turning * slope);
        derivatives.addProduct(frame.turnV, frame.v, 0.5 * sample.turning * slope);
    }
};

/// E_dist: of the height, and over ghosts of how far a point lies beyond the boundary.
template <class Ground>
class DistanceTerm;

struct DistanceShare {
    static constexpr double EnergyTerms::* kShare = &EnergyTerms::distance;

    static double weight(const CurveProblem& /*problem*/, const EnergyWeights& weights) {
        return weights.alpha;
    }

    static double scale(
        const EnergyTerms& values, const CurveProblem& /*problem*/, const EnergyWeights& weights
    ) {
        return weights.alpha * values.distance;
    }

    template <class Ground>
    static bool isOn(const Ground& /*ground*/) {
        return true;
    }
};

/// In cells: barriers.
template <>
class DistanceTerm<CellGround> : public DistanceShare {
public:
    explicit DistanceTerm(const CellGround& ground)
        : alpha_(ground.weights.alpha),
          barrier_{ground.weights.barrierWidth},
          height_(ground.cell.height),
          heightScale_(ground.heightScale),
          isLinear_(ground.problem.options.relativeHeight == RelativeHeight::Linear) {
        if (!ground.problem.shell->isFullResolution()) {
            surfaceHeight_ = ground.cell.surfaceHeight;
        }
        if (isGhost(ground)) {
            beyond_ = beyondOn(ground);
        }
    }

    template <class Take>
    [[nodiscard]] bool add(const Vec3& p, double weight, const Take& take) const {
        return take(kShare, weight, alpha_, barrier_, relativeHeightAt(p)) &&
               (!beyond_ || take(
                                kShare,
                                weight,
                                alpha_,
                                BarrierFunction{1.0},
                                LinearArgument<CellGround>(*beyond_, p)
                            ));
    }

private:
    [[nodiscard]] CellHeight relativeHeightAt(const Vec3& p) const {
        const double w = height_.at(p);
        CellHeight d{height_, surfaceHeight_ ? &*surfaceHeight_ : nullptr};
        if (!surfaceHeight_) {
            d.value = heightScale_ * w;
            d.byHeight = heightScale_;
            return d;
        }
        const double v = surfaceHeight_->at(p);
        if (isLinear_) {
            setLinearHeight(w, v, d);
            return d;
        }
        // d = (w - v) / (1 - w v).
        const double inverse = 1.0 / (1.0 - w * v);
        const double square = heightScale_ * inverse * inverse;
        d.value = heightScale_ * (w - v) * inverse;
        d.byHeight = (1.0 - v * v) * square;
        d.bySurface = -(1.0 - w * w) * square;
        d.byHeightTwice = 2.0 * v * inverse * d.byHeight;
        d.byBoth = 2.0 * (w - v) * inverse * square;
        d.bySurfaceTwice = 2.0 * w * inverse * d.bySurface;
        return d;
    }

    // (10), negative below the surface; its first derivatives jump there, but those of the even
    // barrier vanish.
    void setLinearHeight(double w, double v, CellHeight& d) const {
        const double side = w >= v ? 1.0 : -1.0;
        const double inverse = 1.0 / (1.0 - side * v);
        const double square = heightScale_ * inverse * inverse;
        d.value = heightScale_ * (w - v) * inverse;
        d.byHeight = heightScale_ * inverse;
        d.bySurface = -(1.0 - side * w) * square;
        d.byBoth = side * square;
        d.bySurfaceTwice = 2.0 * side * inverse * d.bySurface;
    }

    double alpha_;
    BarrierFunction barrier_;
    AffineForm height_;
    double heightScale_;
    bool isLinear_;
    std::optional<AffineForm> surfaceHeight_;  // nothing in a shell of full resolution
    std::optional<AffineForm> beyond_;         // nothing but over ghosts
};

/// At samples: squares, which have no pole.
template <>
class DistanceTerm<FootGround> : public DistanceShare {
public:
    explicit DistanceTerm(const FootGround& ground) : ground_(ground) {}

    template <class Take>
    [[nodiscard]] bool add(const FootSample& sample, double weight, const Take& take) const {
        const double alpha = ground_.weights.alpha;
        (void)take(kShare, weight, alpha, SquareFunction{ground_.heightUnit}, FootHeight(sample));
        if (isGhost(ground_)) {
            const CornerValues beyond = beyondOn(ground_);
            const LinearArgument<FootGround> x(beyond, sample);
            (void)take(kShare, weight, alpha, SquareFunction{1.0}, x);
        }
        return true;
    }

private:
    FootGround ground_;
};

// ---- E_ext (5) ----

/// c. Where it bends downwards its second derivative is left out.
struct CostFunction {
    static constexpr bool kHasPole = false;
    FieldCost kind;

    [[nodiscard]] double value(double weight, double x) const {
        return weight * fieldCost(kind, x).value;
    }

    [[nodiscard]] TermJet jet(double weight, double factor, double x) const {
        const FieldCostValue c = fieldCost(kind, x);
        return {weight * c.value, factor * c.slope, factor * std::max(0.0, c.curvature)};
    }
};

/// What the field costs at the shadow.
template <class Ground>
class FieldTerm {
public:
    static constexpr double EnergyTerms::* kShare = &EnergyTerms::external;

    static double weight(const CurveProblem& problem, const EnergyWeights& /*weights*/) {
        return fieldWeight(problem);
    }

    static double scale(
        const EnergyTerms& values, const CurveProblem& problem, const EnergyWeights& /*weights*/
    ) {
        const double aboveLeast =
            fieldWeight(problem) * (values.external - problem.fieldCosts.least);
        return kFieldShare * std::abs(aboveLeast);
    }

    static bool isOn(const Ground& ground) { return fieldWeight(ground.problem) > 0.0; }

    explicit FieldTerm(const Ground& ground)
        : mu_(fieldWeight(ground.problem)),
          cost_{ground.problem.options.fieldCost},
          field_(ground.linear(atCorners(ground, [&](int v) { return ground.problem.field[v]; }))) {
    }

    template <class Take>
    [[nodiscard]] bool add(const Ground::Point& point, double weight, const Take& take) const {
        return take(kShare, weight, mu_, cost_, LinearArgument<Ground>(field_, point));
    }

private:
    double mu_;
    CostFunction cost_;
    Ground::Linear field_;
};

// ---- E_avoid ----

struct AvoidanceFunction {
    static constexpr bool kHasPole = true;
    static constexpr bool kMayTouch = true;  // crossings of edges that end on what is avoided

    [[nodiscard]] double pole() const { return 1.0; }

    [[nodiscard]] double value(double weight, double x) const {
        return weight * avoidanceBarrier(x).value;
    }

    [[nodiscard]] TermJet jet(double weight, double factor, double x) const {
        constexpr double kClosest = 1.0 - 1e-12;  // what rounding leaves of a crossing on the pole
        const Barrier g = avoidanceBarrier(std::min(x, kClosest));
        return {weight * g.value, factor * g.slope, factor * g.curvature};
    }
};

/// How close the shadow is to what the curve avoids: J of Obstacles.
template <class Ground>
class AvoidanceTerm {
public:
    static constexpr double EnergyTerms::* kShare = &EnergyTerms::avoidance;

    static double weight(const CurveProblem& /*problem*/, const EnergyWeights& weights) {
        return weights.avoidance;
    }

    static double scale(
        const EnergyTerms& values, const CurveProblem& /*problem*/, const EnergyWeights& weights
    ) {
        return weights.avoidance * values.avoidance;
    }

    static bool isOn(const Ground& ground) {
        return ground.problem.obstacles != nullptr && ground.weights.avoidance > 0.0 &&
               !ground.problem.obstacles->isFar(ground.face());
    }

    explicit AvoidanceTerm(const Ground& ground)
        : weight_(ground.weights.avoidance),
          isAvoided_(ground.problem.obstacles->isAvoided(ground.face())),
          face_(ground.problem.obstacles->onFace(ground.face())),
          affine_(ground.linear(face_.corners)) {
        for (std::size_t k = 0; face_.isBulging && k < 3; ++k) {
            std::array<double, 3> corner{};
            corner[k] = 1.0;
            shadow_[k] = ground.linear(corner);
        }
    }

    template <class Take>
    [[nodiscard]] bool add(const Ground::Point& point, double weight, const Take& take) const {
        return take(kShare, weight, weight_, AvoidanceFunction(), Closeness(*this, point));
    }

private:
    struct Closeness {
        double value;
        const AvoidanceTerm& term;
        const Ground::Point& point;

        Closeness(const AvoidanceTerm& of, const Ground::Point& at)
            : value(of.isAvoided_ ? 1.0 : of.affine_.at(at)), term(of), point(at) {
            for (std::size_t k = 0; of.face_.isBulging && k < 3; ++k) {
                value += of.face_.bulges[k] * of.shadow_[(k + 1) % 3].at(at) *
                         of.shadow_[(k + 2) % 3].at(at);
            }
        }

        template <class Derivatives>
        void addDerivatives(double slope, double curvature, Derivatives& derivatives) const {
            if (term.isAvoided_) {
                return;  // 1 but for roundings
            }
            const bool isBulging = term.face_.isBulging;
            Vec3 gradient = gradientAt(term.affine_, point);
            for (std::size_t k = 0; isBulging && k < 3; ++k) {
                const auto& a = term.shadow_[(k + 1) % 3];
                const auto& b = term.shadow_[(k + 2) % 3];
                gradient += term.face_.bulges[k] * (a.at(point) * gradientAt(b, point) +
                                                    b.at(point) * gradientAt(a, point));
            }
            derivatives.force += slope * gradient;
            derivatives.addRankOne(gradient, curvature);
            // J's own second derivative: bulges are below 0.
            for (std::size_t k = 0; isBulging && k < 3; ++k) {
                const Vec3 a = gradientAt(term.shadow_[(k + 1) % 3], point);
                const Vec3 b = gradientAt(term.shadow_[(k + 2) % 3], point);
                const double half = 0.5 * term.face_.bulges[k];
                derivatives.addNegative(a + b, slope * half);
                derivatives.addRankOne(a - b, -slope * half);
            }
        }
    };

    double weight_;
    bool isAvoided_;
    Obstacles::FaceCloseness face_;
    Ground::Linear affine_;
    std::array<typename Ground::Linear, 3> shadow_;
};

// ---- All of them ----

/// What a term holds on a ground, where it has a say there.
template <class Term>
struct HeldTerm {
    std::optional<Term> term;

    template <class Ground>
    explicit HeldTerm(const Ground& ground) {
        if (Term::isOn(ground)) {
            term.emplace(ground);
        }
    }

    template <class Point, class Take>
    [[nodiscard]] bool add(const Point& point, double weight, const Take& take) const {
        return !term || term->add(point, weight, take);
    }
};

template <template <class> class... Terms>
struct TermList {
    /// What all terms hold on a ground.
    template <class Ground>
    class On : private HeldTerm<Terms<Ground>>... {
    public:
        explicit On(const Ground& ground) : HeldTerm<Terms<Ground>>(ground)... {}

        /// Lets each term add a point; false where one does not take it.
        template <class Take>
        [[nodiscard]] bool add(const Ground::Point& point, double weight, const Take& take) const {
            return (HeldTerm<Terms<Ground>>::add(point, weight, take) && ...);
        }
    };

    /// The same for one point of a ground alone.
    template <class Ground, class Take>
    [[nodiscard]] static bool add(
        const Ground& ground, const Ground::Point& point, double weight, const Take& take
    ) {
        return (
            (!Terms<Ground>::isOn(ground) || Terms<Ground>(ground).add(point, weight, take)) && ...
        );
    }

    /// The weighted sum of the terms' values.
    [[nodiscard]] static double sum(
        const EnergyTerms& values, const CurveProblem& problem, const EnergyWeights& weights
    ) {
        double total = values.internal;
        ((total +=
          Terms<CellGround>::weight(problem, weights) * (values.*Terms<CellGround>::kShare)),
         ...);
        return total + weights.beta * values.fit;
    }

    /// What changes of that sum are measured against: what never goes below 0, and a share of what
    /// the field costs over its least cost; from `least` on, so that rounding does not count.
    [[nodiscard]] static double scale(
        const EnergyTerms& values,
        const CurveProblem& problem,
        const EnergyWeights& weights,
        double least
    ) {
        double total = least + values.internal;
        ((total += Terms<CellGround>::scale(values, problem, weights)), ...);
        return total + weights.beta * values.fit;
    }
};

using PointTerms = TermList<DistanceTerm, FieldTerm, AvoidanceTerm>;

}  // namespace bspline_curve
