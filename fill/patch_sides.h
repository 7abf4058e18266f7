// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <vector>

namespace bspline_curve {

/// What lies across each side of the faces of a disc, while its edges are halved and flipped. Side
/// k is opposite to corner k. Each step is O(1), or O(d) for d faces around a point.
class PatchSides {
public:
    /// `faces` has to outlive it, and may change by its methods alone. O(n).
    explicit PatchSides(std::vector<Triangle>& faces);

    /// -1: none.
    [[nodiscard]] int across(int face, int k) const { return beside_[face][k]; }

    /// Two faces (a, b, c) and (b, a, d), and the faces across their other sides.
    struct Pair {
        int other;  ///< the second face
        int a, b, c, d;
        int pastBC, pastCA, pastAD, pastDB;
    };

    /// A face and that across a side, if there is one.
    [[nodiscard]] Pair pairAt(int face, int k) const;

    /// Whether an edge leads from corner k of a face to another point.
    [[nodiscard]] bool hasEdgeTo(int face, int k, int point) const;

    /// Joins the corners that are opposite to a side instead of its ends. The two faces keep their
    /// numbers; in either the new edge is opposite to corner 2.
    void flip(int face, int k);

    /// Puts a point on a side and joins it to the corners opposite to it. Adds two faces.
    void halve(int face, int k, int middle);

private:
    void renameBeside(int face, int before, int after);

    std::vector<Triangle>& faces_;
    std::vector<Triangle> beside_;  // the face across the side opposite to each corner
};

}  // namespace bspline_curve
