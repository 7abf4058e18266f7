// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "shell/simplify/prism_complex.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Keeps the bottom (or top) of a closed component from turning inside out in one leap: it would
/// cross nothing before and nothing after, but prisms would overlap in it. Where layers cross
/// nothing, that is so if and only if bottom and top enclose volumes of unlike sign. Both are kept
/// up to date, prism by prism.
class LayerVolumes {
public:
    /// `start` has prism i over face i of the surface's base. O(n).
    explicit LayerVolumes(const Shell& start);

    /// Enters the prism over a face of the start, which has its points and its id in the complex;
    /// by ascending ids and faces.
    void enter(const PrismComplex& complex, int prism, int face);

    /// Whether the layers stay right side out where prisms take the place of others; if so, they
    /// are taken to do that. About 20 ns per prism.
    [[nodiscard]] bool replace(
        const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
    );

    /// The id that a prism of the last replace() was given.
    void setId(int prism, std::size_t indexInFresh);

private:
    struct Volumes {
        double bottom = 0.0, top = 0.0;
    };

    struct Component {
        Vec3 origin;  // near by, for little rounding
        bool isClosed = true;
        Volumes volumes;
    };

    [[nodiscard]] Volumes volumesOf(
        const PrismComplex& complex, const Triangle& pillars, const Vec3& origin
    ) const;

    std::vector<Component> components_;
    std::vector<int> componentOf_;  // of each prism id; before enter() of each face
    std::vector<Volumes> volumes_;  // of each prism id
    std::vector<Volumes> fresh_;
    int freshComponent_ = -1;
};

}  // namespace bspline_curve
