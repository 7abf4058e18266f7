// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_boundary.h"

namespace bspline_curve {

ShellBoundary::ShellBoundary(const Shell& shell) {
    // Vertices: bottom, middle and top of each pillar.
    for (const Pillar& pillar : shell.pillars()) {
        vertices_.insert(vertices_.end(), {pillar.bottom, pillar.middle, pillar.top});
    }
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        const int inPrism = tet % kTetrahedraPerPrism;
        const auto& split = kSlabSplit[static_cast<std::size_t>(inPrism % 3)];
        const Prism& prism = shell.prisms()[static_cast<std::size_t>(tet / kTetrahedraPerPrism)];
        for (int k = 0; k < 4; ++k) {
            if (prism.orientation == 0 || shell.neighbour(tet, k) >= 0) {
                continue;
            }
            Triangle triangle{};
            std::size_t count = 0;
            for (std::size_t j = 0; j < 4; ++j) {
                if (static_cast<int>(j) != k) {
                    const int level = split[j].outer ? (inPrism < 3 ? 2 : 0) : 1;
                    triangle[count++] =
                        3 * prism.pillars[static_cast<std::size_t>(split[j].slot)] + level;
                }
            }
            triangles_.push_back(triangle);
            tets_.push_back(tet);
        }
    }
    tree_ = std::make_unique<TriangleTree>(vertices_, triangles_);
}

ShellBoundary::Nearest ShellBoundary::nearest(const Vec3& p) const {
    const TriangleTree::Closest closest = tree_->closestPoint(p);
    return {tets_[static_cast<std::size_t>(closest.point.face)], closest.position};
}

}  // namespace bspline_curve
