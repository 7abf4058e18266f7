// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/simplify/creases.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// Bounds of a face in single precision, in one half of a cache line.
struct FaceBound {
    std::array<float, 3> centre{};
    float radius = 0.0F;  ///< of a ball about the centre that holds the face, rounding included
    /// Unit normal; zero where rounding leaves no direction (needles): never transversal.
    std::array<float, 3> normal{};
    float padding = 0.0F;
};

/// Margin that covers the rounding of FaceBound and of tests in single precision, in the shell's
/// frame (coordinates up to 1/2 in size).
inline constexpr float kFloatMargin = 1e-6F;

/// An extended surface renumbered along a space-filling curve, so that what is near in space is
/// near in memory. Vertices on creases come last: the split of prisms into tetrahedra follows the
/// vertex numbers, and its cells next to the middle run along the pillar that comes last.
class TrackedSurface {
public:
    /// Without bounds.
    explicit TrackedSurface(const ExtendedSurface& input);

    /// Once the start shell is there: drops what only this takes (neighbours, directions, lengths),
    /// and computes the bounds.
    void prepareForEditing();

    [[nodiscard]] const Vec3& corner(int face, std::size_t k) const {
        return extended.vertices[extended.faces[face][k]];
    }

    /// Renumbered; ghost faces last. Without what only surface points need (ghost sources, moved
    /// vertices).
    ExtendedSurface extended;
    std::vector<int> inputFaces;  ///< the face of the input for each
    Edges creases;
    std::vector<FaceBound> bounds;  ///< of each face
};

}  // namespace bspline_curve
