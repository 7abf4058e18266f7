// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/whole_shell.h"

#include "bspline_curve/error.h"
#include "io/shell_cache.h"
#include "io/shell_measures.h"
#include "io/shell_writer.h"
#include "io/whole_shell_parts.h"
#include "shell/check_shell.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

int boundaryEdgesOf(const Surface& surface) {
    std::ptrdiff_t count = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        count += std::ranges::count(neighbours, -1);
    }
    return static_cast<int>(count);
}

ShellFigures figuresOf(const WholeShell::Parts& parts) {
    const PrismCounts counts = countPrisms(parts.shell());
    return {
        .kind = parts.shell().kind(),
        .prisms = counts.all,
        .ghostPrisms = counts.ghosts,
        .pillars = counts.pillars,
        .blockedFaces = static_cast<int>(parts.blockedFaces().size()),
        .movedVertices = static_cast<int>(parts.extended->movedVertices.size()),
        .thickness = measureThickness(parts.surface, parts.extended->frame, parts.shell()),
        .boundaryEdges = boundaryEdgesOf(parts.surface),
        .longestSide = longestSideOf(parts.surface)
    };
}

std::unique_ptr<WholeShell::Parts> partsOf(
    const Workpiece& workpiece, bool takesKept, const Progress& progress
) {
    constexpr double kExtendedShare = 0.1;  // of the work
    const ShellOptions& options = workpiece.options().shell;
    if (options.kind == ShellKind::Local) {
        throw InputError(
            InputErrorCode::BadOption,
            "a local shell has no prisms, only the fibres near a curve: use simplified or full"
        );
    }
    const Surface& surface = surfaceOf(workpiece);
    const std::optional<ShellCache> cache = takesKept ? ShellCache::ofUser() : std::nullopt;
    Stopwatch watch;
    auto extended =
        std::make_shared<const ExtendedSurface>(extendSurface(surface, options.smoothingPasses));
    const double extendedSeconds = watch.lap();
    ObtainedShell obtained = findOrMakeShell(
        surface, extended, options, cache ? &*cache : nullptr, partOf(progress, kExtendedShare, 1.0)
    );
    const double shellSeconds = watch.lap();
    if (obtained.build.shell.prismCount() == 0) {
        throw InputError(
            InputErrorCode::NoShell,
            "no face got a prism: the surface crosses itself or folds onto itself everywhere"
        );
    }
    auto parts = std::make_unique<WholeShell::Parts>(WholeShell::Parts{
        .surface = surface,
        .options = options,
        .extended = std::move(extended),
        .obtained = std::move(obtained),
        .figures = {}
    });
    parts->figures = figuresOf(*parts);
    parts->figures.extendedSeconds = extendedSeconds;
    parts->figures.shellSeconds = shellSeconds;
    return parts;
}

}  // namespace

WholeShell::WholeShell(const Workpiece& workpiece, bool takesKept, const Progress& progress)
    : parts_(partsOf(workpiece, takesKept, progress)) {}

WholeShell::~WholeShell() = default;
WholeShell::WholeShell(WholeShell&&) noexcept = default;
WholeShell& WholeShell::operator=(WholeShell&&) noexcept = default;

const ShellFigures& WholeShell::figures() const {
    return parts_->figures;
}

std::vector<ShellInvariant> WholeShell::check() const {
    const ShellCheck checked =
        checkShell(parts_->surface, *parts_->extended, parts_->shell(), parts_->blockedFaces());
    std::vector<ShellInvariant> invariants;
    for (const ShellInvariant* const each : checked.invariants()) {
        invariants.push_back(*each);
    }
    return invariants;
}

void WholeShell::keep() {
    const std::optional<ShellCache> cache = ShellCache::ofUser();
    keepShell(
        parts_->surface,
        *parts_->extended,
        parts_->options,
        cache ? &*cache : nullptr,
        parts_->obtained
    );
}

const std::vector<std::string>& WholeShell::notes() const {
    return parts_->obtained.notes;
}

std::string WholeShell::bytes(const std::filesystem::path& file) const {
    return shellBytes(file, parts_->shell(), parts_->extended->frame);
}

void prepareWithKeptShell(const Workpiece& workpiece, const Progress& progress) {
    const std::optional<ShellCache> cache = ShellCache::ofUser();
    static_cast<void>(sharedDesignerOf(workpiece, progress, cache ? &*cache : nullptr));
}

}  // namespace bspline_curve
