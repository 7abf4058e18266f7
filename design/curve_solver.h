// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "design/field_cache.h"
#include "design/initial_path.h"
#include "design/near_picks.h"
#include "design/prepared_surface.h"
#include "solver/curve_problem.h"
#include "solver/obstacles.h"
#include "solver/sampled_solver.h"
#include "solver/solution.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// What draws a curve somewhere, or keeps it away. Refers to all of these.
struct DesignContext {
    const ValidatedField& field;
    const Obstacles* obstacles = nullptr;  ///< null: nothing to avoid
    const Curve* start = nullptr;          ///< a curve through picks nearby; null: none
    bool keepsKnots = false;               ///< those that the curve does not need stay in
    std::span<const int> pickNumbers{};    ///< see PathConstraints
    /// Of each pick, see PickConstraint; empty: none has any.
    std::span<const Vec3> tangents{};
};

/// A curve and the problem that it solves, with the shell of the whole surface or none.
struct Solved {
    CurveProblem problem;
    Solution solution;
};

/// A problem without a shell, a field and obstacles.
[[nodiscard]] CurveProblem makeProblem(
    const PreparedSurface& prepared, const SolverOptions& options, std::vector<PickConstraint> picks
);

/// Solves for one curve, by the cheapest way that leads to one: relaxed from the curve given, from
/// a loose fit to the path through the picks, or from tight ones; at last cell by cell in the shell
/// of the whole surface, which is built for that where it is not there.
class CurveSolver {
public:
    /// Refers to all but the options. `side`: to share work with; null: none.
    CurveSolver(
        const PreparedSurface& prepared,
        const std::vector<SurfacePoint>& picks,
        const SolverOptions& options,
        const DesignContext& context,
        WorkerThread* side
    )
        : prepared_(prepared), picks_(picks), options_(options), context_(context), side_(side) {}

    /// Always a curve with a trace: where no attempt leads to one that is relaxed and within the
    /// tolerance, one that follows a shortest path (see tightAlong()); report.usable tells. Throws
    /// InputError (NoPath), Cancelled.
    [[nodiscard]] Solved solve(const Progress& progress) const;

    /// The shortest path from pick to pick, as points with chords between them. Throws InputError
    /// (NoPath).
    [[nodiscard]] PickPath quickPath() const;

    /// The fair path that keeps to the picks as the leeways say, each of them, and follows the
    /// field; see fairedPath(). Throws InputError (NoPath).
    [[nodiscard]] std::optional<PickPath> pathNear(std::span<const PickLeeway> leeways) const;

    /// A curve along such a path, through the points of it that are nearest to some picks:
    /// `passed`, ascending, the first among them and, of an open curve, the last. Nothing where it
    /// is not usable, or not to be drawn at samples.
    [[nodiscard]] std::optional<Solved> solveAlong(
        const PickPath& path, std::span<const int> passed, const Progress& progress
    ) const;

    /// The last of these, whatever else there is.
    [[nodiscard]] Solved solveTightly(const Progress& progress) const;

private:
    [[nodiscard]] bool isLocal() const { return prepared_.options().kind == ShellKind::Local; }

    [[nodiscard]] PickPath pathRound(
        std::span<const int> blockedFaces, const FieldTravel& travel, PathKind kind
    ) const;
    void setTangents(PickPath& path) const;
    [[nodiscard]] CurveProblem problemOn(
        const PickPath& path, const Shell* shell, const Progress& progress
    ) const;
    [[nodiscard]] Solved solveInTurn(const Progress& progress) const;
    [[nodiscard]] bool mayTurnBack() const;
    [[nodiscard]] bool turnsBack(const Solved& solved) const;
    [[nodiscard]] std::optional<Solved> solveFromStart(const Progress& progress) const;
    [[nodiscard]] std::optional<Solved> relaxOver(
        const ObtainedShell* whole, const Progress& progress
    ) const;
    [[nodiscard]] std::optional<Solved> relaxTightly(
        const PickPath& path, const Shell* shell, const Progress& progress, double& work
    ) const;
    // `work`: what is left for attempts at samples; falls by what this one takes.
    [[nodiscard]] std::optional<Solved> relaxed(
        CurveProblem problem,
        const InitialPath& initialPath,
        std::optional<SampledStart> start,
        double& work
    ) const;
    [[nodiscard]] double workAtSamples() const;
    [[nodiscard]] std::optional<Solved> solveInShell(const Progress& progress) const;
    [[nodiscard]] std::optional<Solved> solveInCells(
        const ObtainedShell& whole, const Progress& progress
    ) const;
    [[nodiscard]] double fairedStrength() const;
    [[nodiscard]] double clearance() const;

    [[nodiscard]] bool isFaired() const { return fairedStrength() > 0.0; }

    [[nodiscard]] std::optional<Solved> relaxFaired(
        const PickPath& path,
        const CurveProblem& unfaired,
        std::optional<SampledStart> start,
        double& work
    ) const;
    void hold(const PickPath& faired, CurveProblem& problem) const;
    [[nodiscard]] bool needsShell() const;
    [[nodiscard]] bool arePicksIn(const std::vector<int>& faces) const;

    const PreparedSurface& prepared_;
    const std::vector<SurfacePoint>& picks_;
    SolverOptions options_;
    const DesignContext& context_;
    WorkerThread* side_;
};

}  // namespace bspline_curve
