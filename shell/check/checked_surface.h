// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check/box_tree.h"
#include "shell/check/checked_shell.h"

namespace bspline_curve {

/// The faces of the extended surface that a simplified shell stands for: those of the surface that
/// are not blocked, and the ghosts that some prism lists.
class CheckedSurface {
public:
    CheckedSurface(
        const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
    );

    [[nodiscard]] const ExtendedSurface& extended() const { return extended_; }

    [[nodiscard]] int faceCount() const { return static_cast<int>(extended_.faces.size()); }

    /// Whether the shell stands for a face.
    [[nodiscard]] bool holds(int face) const { return holds_[face] != 0; }

    [[nodiscard]] bool isBlocked(int face) const {
        return face < extended_.surfaceFaceCount && !holds(face);
    }

    [[nodiscard]] bool isGhost(int face) const { return face >= extended_.surfaceFaceCount; }

    [[nodiscard]] std::array<Vec3, 3> corners(int face) const {
        const Triangle& t = extended_.faces[face];
        const auto vertex = [&](int v) { return extended_.vertices[v]; };
        return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
    }

    /// Whether nothing that the shell stands for lies across the edge opposite to vertex k.
    [[nodiscard]] bool isBorder(int face, std::size_t k) const {
        const int there = extended_.faceNeighbours[face][k];
        return there < 0 || !holds(there);
    }

    /// Calls visit(face) for every face held whose box overlaps `box`.
    template <class Visitor>
    void forEachNear(const BoxTree::Box& box, const Visitor& visit) const {
        tree_.forEachOverlapping(box, [&](int i) { visit(faces_[i]); });
    }

private:
    [[nodiscard]] std::vector<BoxTree::Box> boxes() const;

    const ExtendedSurface& extended_;
    std::vector<char> holds_;
    std::vector<int> faces_;  ///< those held, ascending
    BoxTree tree_;
};

/// The box of some points.
template <std::size_t Count>
[[nodiscard]] BoxTree::Box boxOf(const std::array<Vec3, Count>& points) {
    BoxTree::Box box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    return box;
}

/// No face of the surface meets top, bottom or the walls where the shell ends; tracked ghosts meet
/// neither top nor bottom. A face may share corners with a wall: vertices that are the middles of
/// its pillars.
void checkContainment(
    const CheckedShell& shell, const CheckedSurface& surface, Violations violations
);

/// Fibres at random meet the surface once. `hasBorder` says for each prism whether the surface ends
/// in it: there they may miss it.
void checkFibres(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    const std::vector<char>& hasBorder,
    const ShellCheckOptions& options,
    Violations violations
);

}  // namespace bspline_curve
