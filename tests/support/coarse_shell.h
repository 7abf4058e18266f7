// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "surface/surface.h"

#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve::test_support {

/// A surface and a simplified shell made by hand, not by a simplifier: one prism over each face of
/// a coarse mesh near the surface.
struct CoarseShell {
    /// Pillars stand on the vertices of the coarse mesh along their area normals, `height` mean
    /// edges of it high to either side. Every prism tracks the faces whose boxes meet its own: more
    /// than needed.
    CoarseShell(TriangleMesh fine, const TriangleMesh& coarse, double height);

    /// The shell of full resolution around a surface, for comparison.
    explicit CoarseShell(TriangleMesh fine);

    Surface surface;
    std::shared_ptr<const ExtendedSurface> extended;
    Shell shell;
};

/// The prisms over the faces of a surface, wall by wall neighbours. Slots ascend by vertex.
[[nodiscard]] std::vector<Prism> prismsOver(const Surface& middle);

/// A shell of full resolution in the other form: every prism tracks its face and the neighbours.
[[nodiscard]] Shell asSimplified(
    const Shell& thin, const std::shared_ptr<const ExtendedSurface>& extended
);

struct CoarseShellCase {
    std::string name;
    TriangleMesh fine, coarse;
    double height;
};

/// For names of parameterised tests.
std::ostream& operator<<(std::ostream& stream, const CoarseShellCase& named);

/// Surfaces in coarse shells: aligned with the coarse mesh (edges over edges, vertices over
/// vertices) and not, smooth and noisy, closed and with a boundary inside the shell's.
[[nodiscard]] std::vector<CoarseShellCase> coarseShellCases();

}  // namespace bspline_curve::test_support
