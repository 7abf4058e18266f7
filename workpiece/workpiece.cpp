// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/workpiece.h"

#include "utility/report_progress.h"
#include "utility/stopwatch.h"
#include "workpiece/curve_guides.h"
#include "workpiece/curve_notes.h"
#include "workpiece/layer_ids.h"

#include <utility>

namespace bspline_curve {

namespace {

constexpr double kFieldShare = 0.3;  // of drawing, for progress only

}  // namespace

Workpiece::Workpiece(TriangleMesh mesh, const PreparingOptions& options, const Progress& progress)
    : options_(options) {
    options.shell.validate();
    Stopwatch watch;
    surface_ = std::make_shared<const Surface>(std::move(mesh), options.mending, progress);
    seconds_ = watch.lap();
}

MeshChecksum Workpiece::checksum() const {
    const MutexLock lock(mutex_);
    if (!checksum_) {
        checksum_ = checksumOf(mesh());
    }
    return *checksum_;
}

std::shared_ptr<const CurveDesigner> Workpiece::sharedDesigner(
    const Progress& progress, const ShellStore* store
) const {
    const MutexLock lock(mutex_);
    if (designer_ == nullptr) {
        designer_ = std::make_shared<const CurveDesigner>(
            surface_, options_.shell, progress, store, seconds_
        );
    }
    return designer_;
}

const CurveDesigner& Workpiece::designer(const Progress& progress, const ShellStore* store) const {
    return *sharedDesigner(progress, store);
}

std::vector<std::string> Workpiece::notes(const std::string& strict) const {
    const Provenance& provenance = surface_->provenance();
    if (provenance.isIdentity()) {
        return {};
    }
    return {provenance.note() + (provenance.refusal() ? "; " + strict + " refuses it" : "")};
}

ScalarField Workpiece::field(
    const LayerInput& with, const FieldRequest& request, const Progress& progress
) const {
    return fieldOf(with, surface(), request, progress);
}

DesignedCurve Workpiece::draw(
    const std::vector<Vec3>& picks,
    const CurveOptions& options,
    const LayerInput& with,
    const Progress& progress
) const {
    Stopwatch watch;
    const CurveGuides guides =
        curveGuides(with, surface(), options, partOf(progress, 0.0, kFieldShare));
    const double fieldSeconds = watch.lap();
    const std::vector<int> corners = options.corners.of(picks.size());
    const std::vector<Vec3> tangents = options.tangents.of(picks.size());
    Curve curve = designer().design(
        picks,
        options.solver,
        options.sampling,
        {.field = guides.field, .avoid = guides.avoid, .corners = corners, .tangents = tangents},
        partOf(progress, kFieldShare, 1.0)
    );
    const double seconds = watch.lap();
    DesignedCurve drawn = finished(std::move(curve), guides.field);
    drawn.avoid = guides.avoid;
    drawn.fieldSeconds = fieldSeconds;
    drawn.seconds = seconds;
    return drawn;
}

DesignedCurve Workpiece::fit(
    const std::vector<Vec3>& line,
    const FitOptions& fit,
    const CurveOptions& options,
    const Progress& progress
) const {
    Stopwatch watch;
    DesignedCurve drawn =
        finished(designer().fit(line, fit, options.solver, options.sampling, progress), {});
    drawn.seconds = watch.lap();
    return drawn;
}

DesignedCurve Workpiece::finished(Curve curve, const ScalarField& field) const {
    DesignedCurve drawn{.curve = std::move(curve), .field = field};
    if (!field.empty()) {
        drawn.along = fieldAlong(drawn.curve.polyline, mesh().faces, field.values());
    }
    drawn.notes = notesOf(drawn.curve.report);
    return drawn;
}

std::shared_ptr<const Workpiece> workpieceOf(
    const LayerInput& layer, const PreparingOptions& options, const Progress& progress
) {
    return madeFrom(layer, [&] {
        return std::make_shared<const Workpiece>(layer.mesh, options, progress);
    });
}

}  // namespace bspline_curve
