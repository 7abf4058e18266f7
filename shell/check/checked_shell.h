// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check_shell.h"

#include <algorithm>
#include <compare>
#include <initializer_list>

namespace bspline_curve {

/// A face of a tetrahedron by its points, ascending, and where it is: opposite to vertex k of
/// `tet`.
struct TetFace {
    Triangle points;
    int tet, k;

    auto operator<=>(const TetFace&) const = default;
};

/// The plain data of a shell (pillars, prisms, kSlabSplit) as points and tetrahedra, which is all
/// that the checks rely on. Points are numbered 3 * pillar + level.
class CheckedShell {
public:
    enum Level : signed char { Bottom, Middle, Top };

    static constexpr int kLevels = 3;

    explicit CheckedShell(const Shell& shell);

    [[nodiscard]] const Shell& shell() const { return shell_; }

    [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

    [[nodiscard]] const Vec3& point(int i) const { return points_[i]; }

    [[nodiscard]] int prismCount() const { return static_cast<int>(shell_.prisms().size()); }

    [[nodiscard]] const Prism& prism(int i) const { return shell_.prisms()[i]; }

    /// False for a blocked face, which keeps its place among the prisms of full resolution.
    [[nodiscard]] bool isPresent(int i) const {
        return prism(i).orientation != 0 || !shell_.isFullResolution();
    }

    /// The orientation of a prism's slots: from where they stand in the face in a shell of full
    /// resolution (0 where that makes no sense), else as the prism says.
    [[nodiscard]] int slotParity(int i) const;

    [[nodiscard]] std::array<int, 4> tetPoints(int tet) const;
    [[nodiscard]] std::array<Vec3, 4> tetCorners(int tet) const;

    /// The two points of the half pillar that a tetrahedron holds, lower one first: its fibres are
    /// parallel to that.
    [[nodiscard]] std::array<int, 2> halfPillar(int tet) const;

    /// Exact sign of the volume of four points.
    [[nodiscard]] int volumeSign(const std::array<int, 4>& points) const;

    /// What volumeSign must be for the points of a tetrahedron.
    [[nodiscard]] int handedness(int tet) const;

    /// All faces of all tetrahedra, so that equal ones follow each other.
    [[nodiscard]] const std::vector<TetFace>& faces() const { return faces_; }

    /// Calls visit(first, count) for each set of equal faces.
    template <class Visitor>
    void forEachFace(const Visitor& visit) const {
        for (std::size_t first = 0; first < faces_.size();) {
            std::size_t last = first + 1;
            while (last < faces_.size() && faces_[last].points == faces_[first].points) {
                ++last;
            }
            visit(first, last - first);
            first = last;
        }
    }

    /// The faces that only one tetrahedron has: top, bottom, and the walls where the shell ends.
    [[nodiscard]] std::vector<TetFace> boundary() const;

    /// Whether a face of a tetrahedron belongs to top or bottom.
    [[nodiscard]] static bool isLayer(const TetFace& face) {
        return face.k == 0 && face.tet % 3 == 2;
    }

private:
    [[nodiscard]] TetFace faceOpposite(int tet, int k) const;

    const Shell& shell_;
    std::vector<Vec3> points_;
    std::vector<TetFace> faces_;
};

/// Where a check writes what it finds.
class Violations {
public:
    Violations(InvariantCheck& check, const ShellCheckOptions& options)
        : check_(check), maxIds_(static_cast<std::size_t>(std::max(0, options.maxReportedIds))) {}

    void add(std::initializer_list<int> ids) {
        check_.holds = false;
        ++check_.violations;
        for (const int id : ids) {
            if (check_.firstIds.size() < maxIds_) {
                check_.firstIds.push_back(id);
            }
        }
    }

private:
    InvariantCheck& check_;
    std::size_t maxIds_;
};

// ---- Invariants of both forms ----

void checkTetrahedra(const CheckedShell& shell, Violations violations);
void checkLayers(const CheckedShell& shell, Violations violations);
void checkComponents(const CheckedShell& shell, Violations violations);
void checkNeighbours(const CheckedShell& shell, Violations violations);

/// Whether a vertex of the extended surface is that of the surface, or is listed as moved, or grew
/// from its boundary.
[[nodiscard]] bool isWhereItSays(
    const Surface& surface, const ExtendedSurface& extended, int vertex
);

// ---- Full resolution ----

void checkMiddleSurface(
    const CheckedShell& shell,
    const Surface& surface,
    const ExtendedSurface& extended,
    Violations violations
);
void checkPrismPerFace(
    const CheckedShell& shell,
    const Surface& surface,
    std::span<const int> blockedFaces,
    Violations violations
);

// ---- Simplified shells ----

/// Checks transversality, containment, fibres and tracking.
void checkSimplifiedShell(
    const CheckedShell& shell,
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options,
    ShellCheck& result
);

}  // namespace bspline_curve
