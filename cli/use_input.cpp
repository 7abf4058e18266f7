// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/use_input.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/interrupt.h"
#include "cli/verb_parser.h"
#include "filters/part_colours.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"
#include "utility/stopwatch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace bspline_curve::cli {

namespace {

/// Vertices that a format moves by more, relative to the diagonal, are told.
constexpr double kToldMoveRelative = 1e-6;
constexpr const char* kLargerDistance = "a larger --max-distance";

void take(
    CurvesOnMesh& taken,
    const std::filesystem::path& file,
    SurfacePolyline line,
    std::optional<SplineData> spline
) {
    taken.lines.push_back(std::move(line));
    taken.splines.push_back(std::move(spline));
    taken.files.push_back(file);
}

void readLines(CurvesOnMesh& taken, const UseArguments& arguments, const Placing& placing) {
    Stopwatch watch;
    const Workpiece& workpiece = taken.workpiece();
    CurveFileReader curves(
        workpiece,
        {.projection = placing.projection(), .layers = arguments.layers, .remedy = kLargerDistance}
    );
    for (const std::filesystem::path& file : arguments.curves) {
        CurvesOfFile read = curves.read(file);
        printNotes(read.notes);
        for (std::size_t i = 0; i < read.lines.size(); ++i) {
            take(taken, file, std::move(read.lines[i]), std::move(read.splines[i]));
        }
        const bool isExact = lowerCaseExtension(file) == ".json";
        (isExact ? taken.readSeconds : taken.drawSeconds) += watch.lap();
    }
}

void drawLines(
    CurvesOnMesh& taken, const DrawingArguments& asked, const UseArguments& all, ProgressBar& bar
) {
    Stopwatch watch;
    for (const std::filesystem::path& file : all.picks) {
        DrawingArguments arguments = asked;  // what one file says is not of the next
        const std::vector<Vec3> picks = picksFrom(file, arguments);
        DesignedCurve drawn =
            drawThrough(picks, arguments, taken.loaded, progressPart(bar, 0.0, 1.0));
        bar.clear();
        if (!drawn.curve.report.usable) {
            throw InputError(
                InputErrorCode::NoPath,
                file.string() + ": " + drawn.notes.back() +
                    "; a curve that is not usable is not used"
            );
        }
        printNotes(drawn.notes);
        take(taken, file, std::move(drawn.curve.polyline), std::move(drawn.curve.spline));
    }
    taken.drawSeconds += watch.lap();
}

}  // namespace

UseOptions::UseOptions(CLI::App& app, UseArguments& arguments, const FilterDescription& filter)
    : described(app, filter), arguments_(arguments), drawing_(app, arguments.drawing) {
    addMesh(app, arguments.drawing.mesh);
    for (const auto& [flag, files, help] :
         {std::tuple(
              "--curve",
              &arguments.curves,
              std::string(
                  "Curve on this mesh: .json, .ply, .csv or .vtu, as this program writes it, "
                  "exactly; "
                  "other .ply, .obj, .dxf, .csv and .vtu are projected onto the mesh. May be "
                  "repeated"
              )
          ),
          std::tuple(
              "--picks",
              &arguments.picks,
              "Draw a curve through these points first: " + std::string(kPicksExtensions) +
                  "; the options of curves say how. May be repeated"
          )}) {
        orStandardStream(app.add_option(flag, *files, help), ".json")
            ->allow_extra_args(false)
            ->type_name("FILE");
    }
    described.add(
        "max_distance",
        {.help = "Refuse polylines that are farther than this from the mesh anywhere, in its "
                 "unit; 0: 1 % of its diagonal, along --direction any distance"}
    );
    described.add("direction", {.otherType = "X,Y,Z", .help = kDirectionHelp});
    addLayers(app, arguments.layers);
    listIn(app, kLinesGroup, {"--curve", "--picks", "--max-distance", "--direction", "--layers"});
    addCacheOption(app, arguments.drawing.noCache);
    drawing_.add(kDrawingGroup);
}

void UseOptions::finish() {
    if (arguments_.curves.empty() && arguments_.picks.empty()) {
        throw CLI::ValidationError("--curve or --picks is required: there is no curve");
    }
    if (arguments_.picks.empty() && drawing_.isAnyGivenForDrawing()) {
        throw CLI::ValidationError("options of curves are for --picks: name its file");
    }
    drawing_.finish();
}

CurvesOnMesh curvesOnMesh(
    const UseArguments& arguments, const Placing& placing, ProgressBar& bar, double share
) {
    bar.show(0.0, "reading");
    DrawingArguments drawing = arguments.drawing;
    CurvesOnMesh taken{.loaded = {}, .lines = {}, .splines = {}, .files = {}};
    LoadedMesh& loaded = taken.loaded;
    if (!arguments.picks.empty()) {
        checkDrawingFiles(drawing);
    }
    loaded = loadMesh(drawing.mesh, drawing.mending.strict);
    taken.readSeconds = loaded.readSeconds;
    Stopwatch watch;
    if (arguments.picks.empty()) {
        loaded.prepare(drawing, progressPart(bar, 0.0, share));
    } else {
        readDrawingFiles(drawing, loaded.layer.mesh);
        loaded.prepareForCurves(drawing, drawing.noCache, progressPart(bar, 0.0, share));
    }
    taken.surfaceSeconds = watch.lap();
    bar.clear();
    printNotes(loaded.notes());
    readLines(taken, arguments, placing);
    throwIfInterrupted();
    drawLines(taken, drawing, arguments, bar);
    return taken;
}

void checkHoldsLabels(const std::filesystem::path& file) {
    if (lowerCaseExtension(file) != ".ply") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": labels of faces are written as .ply; change the name's end"
        );
    }
}

std::vector<double> ImprintedFile::qualityOf(const MadeMesh& made) const {
    return quality.empty() ? std::vector<double>() : made.carried(quality);
}

std::string ImprintedFile::bytesOf(
    const std::filesystem::path& file, const MadeMesh& made, bool coloured
) const {
    std::vector<std::array<std::uint8_t, 3>> colours;
    if (coloured) {
        for (const int label : made.labels()) {
            colours.push_back(partColour(label));
        }
    }
    const std::vector<double> carried = qualityOf(made);
    const MeshExtras carriedOver = carriedExtras(extras, made, faces);
    return meshBytes(
        file,
        made.mesh(),
        {.vertexQuality = carried,
         .faceLabels = made.labels(),
         .faceColours = colours,
         .extras = &carriedOver}
    );
}

std::vector<std::string> ImprintedFile::notesFor(const std::filesystem::path& file) const {
    std::vector<std::string> notes;
    const std::string lost = lostExtras(file, extras);
    if (!lost.empty()) {
        notes.push_back(
            file.string() + " does not hold " + lost + " of the input; .ply and .obj hold more"
        );
    }
    const double moved = largestMoveIn(file, imprint.mesh->mesh);
    if (moved > kToldMoveRelative * diagonal) {
        notes.push_back(
            file.string() + " holds floats, which move vertices by up to " + describeNumber(moved) +
            "; write .ply, or move the mesh nearer to the origin"
        );
    }
    return notes;
}

ImprintedFile imprintedFile(
    const UseArguments& arguments, const ImprintRequest& request, ProgressBar& bar, double stroke
) {
    constexpr double kReadShare = 0.4;
    CurvesOnMesh read = curvesOnMesh(arguments, request.use.placing, bar, kReadShare);
    const Workpiece& workpiece = *read.loaded.workpiece;
    const Progress step = progressPart(bar, kReadShare, kImprintedShare);
    ImprintedFile result{
        .imprint = stroke > 0.0 ? strokesOn(workpiece, read.lines, stroke, request.imprint, step)
                                : imprintOn(workpiece, read.lines, request.imprint, step),
        .quality = std::move(read.loaded.layer.quality),
        .extras = readMeshExtras(arguments.drawing.mesh),
        .faces = read.workpiece().mesh().faces,
        .diagonal = read.workpiece().diagonal(),
        .figures = {}
    };
    result.figures = {
        .readSeconds = read.readSeconds,
        .surfaceSeconds = read.surfaceSeconds,
        .drawSeconds = read.drawSeconds,
        .imprintSeconds = result.imprint.seconds,
        .snap = request.imprint.snap,
        .repair = read.workpiece().repair()
    };
    return result;
}

}  // namespace bspline_curve::cli
