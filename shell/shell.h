// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/shell.h"
#include "shell/affine_form.h"
#include "shell/extended_surface.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

/// The broken line bottom-middle-top at a vertex of the shell's middle surface S_M; f is -1, 0, 1
/// on its points.
struct Pillar {
    Vec3 bottom, middle, top;
};

/// A prism of two slabs over one middle triangle. Slots 0, 1, 2 are its pillars in ascending order
/// of their index, which is the rank that the split into tetrahedra follows, so that neighbours
/// agree on the diagonals.
struct Prism {
    std::array<int, 3> pillars{};
    /// Prism across the wall opposite to slot k; -1 where the shell ends.
    std::array<int, 3> neighbours{};
    /// Shells of full resolution: slot k is vertex faceCorner[k] of the face.
    std::array<signed char, 3> faceCorner = {0, 1, 2};
    /// Which wall of neighbours[k] is shared with wall k.
    std::array<signed char, 3> neighbourWalls{};
    /// +1 where the slots run counter-clockwise seen from the top, -1 where clockwise; 0 for a
    /// blocked face, which keeps its place but has no prism and no neighbours.
    signed char orientation = 1;
};

/// One vertex of a tetrahedron of the split: a pillar's slot, and whether it lies on the outer
/// surface (top or bottom) instead of the middle.
struct SplitVertex {
    signed char slot;
    bool outer;
};

/// The split of a slab [Ma Mb Mc Uc], [Ma Mb Uc Ub], [Ma Ua Ub Uc], from the middle outwards.
inline constexpr std::array<std::array<SplitVertex, 4>, 3> kSlabSplit = {
    {{{{0, false}, {1, false}, {2, false}, {2, true}}},
     {{{0, false}, {1, false}, {2, true}, {1, true}}},
     {{{0, false}, {0, true}, {1, true}, {2, true}}}}
};

inline constexpr int kTetrahedraPerPrism = 6;

/// Which faces of the extended surface meet which prisms of a simplified shell. Every prism lists
/// all faces that meet it; a listed face may miss it.
struct SurfaceTracks {
    /// Faces of prism i: faces[offsets[i]] to faces[offsets[i + 1]], ascending.
    std::vector<int> offsets, faces;
};

/// A shell: prisms around the surface, every one split into six tetrahedra, with a piecewise affine
/// f in [-1, 1] (paper, Sect. 4.1; Jiang et al. 2020). Coordinates are in the shell's frame: the
/// surface's box centred at the origin, its diagonal 1. Tetrahedron ids are 6 * prism + 3 * slab +
/// k with slab 0 = top, 1 = bottom.
///
/// A shell of full resolution has one prism per face of the extended surface (prism i over face i,
/// ghost prisms after the others), so the surface lies at f = 0. A simplified shell has few and
/// thick prisms, each of which knows the faces of the extended surface that meet it; the surface
/// lies at a height f = w_S(u, v) of its own over every point (u, v) of the middle.
class Shell {
public:
    /// A shell of full resolution.
    Shell(std::vector<Pillar> pillars, std::vector<Prism> prisms, int surfaceFaceCount);

    /// A simplified shell around the surface of `extended`.
    Shell(
        std::vector<Pillar> pillars,
        std::vector<Prism> prisms,
        SurfaceTracks tracks,
        std::shared_ptr<const ExtendedSurface> extended
    );

    /// Whether the surface is the middle of the shell, with prism i over face i.
    [[nodiscard]] bool isFullResolution() const { return extended_ == nullptr; }

    [[nodiscard]] ShellKind kind() const {
        return isFullResolution() ? ShellKind::FullResolution : ShellKind::Simplified;
    }

    /// Faces of the extended surface that may meet a prism of a simplified shell, ascending.
    [[nodiscard]] std::span<const int> facesOf(int prism) const;

    /// Prisms of a simplified shell that a face of the extended surface may meet, ascending.
    [[nodiscard]] std::span<const int> prismsOf(int face) const;

    [[nodiscard]] const SurfaceTracks& tracks() const { return tracks_; }

    [[nodiscard]] const std::vector<Pillar>& pillars() const { return pillars_; }

    [[nodiscard]] const std::vector<Prism>& prisms() const { return prisms_; }

    /// How many prisms there are, without those that are blocked.
    [[nodiscard]] int prismCount() const { return prismCount_; }

    [[nodiscard]] int tetrahedronCount() const {
        return static_cast<int>(prisms_.size()) * kTetrahedraPerPrism;
    }

    /// Ghost faces continue the surface half an edge beyond a boundary, and the shell with it, so
    /// that a curve may swing out a little on its way to a minimum; the surface has no face there.
    [[nodiscard]] bool isGhost(int face) const { return face >= surfaceFaceCount_; }

    [[nodiscard]] int surfaceFaceCount() const { return surfaceFaceCount_; }

    /// Whether no prism holds a face of the extended surface: curves cannot pass it.
    [[nodiscard]] bool isBlocked(int face) const {
        const auto f = static_cast<std::size_t>(face);
        return isFullResolution() ? prisms_[f].orientation == 0
                                  : prismOffsets_[f] == prismOffsets_[f + 1];
    }

    /// The faces of the surface, ghosts left out, that are blocked, ascending. O(n).
    [[nodiscard]] std::vector<int> blockedFaces() const;

    /// The extended surface of a simplified shell.
    [[nodiscard]] const ExtendedSurface& extended() const { return *extended_; }

    /// Tetrahedron across the face opposite to vertex k of tetrahedron `tet`; -1 where the shell
    /// ends.
    [[nodiscard]] int neighbour(int tet, int k) const;

    /// The wall of the prism (by the opposite slot) that holds the face of tetrahedron `tet`
    /// opposite to its vertex k; -1 where that face is none of a wall.
    [[nodiscard]] static int wallOf(int tet, int k);

    /// Tetrahedron behind a wall of the prism that has a neighbour there, seen from a tetrahedron
    /// that touches the wall: in a face, or only in an edge.
    [[nodiscard]] int neighbourBehind(int tet, int wall) const;

    /// Tetrahedra next to `tet` along the fibre: towards the middle of the shell or through it, and
    /// away from it (below top and bottom only).
    [[nodiscard]] static int below(int tet) {
        const int slab = tet % kTetrahedraPerPrism / 3;
        return tet % 3 > 0 ? tet - 1 : tet + (slab == 0 ? 3 : -3);
    }

    [[nodiscard]] static int above(int tet) { return tet + 1; }

    /// A tetrahedron that holds a point of the surface: of those that do, in the prisms that know
    /// its face, the one whose fibres see the face best; the deepest one where rounding leaves
    /// none. -1 where the face is blocked. About 1 us in a simplified shell.
    [[nodiscard]] int locate(const SurfacePoint& point) const;

    /// The point at f = w, w in [-1, 1], of the fibre through a point of the surface. The face must
    /// not be blocked.
    [[nodiscard]] Vec3 lift(const SurfacePoint& point, double w) const;

    [[nodiscard]] Vec3 position(int tet, int k) const;

    /// Direction of the fibres in a tetrahedron, upwards: a half pillar.
    [[nodiscard]] Vec3 fibre(int tet) const;

    /// A point in coordinates of its prism.
    struct PrismPoint {
        Vec3 beta = Vec3::Zero();  ///< barycentric, of the slots; the same along a fibre
        double height = 0.0;       ///< f
    };

    /// That of a point of a tetrahedron, or beside it by its forms. Exact up to the rounding of p,
    /// however the tetrahedron is stretched. About 40 ns.
    [[nodiscard]] PrismPoint inPrism(int tet, const Vec3& p) const;

    /// Writes the four barycentric coordinates of a tetrahedron as forms of the position. About 20
    /// ns.
    void barycentrics(int tet, AffineForm* forms) const;

private:
    [[nodiscard]] Vec3 onFibre(int prism, const Vec3& beta, double w) const;

    std::vector<Pillar> pillars_;
    std::vector<Prism> prisms_;
    int prismCount_;
    int surfaceFaceCount_;
    SurfaceTracks tracks_;
    std::vector<int> prismOffsets_, facePrisms_;  // tracks_ the other way round
    std::shared_ptr<const ExtendedSurface> extended_;
};

}  // namespace bspline_curve
