// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// What lies across the face opposite to vertex k of tetrahedron i of a slab.
enum class Across : signed char { Tetrahedron, OtherSlab, WallLower, WallUpper, Outside };

struct Adjacency {
    Across kind;
    signed char target;  // Tetrahedron: its index in the slab; walls: the wall's slot
};

// The tables follow kSlabSplit; a wall between slots p < q has its diagonal from Mp to Uq, hence a
// lower and an upper half.
constexpr std::array<std::array<Adjacency, 4>, 3> kAdjacency = {
    {{{{Across::WallLower, 0},
       {Across::WallLower, 1},
       {Across::Tetrahedron, 1},
       {Across::OtherSlab, 0}}},
     {{{Across::WallUpper, 0},
       {Across::Tetrahedron, 2},
       {Across::WallLower, 2},
       {Across::Tetrahedron, 0}}},
     {{{Across::Outside, 0},
       {Across::Tetrahedron, 1},
       {Across::WallUpper, 1},
       {Across::WallUpper, 2}}}}
};

// The tetrahedron of a slab that holds the lower and the upper half of the wall opposite to a slot.
constexpr std::array<int, 3> kBehindLowerWall = {0, 0, 1};
constexpr std::array<int, 3> kBehindUpperWall = {1, 2, 2};

}  // namespace

Shell::Shell(std::vector<Pillar> pillars, std::vector<Prism> prisms, int surfaceFaceCount)
    : pillars_(std::move(pillars)),
      prisms_(std::move(prisms)),
      surfaceFaceCount_(surfaceFaceCount) {}

Shell::Shell(
    std::vector<Pillar> pillars,
    std::vector<Prism> prisms,
    SurfaceTracks tracks,
    std::shared_ptr<const ShellBase> base
)
    : pillars_(std::move(pillars)),
      prisms_(std::move(prisms)),
      surfaceFaceCount_(base->surfaceFaceCount),
      tracks_(std::move(tracks)),
      base_(std::move(base)) {
    prismOffsets_.assign(base_->faces.size() + 1, 0);
    for (const int face : tracks_.faces) {
        ++prismOffsets_[at(face) + 1];
    }
    std::partial_sum(prismOffsets_.begin(), prismOffsets_.end(), prismOffsets_.begin());
    std::vector<int> next(prismOffsets_.begin(), prismOffsets_.end() - 1);
    facePrisms_.resize(tracks_.faces.size());
    for (std::size_t prism = 0; prism < prisms_.size(); ++prism) {
        for (const int face : facesOf(static_cast<int>(prism))) {
            facePrisms_[at(next[at(face)]++)] = static_cast<int>(prism);
        }
    }
}

std::span<const int> Shell::facesOf(int prism) const {
    const int first = tracks_.offsets[at(prism)];
    return {tracks_.faces.data() + first, at(tracks_.offsets[at(prism) + 1] - first)};
}

std::span<const int> Shell::prismsOf(int face) const {
    const int first = prismOffsets_[at(face)];
    return {facePrisms_.data() + first, at(prismOffsets_[at(face) + 1] - first)};
}

int Shell::neighbour(int tet, int k) const {
    const int prism = tet / kTetrahedraPerPrism;
    const int inPrism = tet % kTetrahedraPerPrism;
    const int slab = inPrism / 3;
    const Adjacency adjacency =
        kAdjacency[static_cast<std::size_t>(inPrism % 3)][static_cast<std::size_t>(k)];
    switch (adjacency.kind) {
        case Across::Outside:
            return -1;
        case Across::Tetrahedron:
            return prism * kTetrahedraPerPrism + slab * 3 + adjacency.target;
        case Across::OtherSlab:
            return prism * kTetrahedraPerPrism + (1 - slab) * 3;
        case Across::WallLower:
        case Across::WallUpper:
            break;
    }
    const auto wall = static_cast<std::size_t>(adjacency.target);
    const Prism& here = prisms_[static_cast<std::size_t>(prism)];
    const int there = here.neighbours[wall];
    if (there < 0) {
        return -1;
    }
    const auto wallThere = static_cast<std::size_t>(here.neighbourWalls[wall]);
    const int inSlab = adjacency.kind == Across::WallLower ? kBehindLowerWall[wallThere]
                                                           : kBehindUpperWall[wallThere];
    return there * kTetrahedraPerPrism + slab * 3 + inSlab;
}

int Shell::locate(const SurfacePoint& point) const {
    return point.face * kTetrahedraPerPrism;
}

Vec3 Shell::lift(const SurfacePoint& point, double w) const {
    const Prism& prism = prisms_[static_cast<std::size_t>(point.face)];
    std::array<double, 3> beta{};
    for (std::size_t slot = 0; slot < 3; ++slot) {
        beta[slot] = point.barycentric[prism.faceCorner[slot]];
    }
    // In the reference slab the fibre over beta rises from the middle through the tetrahedra whose
    // outer vertices are c, then c and b, then all three: outer weight goes to slot c first, up to
    // beta_c, then to b, then to a.
    double rest = std::abs(w);
    std::array<double, 3> outer{};
    for (std::size_t slot = 3; slot-- > 0;) {
        outer[slot] = std::min(rest, beta[slot]);
        rest -= outer[slot];
    }
    Vec3 result = Vec3::Zero();
    for (std::size_t slot = 0; slot < 3; ++slot) {
        const Pillar& pillar = pillars_[static_cast<std::size_t>(prism.pillars[slot])];
        result += (beta[slot] - outer[slot]) * pillar.middle +
                  outer[slot] * (w >= 0.0 ? pillar.top : pillar.bottom);
    }
    return result;
}

Vec3 Shell::position(int tet, int k) const {
    const Prism& prism = prisms_[static_cast<std::size_t>(tet / kTetrahedraPerPrism)];
    const int inPrism = tet % kTetrahedraPerPrism;
    const SplitVertex vertex =
        kSlabSplit[static_cast<std::size_t>(inPrism % 3)][static_cast<std::size_t>(k)];
    const Pillar& pillar =
        pillars_[static_cast<std::size_t>(prism.pillars[static_cast<std::size_t>(vertex.slot)])];
    if (!vertex.outer) {
        return pillar.middle;
    }
    return inPrism < 3 ? pillar.top : pillar.bottom;
}

}  // namespace bspline_curve
