// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve MESH --picks FILE --output FILE …: one curve through picks on a mesh.
#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/curve_drawing.h"
#include "cli/curve_options.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/prepared_mesh.h"
#include "cli/progress_bar.h"
#include "cli/shell_cache_option.h"
#include "cli/verb.h"
#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "filters/curve_notes.h"
#include "filters/requests.h"
#include "io/atomic_file.h"
#include "io/curve_writer.h"
#include "io/field_reader.h"
#include "io/report_writer.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// Refuses what could only fail after the work.
void checkFiles(const CurveArguments& arguments) {
    checkDrawingFiles(arguments);
    checkCurveExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Median seconds of further curves on the same shell; none where none are asked for.
std::optional<double> timeWarm(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const CurveDesigner& designer,
    const Drawn& drawn,
    ProgressBar& bar
) {
    std::vector<double> times;
    for (int i = 0; i < arguments.repeat; ++i) {
        bar.show(static_cast<double>(i) / arguments.repeat, "repeat");
        Stopwatch watch;
        static_cast<void>(designer.design(
            inputs.picks,
            arguments.solver,
            arguments.sampling,
            {.field = drawn.field, .avoid = drawn.avoid},
            [](double, const char*) { return !interrupted(); }
        ));
        times.push_back(watch.lap());
    }
    return times.empty() ? std::nullopt : std::optional(median(std::move(times)));
}

/// The curve with the faces and barycentric coordinates of the mesh as it was given.
Curve onGivenMesh(const Curve& curve, const MeshRepair* repair) {
    Curve given = curve;
    bringBack(given, repair);
    return given;
}

/// Writes curve and report together: both files appear, or none. Only the report of a curve that is
/// not usable, where that is required.
void writeResults(
    const CurveArguments& arguments,
    const PreparedMesh& prepared,
    const Drawn& drawn,
    const Curve& given
) {
    const Surface& surface = surfaceOf(prepared.designer());
    std::optional<AtomicFile> report;
    if (!arguments.report.empty()) {
        report.emplace(arguments.report, reportText(given, surface, drawn.figures));
    }
    beginWriting();
    if (given.report.usable || !arguments.requireUsable) {
        const std::vector<double> quality =
            drawn.field.empty() ? std::vector<double>()
                                : fieldAlong(drawn.curve.polyline, surface.faces(), drawn.field);
        writeCurve(arguments.output, given, quality, prepared.loaded.checksum);
    }
    if (report) {
        report->commit();
    }
}

ExitCode drawAndWrite(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const PreparedMesh& prepared,
    ProgressBar& bar
) {
    Drawn drawn = drawCold(arguments, inputs, prepared, bar);
    drawn.figures.warmSeconds = timeWarm(arguments, inputs, prepared.designer(), drawn, bar);
    bar.clear();
    const Curve given = onGivenMesh(drawn.curve, prepared.mended.repair());
    printNotes(inputs.notes);
    printNotes(drawn.figures.shell.notes);
    if (!given.report.repeatedPicks.empty()) {
        printError("note: " + describeRepeatedPicks(given.report));
    }
    if (given.report.fieldShare < 1.0) {
        printError("note: " + describeWeakenedField(given.report));
    }
    writeResults(arguments, prepared, drawn, given);
    if (given.report.usable) {
        return ExitCode::Success;
    }
    const std::string why = describeUnusable(given.report);
    printError(arguments.requireUsable ? why : "note: " + why);
    return arguments.requireUsable ? ExitCode::Failure : ExitCode::Success;
}

ExitCode draw(CurveArguments& arguments, ProgressBar& bar) {
    checkFiles(arguments);
    bar.show(0.0, "reading");
    std::vector<Vec3> picks = picksFor(arguments);
    LoadedMesh loaded = loadMesh(arguments);
    Inputs inputs = inputsFor(arguments, loaded, std::move(picks));
    const PreparedMesh prepared(std::move(loaded), arguments, progressPart(bar, 0.0, kShellShare));
    bar.clear();
    sayMended(prepared.mended.mending);
    carryOver(inputs, prepared.mended.repair());
    return drawAndWrite(arguments, inputs, prepared, bar);
}

}  // namespace

ExitCode drawOn(const PreparedMesh& prepared, CurveArguments arguments) {
    return runVerb([&](ProgressBar& bar) {
        checkFiles(arguments);
        Inputs inputs = inputsFor(arguments, prepared.loaded, picksFor(arguments));
        sayMended(prepared.mended.mending);
        carryOver(inputs, prepared.mended.repair());
        return drawAndWrite(arguments, inputs, prepared, bar);
    });
}

ExitCode runCurve(Arguments arguments) {
    auto parsed = parseCurveArguments(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    auto& curve = std::get<CurveArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return draw(curve, bar); });
}

}  // namespace bspline_curve::cli
