// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solution.h"

#include <optional>

namespace bspline_curve {

/// A spline that nearly passes the picks, and the weight of the distance that it was relaxed with.
struct SampledStart {
    SplineCurve curve;
    double alpha = 0.0;
    bool isTight = false;  ///< it holds fast to a initial path
};

/// When solveSampled() gives up a curve that is within the tolerance at all samples and still asks
/// for knots, round after round: mostly it passes through a fold or a thin part of the surface
/// there.
enum class StopPolicy {
    Short,  ///< when there are a few times as many; or where it stays far from the surface
    Long,   ///< after SolverOptions::maxRounds
};

/// Samples are brought so far below the tolerance that most curves keep it between them as well.
/// With 0.9 and 0.95 they have 5 % fewer knots and bend by 3 % less, but more are traced in vain,
/// and some under a field then take more than three times as long as without.
inline constexpr double kAimedShare = 0.8;

/// Newton stops at this share of the energy while weights and knots still change, and at last. With
/// a quarter of either a fifth more steps are taken and bending stays the same; where rounds stop
/// at 0.5 curves bend by 7 % more.
inline constexpr double kRoundDecrement = 0.2;
inline constexpr double kRestDecrement = 1e-2;

/// The unit of SampledEnergy's heights in solveSampled(), in the shell's frame.
[[nodiscard]] double heightUnitOf(const CurveProblem& problem);

/// The weight of the distance that solveSampled() begins with.
[[nodiscard]] double firstAlphaOf(const CurveProblem& problem);

/// By what it grows after a round that leaves the farthest sample this many tolerances away.
[[nodiscard]] double alphaGrowth(double ratio);

/// The fit to the initial path that solveSampled() begins with.
[[nodiscard]] SplineCurve looseFit(const CurveProblem& problem, const InitialPath& initialPath);

/// A start that holds fast to the initial path, all of whose chords must lie on the surface: a fit
/// much nearer to it than the one that solveSampled() begins with. `stiffness`: of alpha, per
/// squared length of the polygon of picks in tolerances; solveSampled() begins with a share of it.
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
    std::optional<SampledStart> start = {},
    StopPolicy stopPolicy = StopPolicy::Short
);

}  // namespace bspline_curve
