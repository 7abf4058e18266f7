// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/affine_form.h"
#include "shell/shell.h"

#include <optional>

namespace bspline_curve {

/// What a curve finds across a wall of a cell.
enum class Entry {
    Entered,
    Outside,  ///< the shell ends there, or the surface in it
    Lost  ///< the fibres of the new cell see its face from behind: the curve does not pass there,
          ///< but through the edge in which several walls meet
};

/// A piece of the shell in which everything that a curve needs to know is affine in the position p:
/// barycentric coordinates, height, and the shadow M_S(p). Holds no pointer.
///
/// In a shell of full resolution it is a tetrahedron, bounded by four walls. In a simplified shell
/// it is the part of a tetrahedron whose points have their shadow in one face of the extended
/// surface, and in one tetrahedron of the same prism, the foot: the height of the surface is affine
/// there. It is bounded by up to nine walls: the four of the tetrahedron, the three edges of the
/// face, and the heights that separate the foot from the tetrahedra below and above. Every wall is
/// an affine form that is positive inside.
///
/// Built in about 30 ns in a shell of full resolution.
struct ShellCell {
    static constexpr int kMaxWalls = 9;
    /// Walls 0 to 3 are opposite to the vertices of the tetrahedron; these to the face's.
    static constexpr int kFirstFaceWall = 4;
    /// Beyond these the surface is nearer to the middle, or farther from it, than in the foot.
    static constexpr int kFootFalls = 7, kFootRises = 8;

    int tet = -1;
    int prism = -1;
    int foot = -1;  ///< tetrahedron that holds the shadow; -1 in a shell of full resolution
    int face = -1;  ///< of the extended surface, ghosts included, that holds the shadow
    int wallCount = 0;

    /// The first wallCount bound the cell. Forms 4 to 6 are the barycentric coordinates of the
    /// shadow even where they bound nothing (full resolution).
    std::array<AffineForm, kMaxWalls> walls;
    AffineForm height;         ///< f, in [-1, 1]
    AffineForm surfaceHeight;  ///< f at the shadow; 0 in a shell of full resolution

    ShellCell() = default;
    /// The cell of a tetrahedron of a shell of full resolution.
    ShellCell(const Shell& shell, int tetrahedron);
    /// A cell of a simplified shell: of a tetrahedron, a foot in the same prism, and a face.
    ShellCell(const Shell& shell, int tetrahedron, int footTetrahedron, int baseFace);
    /// A cell that holds a point of the surface, in either form. The point's face must have a
    /// prism. A point on an edge or a vertex is in several cells; one is chosen.
    ShellCell(const Shell& shell, const SurfacePoint& point);
    /// The cell of a point of a tetrahedron, in either form: a search of all faces of its prism,
    /// about 0.1 us each. Where the fibre through the point misses them (beyond the rim of the
    /// surface) the nearest cell; nothing where the prism has no face that its fibres see from
    /// above.
    [[nodiscard]] static std::optional<ShellCell> find(
        const Shell& shell, int tetrahedron, const Vec3& p
    );

    /// Makes this the cell across a wall of another cell of the same shell. Only what changes is
    /// computed: 10 ns for another face, 60 ns for another prism.
    [[nodiscard]] Entry enter(const Shell& shell, const ShellCell& from, int wall);

    /// The form of the shadow's barycentric coordinate at a vertex of the face.
    [[nodiscard]] const AffineForm& shadowForm(std::size_t corner) const {
        return walls[kFirstFaceWall + corner];
    }

    /// M_S(p): the barycentric coordinates of the shadow in its face (beyond a boundary: in the
    /// ghost face). Loses as much by rounding as the tetrahedron and the foot are stretched: up to
    /// 1e-9 of the diagonal, mostly nothing.
    [[nodiscard]] Vec3 shadow(const Vec3& p) const {
        return {shadowForm(0).at(p), shadowForm(1).at(p), shadowForm(2).at(p)};
    }

    /// What a point of the shell is, seen from the surface.
    struct Projection {
        Vec3 shadow;    ///< M_S(p), as by shadow()
        double height;  ///< f
    };

    /// Both as exact as the rounding of p allows, however the tetrahedron and the foot are
    /// stretched: a shadow within 1e-12 of the diagonal, but in full shells where fibres graze the
    /// face. The shell is the one that the cell is of. 0.3 to 0.5 us.
    [[nodiscard]] Projection project(const Shell& shell, const Vec3& p) const;

    /// d: the height relative to the surface; 0 on it, -1 at the bottom, 1 at the top. In place of
    /// (10), whose second derivative jumps at the surface, a Moebius map of [-1, 1].
    [[nodiscard]] double relativeHeight(const Vec3& p) const {
        const double w = height.at(p);
        const double surface = surfaceHeight.at(p);
        return (w - surface) / (1.0 - w * surface);
    }

    /// d exactly as in (10), never negative: linear between the surface and top or bottom.
    [[nodiscard]] double linearHeight(const Vec3& p) const {
        const double w = height.at(p);
        const double surface = surfaceHeight.at(p);
        return w >= surface ? (w - surface) / (1.0 - surface) : (surface - w) / (1.0 + surface);
    }

    [[nodiscard]] bool isSame(const ShellCell& other) const {
        return tet == other.tet && foot == other.foot && face == other.face;
    }

    /// Smallest form of the walls, or of those from firstWall on: >= 0 where the cell holds p.
    [[nodiscard]] double insideness(const Vec3& p, int firstWall = 0) const;

private:
    void setTetrahedron(const Shell& shell, int tetrahedron);
    void copyTetrahedron(const ShellCell& other);
    void shadowInOwnPrism(const Shell& shell);
    void setFoot(const Shell& shell, int tetrahedron);
    [[nodiscard]] bool setFace(const Shell& shell, int newFace);
    [[nodiscard]] double shadowRounding() const;
    [[nodiscard]] double insideFace(const std::array<double, 2>& beta) const;
    void compose();

    // Barycentrics of the prism, of slots 1 and 2, at p; with the height they are those of the
    // shadow as well.
    std::array<AffineForm, 2> beta_;
    // The same of the foot, extended beyond it, and its height.
    std::array<AffineForm, 2> footBeta_;
    AffineForm footHeight_;

    // The face in the coordinates (beta_1, beta_2): those of its first vertex, and how the
    // barycentrics of the other two and the height of the surface grow with them.
    struct Chart {
        std::array<double, 2> first{};
        std::array<std::array<double, 2>, 2> barycentric{};
        std::array<double, 2> height{};
        double firstHeight = 0.0;
    };

    Chart chart_;
};

/// The direction of the surface at a shadow, of unit length: what bending along the surface does
/// not count. In a shell of full resolution the fibre from bottom to top, interpolated between the
/// pillars (so longer ones count more, which makes it depend less on the triangulation); in a
/// simplified one, whose fibres are those of a coarser surface, the directions of the extended
/// surface.
[[nodiscard]] Vec3 directionAt(
    const Shell& shell, const ExtendedSurface& extended, const SurfacePoint& shadow
);

}  // namespace bspline_curve
