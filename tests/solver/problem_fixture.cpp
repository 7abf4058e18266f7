// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_fixture.h"

#include "solver/paper/paper_variant.h"
#include "solver/sampled_solver.h"
#include "surface/picks.h"
#include "surface/triangle_tree.h"

#include <utility>

namespace bspline_curve::test_support {

ProblemFixture::ProblemFixture(
    TriangleMesh mesh, const std::vector<Vec3>& picks, const SolverOptions& options
)
    : ProblemFixture(std::make_unique<CoarseShell>(std::move(mesh)), picks, options) {}

ProblemFixture::ProblemFixture(
    const CoarseShellCase& coarse, const std::vector<Vec3>& picks, const SolverOptions& options
)
    : ProblemFixture(
          std::make_unique<CoarseShell>(coarse.fine, coarse.coarse, coarse.height), picks, options
      ) {}

ProblemFixture::ProblemFixture(
    std::unique_ptr<CoarseShell> shell, const std::vector<Vec3>& picks, const SolverOptions& options
)
    : shell_(std::move(shell)) {
    const Surface& surface = shell_->surface;
    const TriangleTree tree(surface.vertices(), surface.faces());
    picks_ = locatePicks(surface, tree, picks, options.closed).points;
    problem_.shell = &shell_->shell;
    problem_.extended = shell_->extended.get();
    problem_.options = options;
    problem_.variant = &paperVariant();
    makePath();
    problem_.averageEdgeLength = surface.averageEdgeLength() / shell_->extended->frame.scale;
    problem_.distanceTolerance = problem_.options.distanceTolerance * problem_.averageEdgeLength;
    for (std::size_t i = 0; i + 1 < problem_.picks.size(); ++i) {
        problem_.chordLength +=
            (problem_.picks[i + 1].position - problem_.picks[i].position).norm();
    }
    if (options.closed) {
        problem_.chordLength +=
            (problem_.picks.front().position - problem_.picks.back().position).norm();
    }
}

void ProblemFixture::makePath() {
    PickPath path = makePickPath(
        shell_->surface,
        *shell_->extended,
        picks_,
        problem_.options.closed,
        {.blockedFaces = shell_->shell.blockedFaces(), .obstacles = obstacles_.get()}
    );
    path_ = std::move(path.path);
    problem_.picks = std::move(path.picks);
}

void ProblemFixture::avoid(const Region& region, double margin) {
    obstacles_ = std::make_unique<Obstacles>(shell_->surface, *shell_->extended, region, margin);
    problem_.obstacles = obstacles_.get();
    makePath();
}

void ProblemFixture::setField(const std::vector<double>& field) {
    field_ = field;
    problem_.fieldCosts = summaryOf(vertexCostsOf(field, problem_.options.fieldCost));
    for (const int source : shell_->extended->ghostSource) {
        field_.push_back(field[source]);
    }
    problem_.field = field_;
}

Solution solved(const ProblemFixture& fixture) {
    std::optional<Solution> relaxed = solveSampled(fixture.problem(), fixture.initialPath());
    return relaxed ? std::move(*relaxed)
                   : solveCellwise(fixture.problem(), fixture.initialPath()).value();
}

}  // namespace bspline_curve::test_support
