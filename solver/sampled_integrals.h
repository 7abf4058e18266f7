// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"
#include "projection/fibre_projector.h"
#include "solver/curve_problem.h"
#include "solver/energy_derivatives.h"
#include "solver/energy_weights.h"
#include "solver/faired_shape.h"
#include "solver/knot_removal.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// So many spans at once are worked on by one of two threads: for some microseconds.
inline constexpr std::size_t kSpansAtOnce = 8;

/// A spline, the feet of its samples, and its positions and second derivatives by t there, less
/// those of the problem's faired shape, which SampledIntegrals::follow sets.
struct FootedSpline {
    ControlPoints controls;
    std::vector<FootPoint> feet;
    std::vector<FootFrame> frames;
    std::vector<Vec3> positions, seconds;
};

struct BulgeShape;

/// The energy (7) of a spline at samples, by their foot points: E_int (4) without the normal
/// bending that the surface forces, E_ext (5), and in place of (8) the mean of (height / unit)^2,
/// which has no pole. With a faired shape E_int is that of the spline less the shape, and the
/// shape's points hold it; see FairedShape. It takes no cells, so what it costs does not depend on
/// the resolution of the surface.
///
/// The gradient is exact at samples whose feet lie inside faces. The second derivatives hold how
/// the surface bends beneath a sample as the turning of the pillar directions over its face, in
/// place of the kinks at edges, which samples do not see.
class SampledIntegrals {
public:
    /// Two Gauss points on each of so many parts of a span. With one curves bend by a fifth more;
    /// with three they cost a tenth more than with two for the same bending, but more of those that
    /// pass folds come to lie in the shell.
    static constexpr int kUsualSegments = 2;
    static constexpr int kMostSegments = 3;

    /// `heightUnit`: in the shell's frame; `segments`: up to kMostSegments.
    SampledIntegrals(
        const CurveProblem& problem,
        const SplineSpace& space,
        double heightUnit,
        int segments = kUsualSegments
    );

    [[nodiscard]] int samplesPerSpan() const { return 2 * segments_; }

    [[nodiscard]] int sampleCount() const { return space_.spanCount() * samplesPerSpan(); }

    [[nodiscard]] double parameter(int sample) const { return samples_[sample].parameter; }

    /// Finds the feet of all samples anew, each from where it is, or where it has been followed
    /// before, from where that predicts it to be; and their positions and second derivatives.
    /// Returns how many faces were looked at.
    std::int64_t follow(const FibreProjector& finder, FootedSpline& spline) const;

    /// The same for a spline that is another one refined, whose feet have been found: they are
    /// those of its samples on spans that stayed whole, and lie near them on the others.
    std::int64_t followRefined(
        const FibreProjector& finder,
        const SampledIntegrals& before,
        const FootedSpline& coarse,
        FootedSpline& spline
    ) const;

    /// The terms at a spline; bending along the directions of `frozen` (one frame per sample) does
    /// not count. E_int is infinite where a sample is on a pole.
    [[nodiscard]] EnergyTerms terms(
        const FootedSpline& spline,
        const std::vector<FootFrame>& frozen,
        const EnergyWeights& weights
    ) const;

    /// The weighted sum of the terms; and what changes of it are measured against, which leaves
    /// most of the field's least cost out.
    [[nodiscard]] double total(const EnergyTerms& terms, const EnergyWeights& weights) const;
    [[nodiscard]] double scale(const EnergyTerms& terms, const EnergyWeights& weights) const;

    /// Gradient and Hessian with the spline's own directions frozen; returns the terms there.
    /// `turning`: share of the surface's bending in the Hessian, which can make it indefinite.
    EnergyTerms differentiate(
        const FootedSpline& spline,
        const EnergyWeights& weights,
        double turning,
        Eigen::VectorXd& gradient,
        std::vector<SpanBlocks>& hessian
    ) const;

    /// Of one span: how much more energy it has after a step than Newton's model of it says, and
    /// the integral over t of the squared way of its points.
    struct ModelError {
        double energy = 0.0;
        double squaredWay = 0.0;
    };

    /// By span and without a field, where `spline` has moved from `before`, at which the model was
    /// made.
    [[nodiscard]] std::vector<ModelError> modelErrors(
        const FootedSpline& before, const FootedSpline& spline, const EnergyWeights& weights
    ) const;

    /// Adds the Hessian of damping[span] times the integral over t of the squared way of the span's
    /// points.
    void addDamping(const std::vector<double>& damping, std::vector<SpanBlocks>& hessian) const;

    /// How much the energy would fall if a span could bulge by itself: one Newton step for the
    /// bubble tau^2 (1 - tau)^2 times a vector, which no cubic spline of the space has and some of
    /// a finer one nearly have. Bending does not see bubbles of quadratic splines: they bend by
    /// jumps at their breaks. There it is half of what the bulges at both ends of the span gain,
    /// each of which is a quadratic spline on the halves of the two spans at a break.
    [[nodiscard]] double refinementGain(
        const FootedSpline& spline, const EnergyWeights& weights, int span
    ) const;

    [[nodiscard]] double largestHeight(const FootedSpline& spline) const;

    /// The spline and the surface beneath at each sample.
    [[nodiscard]] std::vector<SeenSample> seen(const FootedSpline& spline) const;

private:
    void setFairedShape(double bending);
    std::int64_t followSpans(
        const FibreProjector& finder, bool isKnown, std::span<const int> spans, FootedSpline& spline
    ) const;
    void placeSpan(bool isKnown, int span, FootedSpline& spline) const;

    // Of one span: its terms, and the gradient by its control points.
    struct SpanForces {
        EnergyTerms terms;
        std::array<Vec3, kMaxBasis> forces;
    };

    [[nodiscard]] SpanForces differentiateSpan(
        const FootedSpline& spline,
        const EnergyWeights& weights,
        double turning,
        int span,
        SpanBlocks& blocks
    ) const;

    // One Newton step of a spline that may bulge on some spans; `shape`: how, on this one.
    struct Bulge {
        SymmetricMatrix stiffness{};
        Vec3 force = Vec3::Zero();
    };

    void addBulge(
        const FootedSpline& spline,
        const EnergyWeights& weights,
        int span,
        const BulgeShape& shape,
        Bulge& bulge
    ) const;
    [[nodiscard]] static double gainOf(const Bulge& bulge);
    [[nodiscard]] double gainAtBreak(
        const FootedSpline& spline, const EnergyWeights& weights, int atBreak
    ) const;
    // Lets PointTerms take a sample; see solver/energy_terms.h.
    template <class Take>
    bool take(
        const FootedSpline& spline,
        const EnergyWeights& weights,
        double turning,
        int sample,
        const Take& take
    ) const;
    // What PointTerms say at a sample, by the position; adds to these terms.
    [[nodiscard]] PointDerivatives pointDerivatives(
        const FootedSpline& spline,
        const EnergyWeights& weights,
        double turning,
        int sample,
        EnergyTerms& terms
    ) const;

    static constexpr int kMostSamples = 2 * kMostSegments;  // of a span

    struct Sample {
        double parameter;      // t
        double weight;         // of the quadrature over [0, 1]
        double normalBending;  // of (n . P'')^2 in E_int: negative
        SplineSpace::BasisValues basis, second;
        Vec3 fairedSecond = Vec3::Zero();  // as FairedShape::at()
    };

    // E_int with all bending, less x^T A x / 2, of a span: energy - x^T forces.
    struct FairedSpan {
        double energy = 0.0;
        std::array<Vec3, kMaxBasis> forces;
    };

    const CurveProblem& problem_;
    const SplineSpace& space_;
    double heightUnit_;
    int segments_;
    std::vector<Sample> samples_;
    std::vector<SplineSpace::BasisMatrix>
        ambient_;  // E_int with all bending = x^T A x / 2, by span
    std::vector<FairedSpan> faired_;
    HeldPoints held_;
};

}  // namespace bspline_curve
