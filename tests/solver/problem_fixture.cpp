// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_fixture.h"

#include "surface/picks.h"
#include "surface/triangle_tree.h"

#include <utility>

namespace bspline_curve::test_support {

ProblemFixture::ProblemFixture(
    TriangleMesh mesh, const std::vector<Vec3>& picks, const SolverOptions& options
)
    : surface_(std::make_unique<Surface>(std::move(mesh))) {
    const ShellOptions shellOptions;
    base_ = std::make_unique<ShellBase>(makeShellBase(*surface_, shellOptions.smoothingPasses));
    build_ = std::make_unique<ShellBuild>(buildShell(*base_, shellOptions));
    const TriangleTree tree(surface_->vertices(), surface_->faces());
    PickPath path = makePickPath(
        *surface_,
        *base_,
        locatePicks(*surface_, tree, picks, options.closed),
        options.closed,
        build_->report.blockedFaces
    );
    guide_ = std::move(path.guide);
    problem_.shell = &build_->shell;
    problem_.base = base_.get();
    problem_.picks = std::move(path.picks);
    problem_.options = options;
    problem_.averageEdgeLength = surface_->averageEdgeLength() / base_->frame.scale;
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
    for (const int origin : base_->ghostOrigin) {
        problem_.field.push_back(field[static_cast<std::size_t>(origin)]);
    }
}

}  // namespace bspline_curve::test_support
