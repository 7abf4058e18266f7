// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve MESH --picks FILE --output FILE …: one curve through picks on a mesh.
#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/curve_options.h"
#include "cli/described_options.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/nearest_word.h"
#include "cli/prepared_mesh.h"
#include "cli/process_figures.h"
#include "cli/progress_bar.h"
#include "cli/shell_cache_option.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "design/designer_surface.h"
#include "field/make_field.h"
#include "filters/automatic_field.h"
#include "filters/curve_notes.h"
#include "filters/mended_layer.h"
#include "filters/requests.h"
#include "io/atomic_file.h"
#include "io/curve_writer.h"
#include "io/field_reader.h"
#include "io/mesh_reader.h"
#include "io/picks_reader.h"
#include "io/report_writer.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

// Shares of the progress of a curve: up to the end of preparing the mesh, and of the field.
constexpr double kShellShare = 0.6;
constexpr double kFieldShare = 0.7;

/// What a curve is drawn by, besides the mesh.
struct Inputs {
    std::vector<Vec3> picks;
    std::vector<double> quality;  ///< of the mesh as given, then as mended
    std::vector<std::string> notes;
};

/// Refuses a word of an option that is neither one of its words nor a file.
void checkIsFile(std::string_view option, const std::filesystem::path& word) {
    if (word.empty() || std::filesystem::exists(word)) {
        return;
    }
    const std::vector<std::string> words = curveFilter().parameter(option).optionIds(false);
    throw InputError(
        InputErrorCode::UnreadableFile,
        flagOf(option) + " " + word.string() + ": there is no such file, and it is none of " +
            joined(words) + didYouMean(word.string(), words)
    );
}

/// Refuses what could only fail after the work.
void checkFiles(const CurveArguments& arguments) {
    if (arguments.field != kAutomaticField && !findFieldKind(arguments.field)) {
        checkIsFile("field", arguments.field);
    }
    checkIsFile("avoid", arguments.avoid.file);
    checkCurveExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

/// Makes of a field that nobody chose the quality of the mesh, or none; what to say of it.
std::vector<std::string> chooseField(CurveArguments& arguments, const LoadedMesh& loaded) {
    if (arguments.field != kAutomaticField) {
        return {};
    }
    if (!isFollowedUnasked(loaded.mesh.quality)) {
        arguments.field.clear();
        return {};
    }
    arguments.field = name(FieldKind::Quality);
    return {
        "the curve follows the quality of " + arguments.mesh.filename().string() +
        "; --field none draws it without"
    };
}

/// The values of a file, or of the mesh where they are asked for, as field or for a threshold.
std::vector<double> qualityFor(const CurveArguments& arguments, const LoadedMesh& loaded) {
    const bool isFile = !arguments.field.empty() && !findFieldKind(arguments.field);
    if (isFile) {
        return readField(arguments.field, loaded.givenVertices);
    }
    const bool isNeeded =
        !arguments.field.empty() && arguments.fieldOptions.kind == FieldKind::Quality;
    if (isNeeded && loaded.mesh.quality.empty()) {
        refuseMissingQuality(arguments.mesh);
    }
    return loaded.mesh.quality;
}

/// Sets arguments.solver.closed as well where the picks file asks for it.
std::vector<Vec3> picksFor(CurveArguments& arguments) {
    PicksFile picks = readPicks(arguments.picks);
    arguments.solver.closed = arguments.solver.closed || picks.closed.value_or(false);
    return std::move(picks.picks);
}

Inputs inputsFor(CurveArguments& arguments, const LoadedMesh& loaded, std::vector<Vec3> picks) {
    Inputs inputs{
        .picks = std::move(picks), .quality = {}, .notes = chooseField(arguments, loaded)
    };
    inputs.quality = qualityFor(arguments, loaded);
    return inputs;
}

/// Says what was mended, if anything, and carries the inputs over to the mended mesh.
void carryOver(Inputs& inputs, const Mended<CurveDesigner>& mended) {
    sayMended(mended.mending);
    if (mended.mending && !inputs.quality.empty()) {
        inputs.quality = mended.mending->repair.carriedOver(inputs.quality);
    }
}

GivenMesh givenMesh(
    const CurveArguments& arguments, const PreparedMesh& prepared, std::span<const double> values
) {
    return {
        .file = arguments.mesh,
        .faces = static_cast<int>(prepared.loaded.givenFaces),
        .quality = values,
        .repair = prepared.mended.repair()
    };
}

/// Empty where none is asked for.
std::vector<double> makeFieldFor(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const PreparedMesh& prepared,
    const Progress& progress
) {
    if (arguments.field.empty()) {
        return {};
    }
    const Surface& surface = surfaceOf(prepared.designer());
    const Region region =
        readRegion(arguments.fieldRegion, surface, givenMesh(arguments, prepared, inputs.quality));
    return makeField(
        surface, arguments.fieldOptions, {.quality = inputs.quality, .region = region}, progress
    );
}

struct Drawn {
    std::vector<double> field;
    Region avoid;
    Curve curve;
    RunFigures figures;
};

/// The first curve, and the times of all that led to it.
Drawn drawCold(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const PreparedMesh& prepared,
    ProgressBar& bar
) {
    const LoadedMesh& loaded = prepared.loaded;
    const CurveDesigner& designer = prepared.designer();
    Drawn drawn;
    RunFigures& figures = drawn.figures;
    Stopwatch watch;
    drawn.field =
        makeFieldFor(arguments, inputs, prepared, progressPart(bar, kShellShare, kFieldShare));
    figures.fieldSeconds = arguments.field.empty() ? 0.0 : watch.lap();
    drawn.avoid = readRegion(
        arguments.avoid,
        surfaceOf(designer),
        givenMesh(arguments, prepared, drawn.field.empty() ? inputs.quality : drawn.field)
    );
    drawn.curve = designer.design(
        inputs.picks,
        arguments.solver,
        arguments.sampling,
        {.field = drawn.field, .avoid = drawn.avoid},
        progressPart(bar, kFieldShare, 1.0)
    );
    figures.designSeconds = watch.lap();
    figures.coldSeconds = prepared.seconds + figures.fieldSeconds + figures.designSeconds;
    figures.peakMemoryBytes = peakMemoryBytes();
    figures.readSeconds = loaded.readSeconds;
    figures.readMemoryBytes = loaded.readMemoryBytes;
    figures.stages = designer.seconds();
    figures.shell = designer.shell();
    figures.meshFile = arguments.mesh.string();
    figures.repair = reportOf(prepared.mended.mending);
    if (!arguments.field.empty()) {
        figures.field = name(arguments.fieldOptions.kind);
        figures.fieldCost = name(arguments.solver.fieldCost);
    }
    return drawn;
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
    if (repair != nullptr) {
        bringBack(given.polyline, *repair);
    }
    return given;
}

/// Writes curve and report together: both files appear, or none. Only the report of a curve that is
/// not usable, where that is required.
void writeResults(
    const CurveArguments& arguments, const PreparedMesh& prepared, const Drawn& drawn
) {
    const Surface& surface = surfaceOf(prepared.designer());
    std::optional<AtomicFile> report;
    if (!arguments.report.empty()) {
        report.emplace(arguments.report, reportText(drawn.curve, surface, drawn.figures));
    }
    if (drawn.curve.report.usable || !arguments.requireUsable) {
        const std::vector<double> quality =
            drawn.field.empty() ? std::vector<double>()
                                : fieldAlong(drawn.curve.polyline, surface.faces(), drawn.field);
        writeCurve(
            arguments.output,
            onGivenMesh(drawn.curve, prepared.mended.repair()),
            quality,
            prepared.loaded.checksum
        );
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
    printNotes(inputs.notes);
    printNotes(drawn.figures.shell.notes);
    if (!drawn.curve.report.repeatedPicks.empty()) {
        printError("note: " + describeRepeatedPicks(drawn.curve.report));
    }
    writeResults(arguments, prepared, drawn);
    if (drawn.curve.report.usable) {
        return ExitCode::Success;
    }
    const std::string why = describeUnusable(drawn.curve.report);
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
    carryOver(inputs, prepared.mended);
    return drawAndWrite(arguments, inputs, prepared, bar);
}

}  // namespace

ExitCode drawOn(const PreparedMesh& prepared, CurveArguments arguments) {
    return runVerb([&](ProgressBar& bar) {
        checkFiles(arguments);
        Inputs inputs = inputsFor(arguments, prepared.loaded, picksFor(arguments));
        carryOver(inputs, prepared.mended);
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
