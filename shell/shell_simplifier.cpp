// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_simplifier.h"

#include "shell/simplify/export_shell.h"
#include "shell/simplify/operations.h"
#include "shell/simplify/tracked_surface.h"
#include "utility/report_progress.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

// The shell that the simplifier starts from, in mean edge lengths at each vertex.
constexpr double kStartThickness = 0.5;
// Target edge lengths of the stages: the first in mean edges, then each by this factor.
constexpr double kFirstStage = 1.6;
constexpr double kStageFactor = 1.5;
// Half pillars are at most this share of the target edge length of a stage.
constexpr double kThicknessShare = 0.5;
// The stages end where one removes less than this share of the prisms.
constexpr double kLeastProgress = 0.01;
constexpr int kMaxStages = 60;
// Size of the grid's cells in target edge lengths: prisms then lie in about two cells per axis.
constexpr double kCellSize = 2.0;

// Mean length of the middle edges of all prisms.
double meanEdgeOf(const ShellEditor& editor) {
    double total = 0.0;
    for (int prism = 0; prism < editor.complex().prismIdCount(); ++prism) {
        const Triangle& p = editor.complex().pillarsOf(prism);
        total += editor.middleLength(p[0], p[1]) + editor.middleLength(p[1], p[2]) +
                 editor.middleLength(p[2], p[0]);
    }
    return total / (3.0 * std::max(1, editor.complex().prismCount()));
}

void simplify(
    ShellEditor& editor,
    std::vector<std::pair<int, int>> creaseEdges,
    double longestSide,
    const ShellOptions& options,
    const Progress& progress
) {
    Creases creases(std::move(creaseEdges), editor.pillarCount());
    Thickener thickener(editor);
    Collapser collapser(editor, creases);
    SampledSolver relaxer(editor, creases);
    const double reach = 0.5 * options.targetThickness * longestSide;
    const double longest = options.targetEdgeLength * longestSide;
    double length = kFirstStage * meanEdgeOf(editor);
    double done = 0.0;
    for (int stage = 0; stage < kMaxStages && editor.complex().prismCount() > 0; ++stage) {
        // A stage removes about half of what is left, and costs as much as the one before.
        const double after = done + 0.3 * (1.0 - done);
        const Progress part = partOf(progress, done, after);
        report(part, 0.0, "simplifying the shell");
        done = after;
        const int before = editor.complex().prismCount();
        editor.rebuildGrid(kCellSize * length);
        if (stage > 0) {
            thickener.run(std::min(reach, kThicknessShare * length));
        }
        collapser.run(std::min(length, longest), part);
        flipEdges(editor, creases);
        relaxer.run();
        const int removed = before - editor.complex().prismCount();
        if (kThicknessShare * length >= reach && removed < kLeastProgress * before) {
            break;
        }
        length *= kStageFactor;
    }
    thickener.run(reach);
    report(progress, 1.0, "simplifying the shell");
}

}  // namespace

ShellBuild makeShell(
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const Progress& progress
) {
    return options.kind == ShellKind::Simplified ? buildSimplifiedShell(extended, options, progress)
                                                 : buildShell(*extended, options, progress);
}

ShellBuild buildSimplifiedShell(
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const Progress& progress
) {
    options.validate();
    constexpr double kStartShare = 0.1;  // of the whole time
    TrackedSurface surface(*extended);
    ShellOptions thin = options;
    thin.thickness = kStartThickness;
    const Progress startPart = partOf(progress, 0.0, kStartShare);
    ShellBuild build = buildShell(surface.extended, thin, startPart);
    const Progress restPart = partOf(progress, kStartShare, 1.0);
    surface.prepareForEditing();
    ShellEditor editor(surface, build.shell);
    build.shell = Shell({}, {}, 0);  // a large one, and no longer needed
    simplify(editor, surface.creases, longestSideOf(surface.extended), options, restPart);
    build.shell = exportShell(editor, extended);
    for (int& face : build.report.blockedFaces) {
        face = surface.originalFaces[face];
    }
    std::ranges::sort(build.report.blockedFaces);
    for (auto& [f, g] : build.report.selfIntersections) {
        const auto [low, high] = std::minmax({surface.originalFaces[f], surface.originalFaces[g]});
        f = low;
        g = high;
    }
    std::ranges::sort(build.report.selfIntersections);
    return build;
}

}  // namespace bspline_curve
