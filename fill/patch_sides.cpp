// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_sides.h"

#include "surface/half_edges.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <span>

namespace bspline_curve {

PatchSides::PatchSides(std::vector<Triangle>& faces)
    : faces_(faces), beside_(faces.size(), Triangle{-1, -1, -1}) {
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 2) {
            beside_[sides[0].face][sides[0].k] = sides[1].face;
            beside_[sides[1].face][sides[1].k] = sides[0].face;
        }
    });
}

PatchSides::Pair PatchSides::pairAt(int face, int k) const {
    const Triangle& one = faces_[face];
    const int other = beside_[face][k];
    const int a = one[(k + 1) % 3];
    const int j = (cornerOf(faces_[other], a) + 1) % 3;
    return {
        .other = other,
        .a = a,
        .b = one[(k + 2) % 3],
        .c = one[k],
        .d = faces_[other][j],
        .pastBC = beside_[face][(k + 1) % 3],
        .pastCA = beside_[face][(k + 2) % 3],
        .pastAD = beside_[other][(j + 1) % 3],
        .pastDB = beside_[other][(j + 2) % 3]
    };
}

bool PatchSides::hasEdgeTo(int face, int k, int point) const {
    const int centre = faces_[face][k];
    // One way round, and where that ends at the boundary the other way.
    for (const int turn : {1, 2}) {
        int at = face;
        int corner = k;
        do {
            if (std::ranges::find(faces_[at], point) != faces_[at].end()) {
                return true;
            }
            at = beside_[at][(corner + turn) % 3];
            corner = at >= 0 ? cornerOf(faces_[at], centre) : -1;
        } while (at >= 0 && at != face);
        if (at == face) {
            return false;
        }
    }
    return false;
}

void PatchSides::flip(int face, int k) {
    const auto [other, a, b, c, d, pastBC, pastCA, pastAD, pastDB] = pairAt(face, k);
    faces_[face] = {c, d, b};
    faces_[other] = {d, c, a};
    beside_[face] = {pastDB, pastBC, other};
    beside_[other] = {pastCA, pastAD, face};
    renameBeside(pastDB, other, face);
    renameBeside(pastCA, face, other);
}

void PatchSides::halve(int face, int k, int middle) {
    const auto [other, a, b, c, d, pastBC, pastCA, pastAD, pastDB] = pairAt(face, k);
    const auto third = static_cast<int>(faces_.size());
    const int fourth = third + 1;
    faces_[face] = {a, middle, c};
    faces_[other] = {b, middle, d};
    faces_.push_back({middle, b, c});
    faces_.push_back({middle, a, d});
    beside_[face] = {third, pastCA, fourth};
    beside_[other] = {fourth, pastDB, third};
    beside_.push_back({pastBC, face, other});
    beside_.push_back({pastAD, other, face});
    renameBeside(pastBC, face, third);
    renameBeside(pastAD, other, fourth);
}

void PatchSides::renameBeside(int face, int before, int after) {
    if (face >= 0) {
        std::ranges::replace(beside_[face], before, after);
    }
}

}  // namespace bspline_curve
