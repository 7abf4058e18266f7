// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve MESH --picks FILE --output FILE …: one curve through picks on a mesh.
#include "bspline_curve/files.h"
#include "cli/curve_drawing.h"
#include "cli/curve_options.h"
#include "cli/interrupt.h"
#include "cli/process_figures.h"
#include "cli/reports/curve_report.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "text/error_messages.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

// Share of the progress, up to the end of preparing the mesh.
constexpr double kPreparedShare = 0.6;

void checkFiles(const CurveArguments& arguments) {
    checkDrawingFiles(arguments);
    checkOutput(arguments.output, checkCurveExtension);
    checkOutput(arguments.report, checkReportExtension);
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Median seconds of further curves on the same shell; none where none are asked for.
std::optional<double> timeWarm(
    const CurveArguments& arguments,
    const std::vector<Vec3>& picks,
    const Workpiece& workpiece,
    const DesignedCurve& drawn,
    ProgressBar& bar
) {
    std::vector<double> times;
    const std::vector<int> corners = arguments.corners.of(picks.size());
    const std::vector<PickTangent> tangents = arguments.tangents.of(picks.size());
    const std::vector<MeshLength> tolerances = arguments.pickTolerances.within(picks.size());
    const std::vector<double> weights = arguments.pickTolerances.weights(picks.size());
    for (int i = 0; i < arguments.repeat; ++i) {
        bar.show(static_cast<double>(i) / arguments.repeat, "repeat");
        Stopwatch watch;
        static_cast<void>(workpiece.draw(
            picks,
            arguments.solver,
            arguments.sampling,
            {.field = drawn.field,
             .avoid = drawn.avoid,
             .pickTolerances = tolerances,
             .pickWeights = weights,
             .corners = corners,
             .tangents = tangents},
            [](double, const char*) { return !interrupted(); }
        ));
        times.push_back(watch.lap());
    }
    return times.empty() ? std::nullopt : std::optional(median(std::move(times)));
}

RunFigures figuresOf(
    const CurveArguments& arguments, const LoadedMesh& loaded, const DesignedCurve& drawn
) {
    const Workpiece& workpiece = *loaded.workpiece;
    RunFigures figures;
    figures.fieldSeconds = drawn.field.empty() ? 0.0 : drawn.fieldSeconds;
    figures.designSeconds = drawn.seconds;
    figures.stages = workpiece.seconds();
    figures.coldSeconds = figures.stages.validate + figures.stages.tree + figures.stages.shell +
                          figures.fieldSeconds + figures.designSeconds;
    figures.peakMemoryBytes = peakMemoryBytes();
    figures.readSeconds = loaded.readSeconds;
    figures.readMemoryBytes = loaded.readMemoryBytes;
    figures.shell = workpiece.shell();
    figures.meshFile = arguments.mesh.string();
    if (arguments.field && !drawn.field.empty()) {
        figures.field = name(arguments.field->options.kind);
        figures.fieldCost = name(drawn.field.costFor(arguments.solver.fieldCost));
    }
    figures.notes = loaded.notes();
    std::ranges::copy(figures.shell.notes, std::back_inserter(figures.notes));
    std::ranges::copy(drawn.notes, std::back_inserter(figures.notes));
    return figures;
}

std::string describeCurve(const SurfacePolyline& line) {
    return std::string(line.closed ? "a closed" : "an open") + " curve, " +
           describeNumber(lengthOf(line)) + " long, of " +
           describeCount(line.points.size(), "point", "points");
}

ExitCode drawAndWrite(
    const CurveArguments& arguments,
    const std::vector<Vec3>& picks,
    const LoadedMesh& loaded,
    ProgressBar& bar
) {
    const Workpiece& workpiece = *loaded.workpiece;
    const DesignedCurve drawn =
        drawThrough(picks, arguments, loaded, progressPart(bar, kPreparedShare, 1.0));
    const Curve& curve = drawn.curve;
    RunFigures figures = figuresOf(arguments, loaded, drawn);
    figures.warmSeconds = timeWarm(arguments, picks, workpiece, drawn, bar);
    bar.clear();
    const bool isRefused = !curve.report.usable && arguments.requireUsable;
    ResultFiles files;
    if (!arguments.report.empty()) {
        files.add(arguments.report, reportText(curve, workpiece, figures));
    }
    if (!isRefused) {
        files.add(
            arguments.output,
            curveBytes(arguments.output, curve, drawn.along, workpiece.checksum(), arguments.unit)
        );
    }
    // Why it is refused comes last, and is no note.
    const std::span<const std::string> notes = figures.notes;
    printNotes(notes.first(notes.size() - (isRefused ? 1 : 0)));
    files.commit();
    if (isRefused) {
        printError(notes.back());
    } else {
        bar.tell(arguments.output, describeCurve(curve.polyline));
    }
    return isRefused ? ExitCode::Failure : ExitCode::Success;
}

ExitCode draw(CurveArguments& arguments, ProgressBar& bar) {
    checkFiles(arguments);
    bar.show(0.0, "reading");
    const std::vector<Vec3> picks = picksFrom(arguments.picks, arguments);
    LoadedMesh loaded = loadMesh(arguments.mesh, arguments.mending.strict);
    readDrawingFiles(arguments, loaded.layer.mesh);
    loaded.prepareForCurves(arguments, arguments.noCache, progressPart(bar, 0.0, kPreparedShare));
    return drawAndWrite(arguments, picks, loaded, bar);
}

}  // namespace

ExitCode drawOn(const LoadedMesh& loaded, CurveArguments arguments) {
    constexpr bool kIsQuiet = true;  // what a job prints is a message in the table of results
    return runVerb(
        [&](ProgressBar& bar) {
            checkFiles(arguments);
            const std::vector<Vec3> picks = picksFrom(arguments.picks, arguments);
            readDrawingFiles(arguments, loaded.workpiece->mesh());
            return drawAndWrite(arguments, picks, loaded, bar);
        },
        AfterInterrupt::EndSoon,
        kIsQuiet
    );
}

ExitCode runCurve(Arguments arguments) {
    return runParsed<CurveParser>(arguments, draw);
}

}  // namespace bspline_curve::cli
