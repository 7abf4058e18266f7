// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve MESH --picks FILE --output FILE …: one curve through picks on a mesh.
#include "cli/command.h"
#include "cli/curve_options.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/process_figures.h"
#include "cli/progress_bar.h"
#include "cli/shell_cache_option.h"
#include "cli/verb.h"
#include "design/curve_designer.h"
#include "field/make_field.h"
#include "io/atomic_file.h"
#include "io/curve_writer.h"
#include "io/field_reader.h"
#include "io/mesh_reader.h"
#include "io/picks_reader.h"
#include "io/report_writer.h"
#include "surface/input_error.h"
#include "surface/progress.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct Inputs {
    MeshFile mesh;
    std::vector<Vec3> picks;
    std::vector<double> quality;
    int givenFaces = 0;
    std::optional<MeshRepair> repair;  ///< where it was asked for; mesh and quality are as repaired
    double readSeconds = 0.0;
    std::int64_t readMemoryBytes = 0;
};

/// Refuses what could only fail after the work.
void checkOutputs(const CurveArguments& arguments) {
    checkCurveExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

/// The values of a file, or of the mesh where they are asked for, as field or for a threshold.
std::vector<double> qualityFor(const CurveArguments& arguments, MeshFile& mesh) {
    const bool isFile = !arguments.field.empty() && !findFieldKind(arguments.field);
    if (isFile) {
        return readField(arguments.field, mesh.mesh.vertices.size());
    }
    const bool isNeeded =
        !arguments.field.empty() && arguments.fieldOptions.kind == FieldKind::Quality;
    if (isNeeded && mesh.quality.empty()) {
        refuseMissingQuality(arguments.mesh);
    }
    return std::move(mesh.quality);
}

/// Sets arguments.solver.closed as well where the picks file asks for it.
Inputs readInputs(CurveArguments& arguments) {
    Inputs inputs;
    PicksFile picks = readPicks(arguments.picks);
    inputs.picks = std::move(picks.picks);
    arguments.solver.closed = arguments.solver.closed || picks.closed.value_or(false);
    Stopwatch watch;
    inputs.mesh = readInputMesh(arguments.mesh, arguments.repair);
    inputs.readSeconds = watch.lap();
    inputs.readMemoryBytes = peakMemoryBytes();
    inputs.quality = qualityFor(arguments, inputs.mesh);
    inputs.givenFaces = static_cast<int>(inputs.mesh.mesh.faces.size());
    inputs.repair = repairIfAsked(inputs.mesh.mesh, arguments.repair);
    if (inputs.repair && !inputs.quality.empty()) {
        inputs.quality = inputs.repair->carriedOver(inputs.quality);
    }
    if (interrupted()) {
        throw Cancelled();
    }
    return inputs;
}

GivenMesh givenMesh(
    const CurveArguments& arguments, const Inputs& inputs, std::span<const double> values
) {
    return {
        .file = arguments.mesh,
        .faces = inputs.givenFaces,
        .quality = values,
        .repair = inputs.repair ? &*inputs.repair : nullptr
    };
}

/// Empty where none is asked for.
std::vector<double> makeFieldFor(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const Surface& surface,
    const Progress& progress
) {
    if (arguments.field.empty()) {
        return {};
    }
    const Region region =
        readRegion(arguments.fieldRegion, surface, givenMesh(arguments, inputs, inputs.quality));
    return makeField(
        surface, arguments.fieldOptions, {.quality = inputs.quality, .region = region}, progress
    );
}

struct Drawn {
    CurveDesigner designer;
    std::vector<double> field;
    Region avoid;
    Curve curve;
    RunFigures figures;
};

/// The first curve, with nothing kept but a stored shell, and its times.
Drawn drawCold(const CurveArguments& arguments, Inputs& inputs, ProgressBar& bar) {
    // Of a cold run; for the bar only.
    constexpr double kShellShare = 0.6;
    constexpr double kFieldShare = 0.7;
    const std::optional<ShellCache> cache = cacheUnless(arguments.noCache);
    Stopwatch cold;
    CurveDesigner designer(
        std::move(inputs.mesh.mesh),
        arguments.shell,
        progressPart(bar, 0.0, kShellShare),
        cache ? &*cache : nullptr
    );
    RunFigures figures;
    Stopwatch watch;
    std::vector<double> field = makeFieldFor(
        arguments, inputs, designer.surface(), progressPart(bar, kShellShare, kFieldShare)
    );
    figures.fieldSeconds = watch.lap();
    Region avoid = readRegion(
        arguments.avoid,
        designer.surface(),
        givenMesh(arguments, inputs, field.empty() ? inputs.quality : field)
    );
    Curve curve = designer.design(
        inputs.picks,
        arguments.solver,
        arguments.sampling,
        {.field = field, .avoid = avoid},
        progressPart(bar, kFieldShare, 1.0)
    );
    figures.designSeconds = watch.lap();
    figures.coldSeconds = cold.lap();
    figures.peakMemoryBytes = peakMemoryBytes();
    figures.readSeconds = inputs.readSeconds;
    figures.readMemoryBytes = inputs.readMemoryBytes;
    figures.stages = designer.seconds();
    figures.shell = designer.shell();
    figures.meshFile = arguments.mesh.string();
    if (inputs.repair) {
        figures.repair = inputs.repair->report;
    }
    if (!arguments.field.empty()) {
        figures.field = name(arguments.fieldOptions.kind);
        figures.fieldCost = name(arguments.solver.fieldCost);
    }
    return {
        .designer = std::move(designer),
        .field = std::move(field),
        .avoid = std::move(avoid),
        .curve = std::move(curve),
        .figures = figures
    };
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Median seconds of further curves on the same shell; none where none are asked for.
std::optional<double> timeWarm(
    const CurveArguments& arguments, const Inputs& inputs, const Drawn& drawn, ProgressBar& bar
) {
    std::vector<double> times;
    for (int i = 0; i < arguments.repeat; ++i) {
        bar.show(static_cast<double>(i) / arguments.repeat, "repeat");
        Stopwatch watch;
        static_cast<void>(drawn.designer.design(
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

std::string unusableMessage(const SolveReport& report) {
    constexpr double kMissed = 1e-9;  // of the diagonal; constraints are met to rounding
    std::ostringstream text;
    text << std::setprecision(3) << "no usable curve (" << name(report.status)
         << "): its largest distance from the mesh is " << report.maxDistance
         << " average edge lengths, the tolerance " << report.allowedDistance;
    if (report.maxPickGap > kMissed) {
        text << "; it misses a pick by " << report.maxPickGap << " of the diagonal";
    }
    text << "; try more picks, a finer mesh or a larger --distance-tolerance";
    return text.str();
}

/// The curve with the faces and barycentric coordinates of the mesh as it was given.
Curve onGivenMesh(const Curve& curve, const Inputs& inputs) {
    Curve given = curve;
    if (inputs.repair) {
        for (SurfacePoint& point : given.polyline.surfacePoints) {
            point = inputs.repair->toOrigin(point);
        }
    }
    return given;
}

/// Writes curve and report together: both files appear, or none. Of a curve that is not usable only
/// the report.
void writeResults(const CurveArguments& arguments, const Inputs& inputs, const Drawn& drawn) {
    std::optional<AtomicFile> report;
    if (!arguments.report.empty()) {
        report.emplace(
            arguments.report, reportText(drawn.curve, drawn.designer.surface(), drawn.figures)
        );
    }
    if (drawn.curve.report.usable) {
        const std::vector<double> quality =
            drawn.field.empty()
                ? std::vector<double>()
                : fieldAlong(drawn.curve.polyline, drawn.designer.surface().faces(), drawn.field);
        writeCurve(arguments.output, onGivenMesh(drawn.curve, inputs), quality);
    }
    if (report) {
        report->commit();
    }
}

ExitCode draw(CurveArguments& arguments, ProgressBar& bar) {
    checkOutputs(arguments);
    bar.show(0.0, "reading");
    Inputs inputs = readInputs(arguments);
    Drawn drawn = drawCold(arguments, inputs, bar);
    drawn.figures.warmSeconds = timeWarm(arguments, inputs, drawn, bar);
    bar.clear();
    printNotes(drawn.figures.shell.notes);
    writeResults(arguments, inputs, drawn);
    if (!drawn.curve.report.usable) {
        printError(unusableMessage(drawn.curve.report));
        return ExitCode::Failure;
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runCurve(Arguments arguments) {
    auto parsed = parseCurveArguments(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    auto& curve = std::get<CurveArguments>(parsed);
    return runVerb(curve.repair, [&](ProgressBar& bar) { return draw(curve, bar); });
}

}  // namespace bspline_curve::cli
