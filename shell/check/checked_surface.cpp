// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/checked_surface.h"

namespace bspline_curve {
namespace {

std::vector<char> facesHeld(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
) {
    std::vector<char> holds(extended.faces.size(), 1);
    for (std::size_t f = extended.surfaceFaceCount; f < holds.size(); ++f) {
        holds[f] = static_cast<char>(!shell.prismsOf(static_cast<int>(f)).empty());
    }
    for (const int f : blockedFaces) {
        if (f >= 0 && f < extended.surfaceFaceCount) {
            holds[f] = 0;
        }
    }
    return holds;
}

std::vector<int> indicesOf(const std::vector<char>& flags) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] != 0) {
            indices.push_back(static_cast<int>(i));
        }
    }
    return indices;
}

}  // namespace

CheckedSurface::CheckedSurface(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
)
    : extended_(extended),
      holds_(facesHeld(shell, extended, blockedFaces)),
      faces_(indicesOf(holds_)),
      tree_(boxes()) {}

std::vector<BoxTree::Box> CheckedSurface::boxes() const {
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(faces_.size());
    for (const int f : faces_) {
        boxes.push_back(boxOf(corners(f)));
    }
    return boxes;
}

}  // namespace bspline_curve
