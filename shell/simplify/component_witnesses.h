// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "shell/simplify/prism_complex.h"
#include "shell/simplify/tracked_surface.h"

#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Keeps prisms from swallowing other components of the shell, which no crossing of top and bottom
/// would show. A vertex of the surface stands for each component: it stays where it is and in its
/// component, whatever becomes of the prisms.
class ComponentWitnesses {
public:
    /// `start` has prism i over face i of the surface's base. O(n + c log c) for c components.
    ComponentWitnesses(const TrackedSurface& surface, const Shell& start);

    /// Whether one of the prisms holds the witness of another component than that of a face of the
    /// surface (-1: of any; exact; touching counts). O(log c + witnesses between the prisms' ends
    /// along x) per prism; nothing to do for one component.
    [[nodiscard]] bool areHeld(
        const PrismComplex& complex, std::span<const Triangle> prisms, int face
    ) const;

private:
    struct Witness {
        Vec3 position;
        int component;
    };

    std::vector<int> componentOf_;  // of each face; empty for one component
    std::vector<Witness> sorted_;   // along x
};

}  // namespace bspline_curve
