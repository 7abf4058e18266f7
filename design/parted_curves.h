// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/rejoined_surfaces.h"
#include "design/surface_curves.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Curves on a surface on which mending has parted faces or left slits. Several threads may draw at
/// once.
class PartedCurves {
public:
    /// Refers to the curves on the surface as it is.
    explicit PartedCurves(const SurfaceCurves& curves)
        : curves_(curves), rejoined_(curves.surface()) {}

    /// Whether nothing is parted that a curve could pass.
    [[nodiscard]] bool empty() const { return rejoined_.empty(); }

    /// As SurfaceCurves::design(), but over edges where mending has parted faces where that is
    /// shorter; starts from no other curve there. `avoid`: as the task's, of the surface's input,
    /// which the ids of the curve are of.
    [[nodiscard]] Curve design(
        const CurveTask& task, std::span<const int> avoid, const Progress& progress
    );

private:
    [[nodiscard]] std::optional<Curve> designRejoined(
        const std::vector<Step>& steps,
        const CurveTask& task,
        std::span<const int> avoid,
        const Progress& progress
    );

    const SurfaceCurves& curves_;
    RejoinedSurfaces rejoined_;
};

}  // namespace bspline_curve
