// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/shadow_curve.h"
#include "shell/shell.h"
#include "shell/shell_base.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// Thin prisms of full resolution over the faces near a curve. The fibres of a simplified shell are
/// oblique to the surface, so a spline that is smooth and within its tolerance has a shadow along
/// them that is less smooth; these fibres run along the surface's own directions. Prisms whose
/// tetrahedra are not all positive (exact) are left out. The prisms are only walked through from
/// neighbour to neighbour, so they need not be free of intersections.
struct NearShell {
    /// Over the faces that a shadow passes and two rings about them. O(faces there).
    NearShell(
        const Surface& surface, const ShellBase& whole, const ShadowCurve& shadow, double tolerance
    );

    /// Where a face of the whole base is; -1 where it is not.
    [[nodiscard]] int indexOf(int face) const;

    ShellBase base;          ///< these faces alone, ghosts last
    std::vector<int> faces;  ///< face of the whole base for each face
    Shell shell = Shell({}, {}, 0);
};

}  // namespace bspline_curve
