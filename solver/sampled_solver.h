// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/algorithm1.h"
#include "solver/solution.h"
#include "solver/stop_rule.h"
#include "solver/weight_schedule.h"

#include <limits>
#include <optional>

namespace bspline_curve {

/// A spline that nearly passes the picks, and the weight of the distance that it was solved with.
struct SampledStart {
    SplineCurve curve;
    double alpha = 0.0;
    bool isTight = false;  ///< it holds fast to an initial path
};

/// The constants of solveSampled().
struct SampledConstants {
    /// The first curve is a fit to the initial path within this share of the length of the polygon
    /// of picks. More takes more steps, less makes curves stick to where they start.
    double firstDistance = 0.0031;
    /// And under a strong field, which has bent the initial path: with less curves take longer,
    /// with twice as much they stay in worse valleys.
    double firstFieldDistance = 0.005;
    /// And to a path of least bending, from which it need not move away: fewer rounds, and knots
    /// that it does not need are taken out at last. With half as much there are more of these.
    double firstFairedDistance = 0.001;
    /// A tight fit is within so many tolerances; both with half and twice of it fewer curves lie in
    /// the shell in the end.
    double tightDistance = 2.0;

    /// The unit of heights, in tolerances: a mean edge length with the default tolerance.
    double heightUnit = 10.0;
    /// First weight of the distance, per squared length of the polygon of picks in units of height.
    /// Less takes more steps for the same bending; with more, curves stick to where they start.
    double firstStiffness = 1.35e6;
    /// So many times that along a path of least bending, where there is nothing to stick to.
    double fairedStiffness = 10.0;
    double leastFirstAlpha = 5.0;  ///< the first weight at least, by itself
    /// The same under a field, times 1 + strength times the factor below, where that is more: steps
    /// become fewer the larger it is, but curves follow their field less.
    double firstFieldStiffness = 4.5e5;
    double stiffnessByStrength = 2.5;
    /// A curve that starts from another one starts with this share of its last weight. With all of
    /// it it sticks to where the other one was; with much less it takes longer.
    double restartShare = 0.2;

    /// Samples are brought so far below the tolerance, in tolerances, that most curves keep it
    /// between them as well. With more, knots are fewer, but more curves are traced in vain.
    double nearShare = 0.8;
    /// A growth of the weight aims that much below what it needs: heights lag behind.
    double overshoot = 1.1;
    /// The weight grows by this at most; less takes more steps for more bending.
    double mostAlphaFactor = 10.0;
    /// No weight above this is tried: such a curve is stuck.
    double highestAlpha = 1e9;

    /// Newton stops at this share of the energy while weights and knots still change, and at last.
    /// With a quarter of either more steps are taken for the same bending.
    double roundDecrement = 0.2, restDecrement = 1e-2;
    /// And after so many steps.
    int mostSteps = 30, mostRestSteps = 10;
    /// At last also where a step has brought less than this share of what it promised: samples
    /// wander between kinks of the surface.
    double keptPromise = 0.5;
    /// Under a field a round ends where so many steps gain less than one of them should.
    int gainlessSteps = 3;
    /// So often spans are damped where a step fails, before it is shortened. Not under a field:
    /// curves may have far to go down gentle slopes, for which damped steps are too short.
    int mostDampings = 4;
    double leastStep = 0.0078125;  ///< a step is shortened to this at least: seven halvings

    /// With more tension little holds a curve between samples, and corners at picks want knots that
    /// bulges do not ask for.
    double highestTension = 0.5;
    /// Stronger fields draw samples into valleys that are narrower than the way between two
    /// samples.
    double strongestField = 20.0;
};

inline constexpr SampledConstants kSampled;

/// How the weight of the distance grows in solveSampled().
[[nodiscard]] WeightSchedule sampledSchedule();

/// How solveSampled() goes about its energy; `startAlpha`: as in SampledStart, or 0.
[[nodiscard]] SolvePolicy sampledPolicy(const CurveProblem& problem, double startAlpha = 0.0);

/// The unit of SampledEnergy's heights in solveSampled(), in the shell's frame.
[[nodiscard]] double heightUnitOf(const CurveProblem& problem);

/// The weight of the distance that solveSampled() begins with.
[[nodiscard]] double firstAlphaOf(const CurveProblem& problem);

/// The fit to the initial path that solveSampled() begins with.
[[nodiscard]] SplineCurve looseFit(const CurveProblem& problem, const InitialPath& initialPath);

/// A start that holds fast to the initial path, all of whose chords must lie on the surface: a fit
/// much nearer to it than the one that solveSampled() begins with. `stiffness`: of alpha, per
/// squared length of the polygon of picks in height units; solveSampled() begins with a share of
/// it.
[[nodiscard]] SampledStart stiffStart(
    const CurveProblem& problem, const InitialPath& initialPath, double stiffness
);

/// Whether solveSampled() is for a curve with these options, under this field.
[[nodiscard]] bool isForSamples(const CurveProblem& problem);

/// Alg. 1 of the paper with energies at samples (SampledEnergy): from a fit to the initial path, a
/// few Newton steps, then a larger weight of the distance and knots where a span would gain by
/// bulging, again and again; at last the whole curve is traced, through the shell or along the
/// fibres where there is none, and spans that leave the tolerance are halved. Hardly depends on the
/// resolution of the surface.
///
/// `start`: where to begin, in place of a fit to the initial path.
///
/// Nothing where that is not for this curve (see SolverOptions::quadrature), or where the curve
/// does not come to lie in the shell and within the tolerance: solveCellwise() then finds one with
/// every iterate inside. Throws Cancelled.
[[nodiscard]] std::optional<Solution> solveSampled(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    std::optional<SampledStart> start = {}
);

/// The same for a problem that isForSamples(), also where the curve does not come to lie there:
/// report.usable tells. Such a curve may still be near to the surface, where fibres cross. After
/// `mostWork` (see Energy::work()) no round begins, and in a round no step but the first.
[[nodiscard]] Solution relaxAtSamples(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    std::optional<SampledStart> start,
    double mostWork = std::numeric_limits<double>::infinity()
);

}  // namespace bspline_curve
