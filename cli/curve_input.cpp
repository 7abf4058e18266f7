// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_input.h"

#include "bspline_curve/error.h"
#include "cli/curve_drawing.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/shell_cache_option.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "design/designer_surface.h"
#include "design/strict_polyline.h"
#include "filters/curve_notes.h"
#include "imprint/projected_polyline.h"
#include "io/curve_reader.h"
#include "io/polyline_reader.h"
#include "io/text_parsing.h"
#include "surface/picks.h"
#include "surface/triangle_tree.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve::cli {

namespace {

/// Projects the polylines of a file onto a surface.
std::vector<SurfacePolyline> projectedLines(
    const std::filesystem::path& file,
    const Surface& surface,
    const TriangleTree& tree,
    double distance
) {
    std::vector<SurfacePolyline> projected;
    const std::vector<SpacePolyline> lines = readPolylines(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        try {
            projected.push_back(projectedPolyline(surface, tree, lines[i], distance));
        } catch (const InputError& error) {
            const std::string which =
                lines.size() == 1 ? "" : "polyline " + std::to_string(i) + " of it ";
            throw InputError(
                error.code(),
                file.string() + ": " + which + "is not near the mesh: " + error.what() +
                    "; give the mesh that it belongs to, or a larger --max-distance",
                error.elements()
            );
        }
    }
    return projected;
}

}  // namespace

CurveInputOptions::CurveInputOptions(CLI::App& app, CurveInput& input)
    : input_(input), drawing_(app, input.drawing) {
    app.add_option("MESH", input.mesh, "Triangle mesh: .ply, .obj, .off or .stl")
        ->required()
        ->type_name("");
    app.add_option(
           "--curve",
           input.curves,
           "Curve on this mesh: .json, as this program writes it, exactly; .ply, .obj or .dxf, "
           "whose polylines are projected onto the mesh. May be given again"
    )
        ->allow_extra_args(false)
        ->type_name("FILE");
    app.add_option(
           "--picks",
           input.picks,
           "Draw a curve through these points first: .pp, .json, .mrk.json, .xyz or .csv; the "
           "options of curves say how. May be given again"
    )
        ->allow_extra_args(false)
        ->type_name("FILE");
    app.add_option(
           "--max-distance",
           input.maxDistance,
           "Refuse polylines that are farther than this from the mesh anywhere, in its unit; 0: "
           "1 % of its diagonal"
    )
        ->check(
            Interval<double>{.low = 0.0, .high = std::numeric_limits<double>::max()}.validator()
        )
        ->capture_default_str()
        ->type_name("NUMBER");
    addCacheOption(app, input.drawing.noCache);
    drawing_.addForUses("Options of curves, for --picks");
}

void CurveInputOptions::finish() {
    if (input_.curves.empty() && input_.picks.empty()) {
        throw CLI::ValidationError("--curve or --picks is required: there is no curve");
    }
    if (input_.picks.empty() && drawing_.isAnyGivenForDrawing()) {
        throw CLI::ValidationError("options of curves are for --picks, which is not given");
    }
    drawing_.finish();
    input_.drawing.mesh = input_.mesh;
}

CurvesOnMesh::CurvesOnMesh(const CurveInput& input, ProgressBar& bar, double share) {
    if (!input.picks.empty()) {
        checkDrawingFiles(input.drawing);
    }
    readMesh(input, bar, share);
    takeCurves(input);
    throwIfInterrupted();
    drawCurves(input, bar);
}

void CurvesOnMesh::readMesh(const CurveInput& input, ProgressBar& bar, double share) {
    bar.show(0.0, "reading");
    Stopwatch watch;
    if (!input.picks.empty()) {
        LoadedMesh loaded = loadMesh(input.drawing);
        seconds_.read = watch.lap();
        checksum_ = loaded.checksum;
        prepared_ = std::make_unique<PreparedMesh>(
            std::move(loaded), input.drawing, progressPart(bar, 0.0, share)
        );
        quality_ = prepared_->loaded.mesh.quality;
    } else {
        const MendingOptions& mending = input.drawing.mending;
        MeshFile file = readInputMesh(input.mesh, mending.strict);
        seconds_.read = watch.lap();
        quality_ = std::move(file.quality);
        checksum_ = checksumOf(file.mesh);
        surface_ =
            std::make_unique<const Mended<Surface>>(surfaceOfMended(std::move(file.mesh), mending));
    }
    if (const MeshRepair* const made = repair(); made != nullptr && !quality_.empty()) {
        quality_ = made->carriedOver(quality_);
    }
    seconds_.surface = watch.lap();
    throwIfInterrupted();
    if (mending()) {
        bar.clear();
        sayMended(mending());
    }
}

void CurvesOnMesh::takeCurves(const CurveInput& input) {
    Stopwatch watch;
    const double distance =
        input.maxDistance > 0.0 ? input.maxDistance : kPickReachRelative * surface().diagonal();
    std::optional<TriangleTree> made;  // where no designer has one
    const TriangleTree* tree = prepared_ ? &treeOf(prepared_->designer()) : nullptr;
    for (const std::filesystem::path& file : input.curves) {
        if (lowerCaseExtension(file) == ".json") {
            for (SurfacePolyline& line : readCurves(file, surface(), checksum_, repair())) {
                curves_.push_back(std::move(line));
            }
            seconds_.read += watch.lap();
            continue;
        }
        if (tree == nullptr) {
            tree = &made.emplace(surface().vertices(), surface().faces());
        }
        for (SurfacePolyline& line : projectedLines(file, surface(), *tree, distance)) {
            curves_.push_back(std::move(line));
        }
        seconds_.draw += watch.lap();
    }
}

void CurvesOnMesh::drawCurves(const CurveInput& input, ProgressBar& bar) {
    for (const std::filesystem::path& file : input.picks) {
        Stopwatch watch;
        CurveArguments arguments = input.drawing;
        arguments.picks = file;
        std::vector<Vec3> picks = picksFor(arguments);
        Inputs inputs = inputsFor(arguments, prepared_->loaded, std::move(picks));
        carryOver(inputs, repair());
        Drawn drawn = drawCold(arguments, inputs, *prepared_, bar);
        bar.clear();
        printNotes(inputs.notes);
        if (!drawn.curve.report.usable) {
            throw InputError(
                InputErrorCode::NoPath,
                file.string() + ": " + describeUnusable(drawn.curve.report) +
                    "; a curve that is not usable is not used"
            );
        }
        if (repair() != nullptr) {
            checkUnparted(surface(), drawn.curve.polyline, file.string());
        }
        curves_.push_back(std::move(drawn.curve.polyline));
        seconds_.draw += watch.lap();
    }
}

const Surface& CurvesOnMesh::surface() const {
    return prepared_ ? surfaceOf(prepared_->designer()) : surface_->made;
}

const std::optional<Mending>& CurvesOnMesh::mending() const {
    return prepared_ ? prepared_->mended.mending : surface_->mending;
}

}  // namespace bspline_curve::cli
