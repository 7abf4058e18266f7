// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check_shell.h"

#include "shell/check/checked_shell.h"

#include <algorithm>

namespace bspline_curve {

bool ShellCheck::passed() const {
    const auto all = invariants();
    return std::all_of(all.begin(), all.end(), [](const InvariantCheck* invariant) {
        return invariant->holds;
    });
}

ShellCheck checkShell(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options
) {
    const CheckedShell checked(shell);
    ShellCheck result;
    checkTetrahedra(checked, {result.positiveTetrahedra, options});
    checkLayers(checked, {result.separateLayers, options});
    checkComponents(checked, {result.separateComponents, options});
    checkNeighbours(checked, {result.consistentNeighbours, options});
    if (shell.isFullResolution()) {
        checkMiddleSurface(checked, surface, extended, {result.transversalSurface, options});
        checkPrismPerFace(checked, surface, blockedFaces, {result.completeTracking, options});
    } else {
        checkSimplifiedShell(checked, surface, extended, blockedFaces, options, result);
    }
    return result;
}

}  // namespace bspline_curve
