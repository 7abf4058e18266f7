// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/simplify/prism_complex.h"
#include "shell/simplify/tracked_surface.h"

#include <array>
#include <span>
#include <vector>

namespace bspline_curve {

/// A plane in single precision: positive beyond it.
struct FloatPlane {
    float x = 0.0F, y = 0.0F, z = 0.0F, offset = 0.0F;

    [[nodiscard]] float at(const std::array<float, 3>& p) const {
        return x * p[0] + y * p[1] + z * p[2] - offset;
    }
};

/// Decides whether prisms may take the place of others that fill the same patch of the surface:
/// every tetrahedron positive (exact), every face of the surface that meets a prism transversal to
/// its pillars with a margin and well below top and above bottom, and projections stretch nothing
/// beyond what doubles allow. Finds for each new prism the faces that may meet it. Uses the points
/// of the complex as they are now.
class PatchTest {
public:
    PatchTest(const TrackedSurface& surface, const PrismComplex& complex)
        : surface_(surface), complex_(complex) {}

    /// Whether all tetrahedra of a prism are positive (exact).
    [[nodiscard]] bool isPositive(const Triangle& pillars) const;

    /// Tests prisms against the faces that meet their patch.
    [[nodiscard]] bool accepts(std::span<const Triangle> prisms, std::span<const int> faces);

    /// After accepts(): faces that may meet prism i.
    [[nodiscard]] std::span<const int> tracked(std::size_t i) const {
        return std::span(tracked_).subspan(
            trackedFirst_[i], trackedFirst_[i + 1] - trackedFirst_[i]
        );
    }

private:
    // What the faces are compared with.
    struct Sides {
        std::array<FloatPlane, 3> walls;             // beyond a wall: disjoint
        std::array<FloatPlane, 2> layerPlanes;       // of the layers: positive outside
        std::array<std::array<Vec3, 3>, 2> layers;   // how far faces may reach up and down
        std::array<std::array<float, 3>, 6> halves;  // unit half pillars: 3 upper, 3 lower, by slot
        std::array<float, 6> leastCosines;           // between these and normals
    };

    [[nodiscard]] Sides sidesOf(const Triangle& slots, const Triangle& pillars) const;
    [[nodiscard]] bool isBeyond(int face, const FloatPlane& wall) const;
    [[nodiscard]] bool isTransversal(int face, const Triangle& slots, const Sides& sides) const;
    [[nodiscard]] bool meetsTetrahedron(int face, const Triangle& slots, int slab, int tet) const;
    [[nodiscard]] bool reaches(int face, const Sides& sides, int slab);

    const TrackedSurface& surface_;
    const PrismComplex& complex_;
    std::vector<int> tracked_;
    std::vector<int> trackedFirst_;
    std::vector<Vec3> scratch_ = std::vector<Vec3>(6);
};

}  // namespace bspline_curve
