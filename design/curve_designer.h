// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve.h"
#include "shell/shell_layers.h"
#include "shell/shell_options.h"
#include "shell/shell_store.h"
#include "solver/options.h"
#include "surface/progress.h"
#include "surface/surface.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

struct StageSeconds {
    double validate = 0.0, tree = 0.0, shell = 0.0;  ///< once per surface
};

/// The shell that curves are sought in.
struct ShellSummary {
    ShellKind kind = ShellKind::Local;
    bool isFromStore = false;
    std::vector<std::string> notes;  ///< about the store; empty where all is well
};

/// Draws curves on one surface; keeps what can be used again for the next curve (tree, shell).
/// Several threads may draw at once.
class CurveDesigner {
public:
    /// Validates the mesh and builds the shell, or takes it from `store` where one is given (null:
    /// none); a simplified shell that it has built is stored there. A local shell is built near
    /// each curve, and the whole of it with the first curve that needs it. Throws InputError,
    /// Cancelled. A local shell: O(n log n), about 0.6 us per face with two threads.
    explicit CurveDesigner(
        TriangleMesh mesh,
        const ShellOptions& options = {},
        const Progress& progress = {},
        const ShellStore* store = nullptr
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

    /// The polyline of a curve of this designer at another sampling, without solving again.
    /// `avoid`: what the curve was drawn to avoid.
    [[nodiscard]] SurfacePolyline resample(
        const Curve& curve, const SamplingOptions& sampling, std::span<const int> avoid = {}
    ) const;

    [[nodiscard]] const Surface& surface() const;
    [[nodiscard]] StageSeconds seconds() const;
    [[nodiscard]] ShellSummary shell() const;

    /// What the shell looks like, for people: the whole of it, which this builds where it is local.
    [[nodiscard]] ShellLayers shellLayers() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bspline_curve
