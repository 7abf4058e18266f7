// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_drawing.h"

#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "cli/described_options.h"
#include "cli/mesh_input.h"
#include "cli/nearest_word.h"
#include "cli/process_figures.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "design/designer_surface.h"
#include "field/make_field.h"
#include "filters/automatic_field.h"
#include "filters/requests.h"
#include "io/field_reader.h"
#include "io/picks_reader.h"
#include "utility/stopwatch.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

namespace bspline_curve::cli {

namespace {

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

/// Makes of the automatic field the quality of the mesh, or none; what to say of it.
std::vector<std::string> chooseField(CurveArguments& arguments, const LoadedMesh& loaded) {
    if (arguments.field != kAutomaticField) {
        return {};
    }
    if (!canBeFollowed(loaded.mesh.quality)) {
        arguments.field.clear();
        return {};
    }
    arguments.field = name(FieldKind::Quality);
    return {"the curve follows the quality of " + arguments.mesh.filename().string()};
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

}  // namespace

void checkDrawingFiles(const CurveArguments& arguments) {
    if (arguments.field != kAutomaticField && !findFieldKind(arguments.field)) {
        checkIsFile("field", arguments.field);
    }
    checkIsFile("avoid", arguments.avoid.file);
}

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

void carryOver(Inputs& inputs, const MeshRepair* repair) {
    if (repair != nullptr && !inputs.quality.empty()) {
        inputs.quality = repair->carriedOver(inputs.quality);
    }
}

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

}  // namespace bspline_curve::cli
