// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/detours.h"
#include "design/surface_curves.h"
#include "surface/passages.h"
#include "surface/surface.h"
#include "surface/ways_over_faces.h"
#include "utility/threads.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// A surface joined anew for curves whose ways mending has lengthened or cut off; the last one is
/// kept. Several threads may use it at once.
class RejoinedSurfaces {
public:
    /// Refers to the surface.
    explicit RejoinedSurfaces(const Surface& surface);

    /// Whether there is nothing that a curve could pass.
    [[nodiscard]] bool empty() const { return parted_.empty(); }

    /// A leg that could be shorter.
    struct Shorter {
        int leg;
        double before, shortest;  ///< lengths; infinite before: there was no leg
        bool isOverSlit;          ///< which stays open
    };

    struct Ways {
        /// Of the legs one after the other; empty where joining anew helps none, or they have none.
        std::vector<Step> steps;
        std::vector<double> lengths;  ///< of the legs' ways, likewise
        std::vector<Shorter> shorter;
    };

    /// Those that are shorter than the legs of a curve by more than 5 %, over parted edges, and
    /// shorter than those on the surface. Looks only where such a way could be. `avoid`:
    /// see WaysOverFaces. Throws Cancelled.
    [[nodiscard]] Ways waysFor(
        const std::vector<CurveLeg>& legs, std::span<const int> avoid, const Progress& progress
    ) const;

    /// Those on the surface joined anew for some ways, which has the same input; null where a mesh
    /// with their passages is none. Throws Cancelled.
    [[nodiscard]] std::shared_ptr<const SurfaceCurves> curvesFor(
        const std::vector<Step>& steps, const ShellOptions& options, const Progress& progress
    );

private:
    [[nodiscard]] bool mayBeShorter(const CurveLeg& leg) const;
    [[nodiscard]] bool isCrossed(const Step& step, bool isSlit) const;
    [[nodiscard]] bool crosses(const FaceWay& way, bool isSlit) const;

    const Surface& surface_;
    std::vector<int> roots_;
    PartedEdges parted_;
    Mutex mutex_;
    Passages passages_;  // of the last one
    bool isOneSided_ = false;
    std::shared_ptr<const SurfaceCurves> last_;
};

/// A field of curves on a surface, for those on one that was joined anew: linear along divided
/// edges; where vertices became one, it has the value of the first face around it.
[[nodiscard]] ScalarField rejoinedField(
    const Surface& surface, const ScalarField& field, const Surface& rejoined
);

}  // namespace bspline_curve
