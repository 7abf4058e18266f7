// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check/box_tree.h"
#include "shell/check/checked_shell.h"
#include "shell/face_geometry.h"

#include <Eigen/Geometry>

namespace bspline_curve {

/// The box of some points.
[[nodiscard]] inline Eigen::AlignedBox3d boxOf(std::span<const Vec3> points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    return box;
}

/// The faces of the extended surface that a simplified shell stands for: those of the surface that
/// are not blocked, and the ghosts that some prism lists.
class CheckedSurface {
public:
    explicit CheckedSurface(const CheckedShell& shell)
        : extended_(shell.extended),
          holds_(shell.extended.faces.size(), 1),
          tree_(boxesOf(extended_)) {
        for (int f = extended_.surfaceFaceCount; f < faceCount(); ++f) {
            holds_[f] = static_cast<char>(!shell.shell.prismsOf(f).empty());
        }
        for (const int f : shell.blockedFaces) {
            if (f >= 0 && !isGhost(f)) {
                holds_[f] = 0;
            }
        }
    }

    [[nodiscard]] int faceCount() const { return static_cast<int>(extended_.faces.size()); }

    /// Whether the shell stands for a face.
    [[nodiscard]] bool holds(int face) const { return holds_[face] != 0; }

    [[nodiscard]] bool isGhost(int face) const { return face >= extended_.surfaceFaceCount; }

    /// Whether nothing that the shell stands for lies across the edge opposite to vertex k.
    [[nodiscard]] bool isBorder(int face, std::size_t k) const {
        const int there = extended_.faceNeighbours[face][k];
        return there < 0 || !holds(there);
    }

    /// Calls visit(face) for every face held whose box overlaps `box`.
    template <class Visitor>
    void forEachNear(const Eigen::AlignedBox3d& box, const Visitor& visit) const {
        tree_.forEachOverlapping(box, [&](int face) {
            if (holds(face)) {
                visit(face);
            }
        });
    }

private:
    [[nodiscard]] static std::vector<BoxTree::Box> boxesOf(const ExtendedSurface& extended) {
        std::vector<BoxTree::Box> boxes;
        for (int f = 0; f < static_cast<int>(extended.faces.size()); ++f) {
            boxes.push_back(boxOf(cornersOf(extended, f)));
        }
        return boxes;
    }

    const ExtendedSurface& extended_;
    std::vector<char> holds_;
    BoxTree tree_;
};

/// Fibres at random meet the surface once. `hasBorder` says for each prism whether the surface ends
/// in it: there they may miss it.
void checkFibres(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    const std::vector<char>& hasBorder,
    Violations violations
);

}  // namespace bspline_curve
