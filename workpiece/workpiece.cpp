// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/workpiece.h"

#include "bspline_curve/progress.h"
#include "surface/triangle_tree.h"
#include "utility/stopwatch.h"
#include "workpiece/curve_guides.h"
#include "workpiece/curve_notes.h"
#include "workpiece/layer_ids.h"
#include "workpiece/workpiece_parts.h"

#include <utility>

namespace bspline_curve {

namespace {

constexpr double kFieldShare = 0.3;  // of drawing, for progress only

}  // namespace

Workpiece::Parts::Parts(
    TriangleMesh mesh, const PreparingOptions& preparing, const Progress& progress
)
    : options(preparing) {
    options.shell.validate();
    Stopwatch watch;
    surface = std::make_shared<const Surface>(std::move(mesh), options.mending, progress);
    seconds = watch.lap();
}

Workpiece::Workpiece(TriangleMesh mesh, const PreparingOptions& options, const Progress& progress)
    : parts_(std::make_unique<const Parts>(std::move(mesh), options, progress)) {}

Workpiece::~Workpiece() = default;
Workpiece::Workpiece(Workpiece&&) noexcept = default;
Workpiece& Workpiece::operator=(Workpiece&&) noexcept = default;

const TriangleMesh& Workpiece::mesh() const {
    return parts_->surface->input();
}

const TriangleMesh& Workpiece::mendedMesh() const {
    return parts_->surface->mesh();
}

const PreparingOptions& Workpiece::options() const {
    return parts_->options;
}

MeshChecksum Workpiece::checksum() const {
    const MutexLock lock(parts_->mutex);
    if (!parts_->checksum) {
        parts_->checksum = checksumOf(mesh());
    }
    return *parts_->checksum;
}

double Workpiece::diagonal() const {
    return parts_->surface->diagonal();
}

double Workpiece::meanEdgeLength() const {
    return parts_->surface->averageEdgeLength();
}

int Workpiece::componentCount() const {
    return parts_->surface->componentCount();
}

const RepairReport* Workpiece::repair() const {
    return parts_->surface->provenance().report();
}

std::string Workpiece::mending() const {
    return parts_->surface->provenance().note();
}

std::shared_ptr<const CurveDesigner> sharedDesignerOf(
    const Workpiece& workpiece, const Progress& progress, const ShellStore* store
) {
    const Workpiece::Parts& parts = workpiece.parts();
    const MutexLock lock(parts.mutex);
    if (parts.designer == nullptr) {
        parts.designer = std::make_shared<const CurveDesigner>(
            parts.surface, parts.options.shell, progress, store, parts.seconds
        );
    }
    return parts.designer;
}

void Workpiece::prepare(const Progress& progress) const {
    static_cast<void>(sharedDesignerOf(*this, progress));
}

StageSeconds Workpiece::seconds() const {
    const MutexLock lock(parts_->mutex);
    return parts_->designer ? parts_->designer->seconds() : StageSeconds{parts_->seconds};
}

ShellSummary Workpiece::shell() const {
    return designerOf(*this).shell();
}

ShellLayers Workpiece::shellLayers() const {
    return designerOf(*this).shellLayers();
}

ClosestPoint Workpiece::closestPoint(const Vec3& point) const {
    const TriangleTree::Closest closest = designerOf(*this).tree().closestPoint(point);
    return {
        .place = parts_->surface->provenance().toInput(closest.point),
        .position = closest.position,
        .distance = (closest.position - point).stableNorm()  // far away squares overflow
    };
}

std::vector<std::string> Workpiece::notes(const std::string& strict) const {
    const Provenance& provenance = parts_->surface->provenance();
    if (provenance.isIdentity()) {
        return {};
    }
    return {provenance.note() + (provenance.refusal() ? "; " + strict + " refuses it" : "")};
}

ScalarField Workpiece::field(
    const LayerInput& with, const FieldRequest& request, const Progress& progress
) const {
    return fieldOf(with, *parts_->surface, request, progress);
}

DesignedCurve Workpiece::draw(
    const std::vector<Vec3>& picks,
    const CurveOptions& options,
    const LayerInput& with,
    const Progress& progress,
    const Curve* start
) const {
    Stopwatch watch;
    const CurveGuides guides =
        curveGuides(with, *parts_->surface, options, partOf(progress, 0.0, kFieldShare));
    const double fieldSeconds = watch.lap();
    const std::vector<int> corners = options.corners.of(picks.size());
    const std::vector<PickTangent> tangents = options.tangents.of(picks.size());
    const std::vector<MeshLength> tolerances = options.pickTolerances.within(picks.size());
    const std::vector<double> weights = options.pickTolerances.weights(picks.size());
    DesignedCurve drawn = draw(
        picks,
        options.solver,
        options.sampling,
        {.field = guides.field,
         .avoid = guides.avoid,
         .pickTolerances = tolerances,
         .pickWeights = weights,
         .corners = corners,
         .tangents = tangents,
         .start = start},
        partOf(progress, kFieldShare, 1.0)
    );
    drawn.fieldSeconds = fieldSeconds;
    return drawn;
}

DesignedCurve Workpiece::draw(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Progress& progress
) const {
    Stopwatch watch;
    Curve curve = designerOf(*this).design(picks, options, sampling, inputs, progress);
    const double seconds = watch.lap();
    DesignedCurve drawn = finished(std::move(curve), inputs.field);
    drawn.avoid.assign(inputs.avoid.begin(), inputs.avoid.end());
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
        finished(designerOf(*this).fit(line, fit, options.solver, options.sampling, progress), {});
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
