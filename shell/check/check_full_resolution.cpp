// SPDX-License-Identifier: GPL-3.0-or-later
// Shells of full resolution: the surface is the middle.
#include "shell/check/checked_shell.h"
#include "surface/predicates.h"

#include <algorithm>

namespace bspline_curve {
namespace {

// Whether prism f stands on face f of the extended surface, and the face is that of the surface.
bool isMiddleOf(
    const CheckedShell& shell, const Surface& surface, const ExtendedSurface& extended, int f
) {
    const Prism& p = shell.prism(f);
    if (shell.slotParity(f) == 0 ||
        (f < surface.faceCount() && extended.faces[f] != surface.faces()[f])) {
        return false;
    }
    for (std::size_t slot = 0; slot < 3; ++slot) {
        const int v = p.pillars[slot];
        if (v != extended.faces[f][p.faceCorner[slot]] ||
            shell.shell().pillars()[v].middle != extended.vertices[v] ||
            !isWhereItSays(surface, extended, v)) {
            return false;
        }
    }
    return true;
}

// In each tetrahedron the fibres are parallel to the half pillar that it holds, which starts in
// the face: the dot product with the normal has the sign of a volume.
bool isTransversal(const CheckedShell& shell, const ExtendedSurface& extended, int f) {
    const Triangle& face = extended.faces[f];
    const auto side = [&](const Vec3& tip) {
        return orientationSign(
            extended.vertices[face[0]], extended.vertices[face[1]], extended.vertices[face[2]], tip
        );
    };
    return std::all_of(face.begin(), face.end(), [&](int v) {
        const Pillar& pillar = shell.shell().pillars()[v];
        return side(pillar.top) > 0 && side(pillar.bottom) < 0;
    });
}

}  // namespace

bool isWhereItSays(const Surface& surface, const ExtendedSurface& extended, int v) {
    if (v >= surface.vertexCount()) {
        return surface.isBoundaryVertex(extended.surfaceVertex(v));
    }
    return extended.vertices[v] == extended.frame.toUnit(surface.vertices()[v]) ||
           std::binary_search(extended.movedVertices.begin(), extended.movedVertices.end(), v);
}

void checkMiddleSurface(
    const CheckedShell& shell,
    const Surface& surface,
    const ExtendedSurface& extended,
    Violations violations
) {
    for (int f = 0; f < static_cast<int>(extended.faces.size()); ++f) {
        const bool isMiddle = f < shell.prismCount() && isMiddleOf(shell, surface, extended, f);
        if (!isMiddle || (shell.isPresent(f) && !isTransversal(shell, extended, f))) {
            violations.add({f});
        }
    }
}

void checkPrismPerFace(
    const CheckedShell& shell,
    const Surface& surface,
    std::span<const int> blockedFaces,
    Violations violations
) {
    const int prismCount = shell.prismCount();
    std::vector<char> isListed(prismCount, 0);
    int previous = -1;
    for (const int f : blockedFaces) {
        if (f <= previous || f >= surface.faceCount() || f >= prismCount) {
            violations.add({f});
        } else {
            isListed[f] = 1;
        }
        previous = std::max(previous, f);
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
        if (f >= prismCount || shell.shell().isGhost(f) ||
            shell.isPresent(f) == (isListed[f] != 0)) {
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
