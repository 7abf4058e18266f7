// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check_shell.h"
#include "surface/surface.h"

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve::test_support {

/// A simplified shell made without the simplifier: prisms over a coarse mesh, around a fine surface
/// close to it. Everything may be changed before shell() is asked for. In the shell's frame.
struct HandmadeShell {
    /// Pillars stand on the vertices of `middle`, along the mean of the normals around them, and
    /// reach `halfThickness` (user's unit) to either side. Tracks hold all faces of the extended
    /// surface whose boxes overlap a prism's, ghosts included.
    HandmadeShell(const TriangleMesh& middle, TriangleMesh fine, double halfThickness);

    [[nodiscard]] Shell shell() const;
    [[nodiscard]] ShellCheck check(const ShellCheckOptions& options = {}) const;

    /// Lists again, after pillars were moved or blocked faces named, what may meet which prism.
    void track();

    /// Takes a face out of the track of a prism; false where it is not there.
    bool forget(int prism, int face);

    /// The face of the surface nearest to the middle of a prism.
    [[nodiscard]] int faceInside(int prism) const;

    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const ExtendedSurface> extended;
    std::vector<Pillar> pillars;
    std::vector<Prism> prisms;
    SurfaceTracks tracks;
    std::vector<int> blockedFaces;
};

/// The mesh subdivided at midpoints, each vertex then moved by a displacement of its position.
[[nodiscard]] TriangleMesh displaced(
    TriangleMesh mesh, int subdivisions, const std::function<Vec3(const Vec3&)>& displacement
);

// ---- One for each property that simplified shells may trip over ----

/// 20 * 4^level prisms around a sphere of 20 * 4^(level + subdivisions) faces: far from the middle.
[[nodiscard]] HandmadeShell coarseSphere(int level = 1, int subdivisions = 2);

/// Bumps on a plate: the surface ends, within the walls.
[[nodiscard]] HandmadeShell coarsePlate();

/// A plate in the plane of the middle, which ends between pillars, all of it coplanar.
[[nodiscard]] HandmadeShell flatPlate();

/// A bumpy torus.
[[nodiscard]] HandmadeShell coarseTorus();

/// A bumpy box: creases.
[[nodiscard]] HandmadeShell coarseBox();

struct NamedHandmadeShell {
    std::string name;
    std::function<HandmadeShell()> make;
};

inline std::ostream& operator<<(std::ostream& stream, const NamedHandmadeShell& named) {
    return stream << named.name;
}

[[nodiscard]] std::vector<NamedHandmadeShell> handmadeShells();

}  // namespace bspline_curve::test_support
