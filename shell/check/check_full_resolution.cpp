// SPDX-License-Identifier: GPL-3.0-or-later
// Shells of full resolution: the surface is the middle.
#include "shell/check/checked_shell.h"
#include "shell/face_geometry.h"
#include "surface/predicates.h"

#include <algorithm>

namespace bspline_curve {
namespace {

bool isVertexOfSurface(const CheckedShell& shell, int v) {
    const ExtendedSurface& extended = shell.extended;
    if (v >= shell.surface.vertexCount()) {
        return shell.surface.isBoundaryVertex(extended.surfaceVertex(v));
    }
    return extended.vertices[v] == extended.frame.toUnit(shell.surface.vertices()[v]) ||
           std::ranges::binary_search(extended.movedVertices, v);
}

// Whether prism f stands on face f of the extended surface, and the face is that of the surface.
bool isMiddleOf(const CheckedShell& shell, int f) {
    const Prism& p = shell.prism(f);
    if (shell.slotParity(f) == 0 || !isOfSurface(shell, f)) {
        return false;
    }
    for (std::size_t slot = 0; slot < 3; ++slot) {
        const int v = p.pillars[slot];
        if (v != shell.extended.faces[f][p.faceCorner[slot]] ||
            shell.shell.pillars()[v].middle != shell.extended.vertices[v]) {
            return false;
        }
    }
    return true;
}

// In each tetrahedron the fibres are parallel to the half pillar that it holds, which starts in
// the face: the dot product with the normal has the sign of a volume.
bool isTransversal(const CheckedShell& shell, int f) {
    const auto [a, b, c] = cornersOf(shell.extended, f);
    return std::ranges::all_of(shell.extended.faces[f], [&](int v) {
        const Pillar& pillar = shell.shell.pillars()[v];
        return orientationSign(a, b, c, pillar.top) > 0 &&
               orientationSign(a, b, c, pillar.bottom) < 0;
    });
}

}  // namespace

bool isOfSurface(const CheckedShell& shell, int face) {
    const Triangle& corners = shell.extended.faces[face];
    return (face >= shell.surface.faceCount() || corners == shell.surface.faces()[face]) &&
           std::ranges::all_of(corners, [&](int v) { return isVertexOfSurface(shell, v); });
}

void checkMiddleSurface(const CheckedShell& shell, Violations violations) {
    for (int f = 0; f < static_cast<int>(shell.extended.faces.size()); ++f) {
        const bool isMiddle = f < shell.prismCount() && isMiddleOf(shell, f);
        if (!isMiddle || (shell.isPresent(f) && !isTransversal(shell, f))) {
            violations.add({f});
        }
    }
}

void checkPrismPerFace(const CheckedShell& shell, Violations violations) {
    const int faceCount = shell.surface.faceCount();
    const int prismCount = shell.prismCount();
    std::vector<char> isListed(prismCount, 0);
    int previous = -1;
    for (const int f : shell.blockedFaces) {
        if (f <= previous || f >= faceCount || f >= prismCount) {
            violations.add({f});
        } else {
            isListed[f] = 1;
        }
        previous = std::max(previous, f);
    }
    for (int f = 0; f < faceCount; ++f) {
        if (f >= prismCount || shell.shell.isGhost(f) || shell.isPresent(f) == (isListed[f] != 0)) {
            violations.add({f});
        }
    }
    for (int i = 0; i < prismCount; ++i) {
        for (const int there : shell.prism(i).neighbours) {
            const bool isBlocked = !shell.isPresent(i);
            const bool leadsToBlocked = there >= 0 && there < prismCount && !shell.isPresent(there);
            if ((isBlocked && there >= 0) || leadsToBlocked) {
                violations.add({isBlocked ? i : there});
            }
        }
    }
}

}  // namespace bspline_curve
