// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve fit MESH --line FILE …: smooth curves along lines that exist.
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/lines.h"
#include "cli/described_options.h"
#include "cli/loaded_mesh.h"
#include "cli/region_options.h"
#include "cli/reports/curve_report.h"
#include "cli/reports/fit_report.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "filters/fit_requests.h"
#include "filters/polyline_layers.h"
#include "filters/requests.h"
#include "text/error_messages.h"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

// Shares of the progress, up to the end of preparing the mesh.
constexpr double kReadyShare = 0.4;

struct FitArguments : CurveOptions, PreparingOptions {
    std::filesystem::path mesh, output, report;  ///< report: empty: none asked for
    std::vector<std::filesystem::path> lines;
    std::filesystem::path selection, labels;  ///< empty: none
    std::vector<std::string> layers;
    std::optional<Vec3> direction;  ///< that lines are moved along onto the mesh
    FitOptions fit;
    LengthUnit unit = LengthUnit::Millimetre;
};

struct FitParser {
    FitParser() {
        addMesh(app, arguments.mesh);
        auto* const lines =
            app.add_option(
                   "--line",
                   arguments.lines,
                   "Lines near the mesh, each of which becomes a curve: .obj, .ply, "
                   ".dxf, .csv or .vtu. May be repeated"
            )
                ->allow_extra_args(false)
                ->type_name("FILE");
        auto* const selection = addFile(
            app,
            "--selection",
            arguments.selection,
            "The boundary of some faces: their ids from 0 on, .npy of integers or a text"
        );
        addFile(
            app,
            "--labels",
            arguments.labels,
            "All boundaries of a segmentation, each once, from junction to junction: the label of "
            "each face, a whole number, .npy or a text"
        )
            ->excludes(lines)
            ->excludes(selection);
        selection->excludes(lines);
        app.add_option(
               "--deviation",
               deviation,
               "How far from its line a curve may be anywhere: 0.4, in the mesh's unit, or 1edge, "
               "in mean edge lengths. The curve is as smooth as it can be where the line is off by "
               "about a quarter of that. Default: 1edge, and no more than the line's own noise"
        )
            ->type_name("LENGTH");
        app.add_option(
               "--corner-angle",
               arguments.fit.cornerAngle,
               "Where its line turns by so many degrees and more, a curve has a corner; jags and "
               "trembling alone make none. 180: no corners"
        )
            ->capture_default_str();
        app.add_option("--direction", direction, kDirectionHelp)->type_name("X,Y,Z")->needs(lines);
        addLayers(app, arguments.layers);
        listIn(app, kLinesGroup, {"--line", "--direction", "--selection", "--labels", "--layers"});
        addOutput(
            app,
            arguments.output,
            "Curve to write: " + curveExtensions() +
                "; where there are several, further ones are FILE-2.json, FILE-3.json, …"
        );
        addUnit(app, arguments.unit);
        addReport(
            app,
            arguments.report,
            "Write length, deviation, spline and corners of each curve, and seconds"
        );
        for (const std::string& id : fittedParameters()) {
            described.add(id);
        }
    }

    FitArguments finish() {
        if (arguments.lines.empty() && arguments.selection.empty() && arguments.labels.empty()) {
            throw CLI::ValidationError(
                "one of --line, --selection and --labels is required: there is no line"
            );
        }
        const CurveRequest request = curveRequest(described.values());
        static_cast<CurveOptions&>(arguments) = static_cast<const CurveOptions&>(request);
        static_cast<PreparingOptions&>(arguments) = static_cast<const PreparingOptions&>(request);
        if (!deviation.empty()) {
            arguments.fit.deviation = parseLength(deviation, "deviation");
            if (!(arguments.fit.deviation.value > 0.0)) {
                throw CLI::ValidationError("--deviation must be above 0");
            }
        }
        arguments.direction = Placing{.direction = direction}.projection().direction;
        arguments.fit.validate();
        return arguments;
    }

    CLI::App app{
        "Makes smooth curves of lines that are there already: jagged boundaries of labels or of "
        "selected faces,\nedge loops, strokes, polylines of any file. Nowhere is a curve farther "
        "from its line than the\ndeviation; an open one keeps its ends.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or no curve so near; 2 wrong usage; 130\n"
        "interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve fit"
    };
    FitArguments arguments;
    std::string deviation, direction;  // empty: not said
    DescribedOptions described{app, curveFilter()};
};

std::vector<LineToFit> linesOf(const FitArguments& arguments) {
    std::vector<LineToFit> lines;
    for (const std::filesystem::path& file : arguments.lines) {
        PolylineFile read = readPolylines(file, arguments.layers);
        printNotes(read.notes);
        for (std::size_t i = 0; i < read.lines.size(); ++i) {
            std::string name = file.string();
            if (read.lines.size() > 1) {
                name.insert(0, "line " + std::to_string(i + 1) + " of ");
            }
            lines.push_back({std::move(read.lines[i].points), read.lines[i].closed, name});
        }
    }
    return lines;
}

std::vector<int> labelsOf(const std::filesystem::path& file, const TriangleMesh& mesh) {
    const std::vector<std::int64_t> read = readFaceIds(file);
    if (read.size() != mesh.faces.size()) {
        throw InputError(
            InputErrorCode::BadOption,
            file.string() + " has " + describeCount(read.size(), "label", "labels") +
                ", but the mesh has " + describeCount(mesh.faces.size(), "face", "faces") +
                ": give one for each face"
        );
    }
    std::vector<int> labels;
    for (const std::int64_t label : read) {
        if (label < std::numeric_limits<int>::min() || label > std::numeric_limits<int>::max()) {
            throw InputError(
                InputErrorCode::BadOption,
                file.string() + ": label " + std::to_string(label) + " is out of range"
            );
        }
        labels.push_back(static_cast<int>(label));
    }
    return labels;
}

ExitCode fitAndWrite(FitArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkCurveExtension);
    checkOutput(arguments.report, checkReportExtension);
    bar.show(0.0, "reading");
    std::vector<LineToFit> lines = linesOf(arguments);
    LoadedMesh loaded = loadMesh(arguments.mesh, arguments.mending.strict);
    const TriangleMesh& mesh = loaded.layer.mesh;
    if (!arguments.selection.empty()) {
        lines = linesRound(mesh, regionOf(arguments.selection, mesh));
    } else if (!arguments.labels.empty()) {
        lines = linesBetween(mesh, labelsOf(arguments.labels, mesh));
    }
    loaded.prepareForCurves(arguments, true, progressPart(bar, 0.0, kReadyShare));
    const Workpiece& workpiece = *loaded.workpiece;
    if (arguments.direction) {
        DrapedLines draped = drapedLines(workpiece, lines, *arguments.direction);
        lines = std::move(draped.lines);
        printNotes(draped.notes);
    }
    const FittedLines fitted =
        fitLines(workpiece, lines, arguments.fit, arguments, progressPart(bar, kReadyShare, 1.0));
    bar.clear();
    ResultFiles files;
    std::filesystem::path last;
    std::vector<FitFigures> figures;
    for (std::size_t i = 0; i < fitted.curves.size(); ++i) {
        const DesignedCurve& drawn = fitted.curves[i];
        last = files.nextAfter(arguments.output);
        files.add(last, curveBytes(last, drawn.curve, {}, workpiece.checksum(), arguments.unit));
        figures.push_back({lines[fitted.lines[i]].name, &drawn.curve, drawn.seconds});
    }
    files.replaceSeries(arguments.output);
    if (!arguments.report.empty()) {
        files.add(arguments.report, fitReportBytes(figures, fitted.notes));
    }
    printNotes(loaded.notes());
    printNotes(fitted.notes);
    files.commit();
    printRemoved(files.stale());
    bar.tell(arguments.output, describeSeries(figures.size(), "curve", "curves", last));
    return ExitCode::Success;
}

}  // namespace

ExitCode runFit(Arguments arguments) {
    return runParsed<FitParser>(arguments, fitAndWrite);
}

}  // namespace bspline_curve::cli
