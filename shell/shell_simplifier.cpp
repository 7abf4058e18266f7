// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_simplifier.h"

#include "bspline_curve/progress.h"
#include "shell/prism_graph.h"
#include "shell/simplify/operations.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

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
    Edges creaseEdges,
    double longestSide,
    const ShellOptions& options,
    const Progress& progress
) {
    Creases creases(std::move(creaseEdges), editor.pillarCount());
    Thickener thickener(editor);
    Collapser collapser(editor, creases);
    PillarSmoother smoother(editor, creases);
    const double thickest = 0.5 * options.targetThickness * longestSide;
    const double longest = options.targetEdgeLength * longestSide;
    double length = kSimplifier.firstStage * meanEdgeOf(editor);
    double done = 0.0;
    for (int stage = 0; stage < kSimplifier.maxStages && editor.complex().prismCount() > 0;
         ++stage) {
        // A stage removes about half of what is left, and costs as much as the one before.
        const double after = done + 0.3 * (1.0 - done);
        const Progress part = partOf(progress, done, after);
        report(part, 0.0, "simplifying the shell");
        done = after;
        const int before = editor.complex().prismCount();
        editor.rebuildGrid(kSimplifier.cellSize * length);
        if (stage > 0) {
            thickener.run(std::min(thickest, kSimplifier.thicknessShare * length));
        }
        collapser.run(std::min(length, longest), part);
        flipEdges(editor, creases);
        smoother.run();
        const int removed = before - editor.complex().prismCount();
        if (kSimplifier.thicknessShare * length >= thickest &&
            removed < kSimplifier.leastProgress * before) {
            break;
        }
        length *= kSimplifier.stageFactor;
    }
    thickener.run(thickest);
    report(progress, 1.0, "simplifying the shell");
}

// The shell that an editor has arrived at, for curves: pillars numbered in the order of the split,
// faces numbered as in `extended`.
Shell exportShell(
    const ShellEditor& editor, const std::shared_ptr<const ExtendedSurface>& extended
) {
    const PrismComplex& complex = editor.complex();
    std::vector<int> numbers(editor.pillarCount(), -1);
    std::vector<Pillar> pillars;
    for (int v = 0; v < editor.pillarCount(); ++v) {
        if (complex.hasPrisms(v)) {
            numbers[v] = static_cast<int>(pillars.size());
            pillars.push_back(editor.pillarAt(v));
        }
    }
    std::vector<Prism> prisms;
    SurfaceTracks tracks{.offsets = {0}, .faces = {}};
    for (int id = 0; id < complex.prismIdCount(); ++id) {
        if (!complex.isAlive(id)) {
            continue;
        }
        const Triangle slots = slotsOf(complex.pillarsOf(id));
        prisms.push_back(
            {.pillars = {numbers[slots[0]], numbers[slots[1]], numbers[slots[2]]},
             .neighbours = {-1, -1, -1},
             .orientation = static_cast<signed char>(orientationOf(complex.pillarsOf(id)))}
        );
        const int start = tracks.offsets.back();
        for (const int face : complex.facesOf(id)) {
            tracks.faces.push_back(editor.surface().inputFaces[face]);
        }
        std::sort(tracks.faces.begin() + start, tracks.faces.end());
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    connectPrisms(prisms);
    return {std::move(pillars), std::move(prisms), std::move(tracks), extended};
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
    thin.thickness = kSimplifier.startThickness;
    const Progress startPart = partOf(progress, 0.0, kStartShare);
    ShellBuild build = buildShell(surface.extended, thin, startPart);
    const Progress restPart = partOf(progress, kStartShare, 1.0);
    surface.prepareForEditing();
    ShellEditor editor(surface, build.shell);
    build.shell = Shell({}, {}, 0);  // a large one, and no longer needed
    simplify(editor, surface.creases, longestSideOf(surface.extended), options, restPart);
    build.shell = exportShell(editor, extended);
    for (int& face : build.report.blockedFaces) {
        face = surface.inputFaces[face];
    }
    std::ranges::sort(build.report.blockedFaces);
    for (auto& [f, g] : build.report.selfIntersections) {
        const auto [low, high] = std::minmax({surface.inputFaces[f], surface.inputFaces[g]});
        f = low;
        g = high;
    }
    std::ranges::sort(build.report.selfIntersections);
    return build;
}

}  // namespace bspline_curve
