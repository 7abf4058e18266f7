// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "shell/extended_surface.h"
#include "solver/faired_shape.h"
#include "solver/field_cost.h"
#include "spline/pick_constraint.h"

#include <span>
#include <vector>

namespace bspline_curve {

class Obstacles;
class PatchLevels;
class Shell;
class ShellBoundary;
class SolveVariant;
class WorkerThread;

/// One curve to solve for: the shell, the picks, the field; all in the shell's frame. Refers to the
/// shell, the extended surface, the obstacles, the field and the thread.
struct CurveProblem {
    const Shell* shell =
        nullptr;  ///< null: for solveSampled() alone, which then follows the fibres
    const ExtendedSurface* extended = nullptr;
    const PatchLevels* patches = nullptr;     ///< of the surface; null: feet are found without
    const ShellBoundary* boundary = nullptr;  ///< needed by Quadrature::Samples alone
    const Obstacles* obstacles = nullptr;     ///< what the curve avoids; null: nothing
    std::vector<PickConstraint> picks;        ///< that the curve passes
    /// Of all picks as they were asked for, where the curve need not pass them: the parameters at
    /// which it is near to them, ascending. Empty: those of `picks`.
    std::vector<double> nearParameters;
    std::span<const double> field;  ///< one value per vertex of the extended surface, or empty
    FieldCosts fieldCosts;          ///< of `field`, as the options say
    FairedShape faired;             ///< for solveSampled() alone; empty: none
    SolverOptions options;
    double chordLength = 0.0;               ///< L of (4)
    double averageEdgeLength = 0.0;         ///< in the shell's frame
    double distanceTolerance = 0.0;         ///< epsilon of (3), in the shell's frame
    const SolveVariant* variant = nullptr;  ///< other ways of some steps; null: none
    bool keepsKnots = false;                ///< those that the curve does not need stay in
    WorkerThread* side = nullptr;           ///< to share work with; null: none
    Progress progress;
};

/// Where the curve passes picks, or is near to them.
[[nodiscard]] inline std::vector<double> pickParametersOf(const CurveProblem& problem) {
    std::vector<double> parameters = problem.nearParameters;
    if (parameters.empty()) {
        for (const PickConstraint& pick : problem.picks) {
            parameters.push_back(pick.parameter);
        }
    }
    return parameters;
}

/// The weight of the field: mu of (7), or 0 without a field or where it costs the same everywhere.
[[nodiscard]] inline double fieldWeight(const CurveProblem& problem) {
    return problem.fieldCosts.meanExcess > 0.0 ? problem.options.fieldWeight : 0.0;
}

/// How strong the field is beside bending: mu times what the field costs on average over its least
/// cost, relative to the bending of a usual curve. 0 where the field has no say.
[[nodiscard]] inline double fieldStrength(const CurveProblem& problem) {
    return fieldWeight(problem) * problem.fieldCosts.meanExcess / kUsualBending;
}

/// Whether it is strong enough to move a curve: weaker ones are less than the digits of E_int, at 5
/// and more, that are asked for.
[[nodiscard]] inline bool hasPull(const CurveProblem& problem) {
    constexpr double kFaintField = 1e-6;
    return fieldStrength(problem) > kFaintField;
}

}  // namespace bspline_curve
