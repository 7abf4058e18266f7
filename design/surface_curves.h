// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/field.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/tangent.h"
#include "design/field_cache.h"
#include "design/prepared_surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// What one curve is drawn by, with the ids of the surface that it is drawn on.
struct CurveTask {
    const std::vector<Vec3>& picks;
    const SolverOptions& options;
    const SamplingOptions& sampling;
    ScalarField field;
    Region avoid;
    std::span<const MeshLength> pickTolerances;  ///< see CurveInputs
    std::span<const double> pickWeights;         ///< likewise
    std::span<const int> corners;                ///< likewise
    std::span<const PickTangent> tangents;       ///< likewise
    const Curve* start;                          ///< see CurveInputs; null: none
    bool isPreview;                              ///< likewise
};

/// What one curve is fitted by.
struct LineTask {
    const std::vector<Vec3>& line;
    const FitOptions& fit;
    const SolverOptions& options;
    const SamplingOptions& sampling;
};

/// Draws curves on one surface as it is. Several threads may draw at once.
class SurfaceCurves : public PreparedSurface {
public:
    using PreparedSurface::PreparedSurface;

    /// As CurveDesigner::design(), on the components that there are. The curve has the surface's
    /// own ids; its report does not say how many faces of the input it avoids.
    [[nodiscard]] Curve design(const CurveTask& task, const Progress& progress) const;

    /// As CurveDesigner::fit(), likewise.
    [[nodiscard]] Curve fit(const LineTask& task, const Progress& progress) const;

private:
    mutable FieldCache fieldCache_;
};

}  // namespace bspline_curve
