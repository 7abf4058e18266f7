// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/checked_shell.h"

#include "surface/predicates.h"

#include <algorithm>

namespace bspline_curve {

CheckedShell::CheckedShell(
    const Shell& checked,
    const Surface& ofSurface,
    const ExtendedSurface& ofExtended,
    std::span<const int> blocked,
    const ShellCheckOptions& how
)
    : shell(checked),
      surface(ofSurface),
      extended(ofExtended),
      blockedFaces(blocked),
      options(how),
      points(checked.pillars()) {
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        for (int k = 0; k < 4 && isPresent(tet / kTetrahedraPerPrism); ++k) {
            std::array<int, 4> corners = tetPoints(tet);
            std::swap(corners[k], corners[3]);
            std::sort(corners.begin(), corners.begin() + 3);
            faces.push_back({{corners[0], corners[1], corners[2]}, tet, k});
        }
    }
    std::ranges::sort(faces);
}

int CheckedShell::slotParity(int i) const {
    const Prism& p = prism(i);
    if (!shell.isFullResolution()) {
        return p.orientation;
    }
    std::array<signed char, 3> sorted = p.faceCorner;
    std::ranges::sort(sorted);
    if (sorted != std::array<signed char, 3>{0, 1, 2}) {
        return 0;
    }
    return p.faceCorner[1] == (p.faceCorner[0] + 1) % 3 ? 1 : -1;
}

std::array<int, 2> CheckedShell::halfPillar(int tet) const {
    // Only one pillar has two of the four points.
    std::array<int, 4> corners = tetPoints(tet);
    std::ranges::sort(corners);
    for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] / PillarPoints::kLevels == corners[i + 1] / PillarPoints::kLevels) {
            return {corners[i], corners[i + 1]};
        }
    }
    return {corners[0], corners[0]};
}

int CheckedShell::volumeSign(const std::array<int, 4>& corners) const {
    const auto& [a, b, c, d] = corners;
    return orientationSign(point(a), point(b), point(c), point(d));
}

int CheckedShell::handedness(int tet) const {
    // The order of a tetrahedron's points is right-handed where the slots run counter-clockwise
    // and it lies above the middle; each of the two turns it over.
    const int side = tet % kTetrahedraPerPrism < 3 ? 1 : -1;
    return side * slotParity(tet / kTetrahedraPerPrism);
}

std::vector<TetFace> CheckedShell::boundary() const {
    std::vector<TetFace> boundary;
    forEachFace([&](std::span<const TetFace> equal) {
        if (equal.size() == 1) {
            boundary.push_back(equal.front());
        }
    });
    return boundary;
}

// ---- The whole check ----

bool ShellCheck::passed() const {
    return std::ranges::all_of(invariants(), [](const ShellInvariant* invariant) {
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
    const CheckedShell checked(shell, surface, extended, blockedFaces, options);
    ShellCheck result;
    checkTetrahedra(checked, {result.positiveTetrahedra, options});
    checkLayers(checked, {result.separateLayers, options});
    checkComponents(checked, {result.separateComponents, options});
    checkNeighbours(checked, {result.consistentNeighbours, options});
    if (shell.isFullResolution()) {
        checkMiddleSurface(checked, {result.transversalSurface, options});
        checkPrismPerFace(checked, {result.completeTracking, options});
    } else {
        checkSimplifiedShell(checked, result);
    }
    return result;
}

}  // namespace bspline_curve
