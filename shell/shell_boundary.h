// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_cell.h"
#include "surface/triangle_tree.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// The boundary of a shell as triangles: top, bottom, and the walls where it ends. Finds the
/// nearest point of the boundary for points outside. O(n log n) to build.
class ShellBoundary {
public:
    explicit ShellBoundary(const Shell& shell);

    struct Nearest {
        int tet = -1;   ///< a tetrahedron of the shell that the point belongs to
        Vec3 position;  ///< of the nearest point of the boundary
    };

    [[nodiscard]] Nearest nearest(const Vec3& p) const;

private:
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<int> tets_;
    std::unique_ptr<TriangleTree> tree_;
};

}  // namespace bspline_curve
