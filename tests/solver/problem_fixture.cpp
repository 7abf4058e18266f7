// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_fixture.h"

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
    PickPath path = makePickPath(
        surface,
        *shell_->base,
        locatePicks(surface, tree, picks, options.closed),
        options.closed,
        {shell_->shell.blockedFaces(), {}}
    );
    guide_ = std::move(path.guide);
    problem_.shell = &shell_->shell;
    problem_.base = shell_->base.get();
    problem_.picks = std::move(path.picks);
    problem_.options = options;
    problem_.averageEdgeLength = surface.averageEdgeLength() / shell_->base->frame.scale;
    for (std::size_t i = 0; i + 1 < problem_.picks.size(); ++i) {
        problem_.chordLength +=
            (problem_.picks[i + 1].position - problem_.picks[i].position).norm();
    }
    if (options.closed) {
        problem_.chordLength +=
            (problem_.picks.front().position - problem_.picks.back().position).norm();
    }
}

void ProblemFixture::setField(const std::vector<double>& field) {
    problem_.field = field;
    problem_.fieldCosts = fieldCostsOf(field, problem_.options.fieldCost);
    for (const int origin : shell_->base->ghostOrigin) {
        problem_.field.push_back(field[static_cast<std::size_t>(origin)]);
    }
}

}  // namespace bspline_curve::test_support
