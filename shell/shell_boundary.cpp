// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_boundary.h"

namespace bspline_curve {
namespace {

// The face of a tetrahedron opposite to its vertex k, in the boundary's vertices.
Triangle faceOpposite(const Prism& prism, int inPrism, int k) {
    const auto& split = kSlabSplit[inPrism % 3];
    const int outerLevel = inPrism < 3 ? 2 : 0;
    Triangle triangle{};
    std::size_t count = 0;
    for (int j = 0; j < 4; ++j) {
        const SplitVertex& vertex = split[j];
        if (j != k) {
            triangle[count++] = 3 * prism.pillars[vertex.slot] + (vertex.outer ? outerLevel : 1);
        }
    }
    return triangle;
}

}  // namespace

ShellBoundary::ShellBoundary(const Shell& shell) {
    // Vertices: bottom, middle and top of each pillar.
    for (const Pillar& pillar : shell.pillars()) {
        vertices_.insert(vertices_.end(), {pillar.bottom, pillar.middle, pillar.top});
    }
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        const Prism& prism = shell.prisms()[tet / kTetrahedraPerPrism];
        for (int k = 0; k < 4 && prism.orientation != 0; ++k) {
            if (shell.neighbour(tet, k) < 0) {
                triangles_.push_back(faceOpposite(prism, tet % kTetrahedraPerPrism, k));
                tets_.push_back(tet);
            }
        }
    }
    tree_ = std::make_unique<TriangleTree>(vertices_, triangles_);
}

ShellBoundary::Nearest ShellBoundary::nearest(const Vec3& p) const {
    const TriangleTree::Closest closest = tree_->closestPoint(p);
    return {tets_[closest.point.face], closest.position};
}

}  // namespace bspline_curve
