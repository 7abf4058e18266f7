// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/field.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "bspline_curve/workpiece.h"

#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

class ShellStore;
class Surface;
class TriangleTree;

/// Draws curves on one mesh; keeps what can be used again for the next curve (tree, shell). All ids
/// are those of the mesh as it was given, whether or not it had to be mended. Several threads may
/// draw at once.
class CurveDesigner {
public:
    /// Validates the mesh (finite, oriented, two-manifold, every face with area), mended as
    /// `mending` says where it is not, and builds the shell, or takes it from `store` where one is
    /// given (null: none); a simplified shell that it has built is stored there. A local shell is
    /// built near each curve, and the whole of it with the first curve that needs it. Throws
    /// InputError, Cancelled. A local shell: O(n log n), about 0.6 us per face with two threads.
    explicit CurveDesigner(
        TriangleMesh mesh,
        const ShellOptions& options = {},
        const MendingOptions& mending = {},
        const Progress& progress = {},
        const ShellStore* store = nullptr
    );
    /// The same on a surface that is there already, which took so many seconds.
    explicit CurveDesigner(
        std::shared_ptr<const Surface> surface,
        const ShellOptions& options = {},
        const Progress& progress = {},
        const ShellStore* store = nullptr,
        double seconds = 0.0
    );
    ~CurveDesigner();
    CurveDesigner(CurveDesigner&&) noexcept;
    CurveDesigner& operator=(CurveDesigner&&) noexcept;

    /// One curve through the picks (user's unit). Throws InputError, Cancelled. A curve that did
    /// not reach its tolerance is returned, with report.usable == false.
    [[nodiscard]] Curve design(
        const std::vector<Vec3>& picks,
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const CurveInputs& inputs = {},
        const Progress& progress = {}
    ) const;

    /// A smooth curve along a line on the mesh (points in the user's unit, joined by shortest paths
    /// and, as the solver's options say, closed): edges of a mesh, a stroke, a polyline of a file.
    /// An open one keeps its ends. Its picks are points of the curve, so that one drawn through
    /// them is like it. Of the solver's options pickTolerance has no effect. Throws InputError
    /// (NoPath also where there is no smooth curve so near), Cancelled. O(n) for n points: about 50
    /// microseconds a point.
    [[nodiscard]] Curve fit(
        const std::vector<Vec3>& line,
        const FitOptions& fit = {},
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const Progress& progress = {}
    ) const;

    /// The mesh as it was given.
    [[nodiscard]] const TriangleMesh& mesh() const;
    /// What curves are drawn on, for the library's other parts; as long as the designer.
    [[nodiscard]] const Surface& surface() const;
    /// Over the faces of surface(), likewise.
    [[nodiscard]] const TriangleTree& tree() const;
    [[nodiscard]] StageSeconds seconds() const;
    [[nodiscard]] ShellSummary shell() const;

    /// What the shell looks like, for people: the whole of it, which this builds where it is local.
    [[nodiscard]] ShellLayers shellLayers() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bspline_curve
