// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_designer.h"

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "design/parted_curves.h"
#include "design/surface_curves.h"
#include "shell/shell_layers.h"
#include "shell/shell_store.h"
#include "surface/strict_line.h"
#include "surface/weld_remedy.h"
#include "utility/stopwatch.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

// Shares of the progress for the surface, and for what comes before the shell.
constexpr double kValidShare = 0.02;
constexpr double kPreparedShare = 0.1;

}  // namespace

struct CurveDesigner::State {
    State(
        std::shared_ptr<const Surface> surface,
        const ShellOptions& options,
        const Progress& progress,
        double seconds
    )
        : curves(std::move(surface), options, progress, seconds) {
        if (curves.surface().leavesSlits() || !curves.surface().provenance().isIdentity()) {
            parted = std::make_unique<PartedCurves>(curves);
            if (parted->empty()) {
                parted.reset();
            }
        }
    }

    SurfaceCurves curves;
    std::unique_ptr<PartedCurves> parted;  ///< null: no curve need pass what is parted
};

CurveDesigner::CurveDesigner(
    TriangleMesh mesh,
    const ShellOptions& options,
    const MendingOptions& mending,
    const Progress& progress,
    const ShellStore* store
) {
    options.validate();
    Stopwatch watch;
    auto surface = std::make_shared<const Surface>(
        std::move(mesh), mending, partOf(progress, 0.0, kValidShare)
    );
    *this = CurveDesigner(
        std::move(surface), options, partOf(progress, kValidShare, 1.0), store, watch.lap()
    );
}

CurveDesigner::CurveDesigner(
    std::shared_ptr<const Surface> surface,
    const ShellOptions& options,
    const Progress& progress,
    const ShellStore* store,
    double seconds
) {
    state_ = std::make_unique<State>(
        std::move(surface), options, partOf(progress, 0.0, kPreparedShare), seconds
    );
    bspline_curve::report(progress, kPreparedShare, "building the shell");
    if (options.kind != ShellKind::Local) {
        static_cast<void>(state_->curves.wholeShell(partOf(progress, kPreparedShare, 1.0), store));
    }
}

CurveDesigner::~CurveDesigner() = default;
CurveDesigner::CurveDesigner(CurveDesigner&&) noexcept = default;
CurveDesigner& CurveDesigner::operator=(CurveDesigner&&) noexcept = default;

const TriangleMesh& CurveDesigner::mesh() const {
    return state_->curves.surface().input();
}

const Surface& CurveDesigner::surface() const {
    return state_->curves.surface();
}

const TriangleTree& CurveDesigner::tree() const {
    return state_->curves.tree();
}

StageSeconds CurveDesigner::seconds() const {
    const PreparedSurface::Seconds all = state_->curves.seconds();
    return {all.validate, all.tree, all.extended + all.wholeShell};
}

ShellSummary CurveDesigner::shell() const {
    const ObtainedShell* const whole = state_->curves.wholeShellIfBuilt();
    return whole == nullptr
               ? ShellSummary{state_->curves.options().kind, false, {}}
               : ShellSummary{state_->curves.options().kind, whole->isFromStore, whole->notes};
}

ShellLayers CurveDesigner::shellLayers() const {
    return makeShellLayers(
        state_->curves.wholeShell().build.shell, state_->curves.extended()->frame
    );
}

namespace {

/// The curve from which one may start, with the surface's own ids; none where it does not lie on
/// it.
std::optional<Curve> startOn(const Surface& surface, const Curve& start) {
    try {
        Curve own = start;
        own.polyline = strictLine(surface, std::move(own.polyline), "the start");
        return own;
    } catch (const InputError&) {
        return std::nullopt;  // it passes from sheet to sheet: the curve starts from scratch
    }
}

}  // namespace

Curve CurveDesigner::design(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Progress& progress
) const {
    const Provenance& provenance = surface().provenance();
    const Region avoid =
        makeRegion(mesh(), std::vector<std::int64_t>(inputs.avoid.begin(), inputs.avoid.end()));
    const Curve* start = inputs.start;
    std::optional<Curve> ownStart;  // where its ids are others
    if (start != nullptr && !provenance.isIdentity()) {
        ownStart = startOn(surface(), *start);
        start = ownStart ? &*ownStart : nullptr;
    }
    SolverOptions resolved = options;
    resolved.fieldCost = inputs.field.costFor(options.fieldCost);
    const CurveTask task{
        picks,
        resolved,
        sampling,
        inputs.field,
        provenance.facesFromInput(avoid),
        inputs.pickTolerances,
        inputs.pickWeights,
        inputs.corners,
        inputs.tangents,
        start,
        inputs.isPreview
    };
    try {
        Curve curve;
        if (state_->parted) {
            curve = state_->parted->design(task, avoid, progress);
        } else {
            curve = state_->curves.design(task, progress);
            provenance.bringToInput(curve);
        }
        curve.report.avoidedFaces = static_cast<int>(avoid.size());
        return curve;
    } catch (const InputError& error) {
        if (error.code() != InputErrorCode::PicksOnDifferentComponents) {
            throw;
        }
        const Remedy remedy = weldFor(surface(), tree(), picks, options.closed, progress);
        throw InputError(error.code(), error.what(), error.elements(), remedy);
    }
}

Curve CurveDesigner::fit(
    const std::vector<Vec3>& line,
    const FitOptions& fit,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const Progress& progress
) const {
    Curve curve = state_->curves.fit({line, fit, options, sampling}, progress);
    surface().provenance().bringToInput(curve);
    return curve;
}

}  // namespace bspline_curve
