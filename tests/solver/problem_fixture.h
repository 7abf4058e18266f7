// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/initial_path.h"
#include "solver/cellwise_solver.h"
#include "solver/initial_curve.h"
#include "support/coarse_shell.h"
#include "surface/surface.h"

#include <memory>
#include <vector>

namespace bspline_curve::test_support {

/// Everything that a curve problem points to, built the way CurveDesigner does.
class ProblemFixture {
public:
    ProblemFixture(TriangleMesh mesh, const std::vector<Vec3>& picks, const SolverOptions& options);

    /// The same in a simplified shell over a coarse mesh (CoarseShell).
    ProblemFixture(
        const CoarseShellCase& coarse, const std::vector<Vec3>& picks, const SolverOptions& options
    );

    [[nodiscard]] const CurveProblem& problem() const { return problem_; }

    [[nodiscard]] CurveProblem& problem() { return problem_; }

    [[nodiscard]] const InitialPath& initialPath() const { return path_; }

    [[nodiscard]] const Surface& surface() const { return shell_->surface; }

    /// One value per vertex of the surface.
    void setField(const std::vector<double>& field);

    /// Avoids a region, with a margin in the mesh's unit; the initial path goes round it.
    void avoid(const Region& region, double margin);

private:
    ProblemFixture(
        std::unique_ptr<CoarseShell> shell,
        const std::vector<Vec3>& picks,
        const SolverOptions& options
    );

    void makePath();

    std::unique_ptr<CoarseShell> shell_;
    std::vector<SurfacePoint> picks_;
    std::unique_ptr<Obstacles> obstacles_;
    InitialPath path_;
    std::vector<double> field_;
    CurveProblem problem_;
};

/// The solution from the first spline along the initial path.
[[nodiscard]] Solution solved(const ProblemFixture& fixture);

}  // namespace bspline_curve::test_support
