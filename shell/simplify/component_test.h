// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/simplify/prism_complex.h"
#include "shell/simplify/tracked_surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Keeps components of the shell apart, and their layers right side out, where no crossing of top
/// and bottom would show it. A vertex of the surface represents each component: it stays where it
/// is and in its component, whatever becomes of the prisms. The bottom (or top) of a closed
/// component could turn inside out in one step; where layers cross nothing, that is so if and only
/// if bottom and top enclose volumes of unlike sign, which are updated prism by prism.
class ComponentTest {
public:
    /// `start` has prism i over face i of the extended surface. O(n + c log c) for c components.
    ComponentTest(const TrackedSurface& surface, const Shell& start);

    /// Enters the prism over a face of the start, which has its points and its id in the complex;
    /// by ascending ids and faces.
    void enter(const PrismComplex& complex, int prism, int face);

    /// Whether prisms may take the place of others: none of them holds the representative of
    /// another component (exact; touching counts), and the layers stay right side out. If so, they
    /// are taken to do that. O(log c + representatives between its ends along x) per prism.
    [[nodiscard]] bool replace(
        const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
    );

    /// The id that a prism of the last replace() was given.
    void setId(int prism, std::size_t indexInFresh);

private:
    struct Representative {
        Vec3 position;
        int component;
    };

    /// Six times the volumes that the layers enclose, or a part of them.
    struct Volumes {
        double bottom = 0.0, top = 0.0;
    };

    struct Component {
        Vec3 nearby;  // a point of it, for little rounding
        bool isClosed = true;
        Volumes volumes;
    };

    void findRepresentatives(const TrackedSurface& surface, const std::vector<int>& firstPrisms);
    [[nodiscard]] static Volumes volumesOf(
        const PrismComplex& complex, const Triangle& pillars, const Vec3& nearby
    );
    [[nodiscard]] bool holdsOther(const PrismComplex& complex, const Triangle& pillars) const;
    [[nodiscard]] bool keepsOrientation(
        const PrismComplex& complex, std::span<const Triangle> fresh, std::span<const int> old
    );

    std::vector<Component> components_;
    std::vector<Representative> sorted_;  // along x; empty for one component
    std::vector<int> componentOf_;        // of each prism id; before enter() of each face
    std::vector<Volumes> volumes_;        // of each prism id
    std::vector<Volumes> freshVolumes_;
    int component_ = -1;  // of the last replace()
};

}  // namespace bspline_curve
