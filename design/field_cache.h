// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "design/field_travel.h"
#include "shell/extended_surface.h"
#include "solver/field_cost.h"
#include "surface/surface.h"
#include "utility/threads.h"

#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

/// A field that was found to be finite, and what curves ask of all its values.
struct ValidatedField {
    std::vector<double>
        values;  ///< I at each vertex of the extended surface: the surface's, then ghosts
    std::vector<double> vertexCosts;  ///< c(I) at each vertex of the surface
    FieldCosts costs;                 ///< of vertexCosts
    double leastOfFaces = 0.0;        ///< mean of c in the cheapest face

    /// How paths follow `share` of the field: a unit of length costs 1 in the cheapest face, and
    /// more with mu and c. Empty where the field has no say. Refers to this.
    [[nodiscard]] FieldTravel travel(const SolverOptions& options, double share) const;
};

/// `field`: one value per vertex. Throws InputError (BadField) where one or its cost is not finite,
/// naming vertices of the surface's input. O(#V).
[[nodiscard]] ValidatedField validateField(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const double> field,
    FieldCost cost
);

/// Keeps the last field that was checked, so that further curves under the same values only compare
/// them. Many threads may ask at once.
class FieldCache {
public:
    /// See validateField; no field (null) costs nothing, nor does one that was kept.
    [[nodiscard]] std::shared_ptr<const ValidatedField> find(
        const Surface& surface,
        const ExtendedSurface& extended,
        const std::shared_ptr<const std::vector<double>>& field,
        FieldCost cost
    );

private:
    Mutex mutex_;
    FieldCost cost_ = FieldCost::Identity;
    std::shared_ptr<const std::vector<double>> field_;
    std::shared_ptr<const ValidatedField> kept_;
};

}  // namespace bspline_curve
