// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve field MESH --kind KIND --output FILE …: a field on a mesh.
#include "bspline_curve/error.h"
#include "cli/command.h"
#include "cli/field_options.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/progress_bar.h"
#include "cli/verb.h"
#include "field/make_field.h"
#include "io/atomic_file.h"
#include "io/field_report.h"
#include "io/field_writer.h"
#include "io/mesh_reader.h"
#include "io/report_writer.h"
#include "utility/stopwatch.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// Refuses what could only fail after the work.
void checkOutputs(const FieldArguments& arguments) {
    checkFieldExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

/// Writes field and report together: both files appear, or none.
void writeResults(
    const FieldArguments& arguments,
    const TriangleMesh& given,
    const Surface& surface,
    const std::vector<double>& field,
    FieldRunFigures& figures
) {
    Stopwatch watch;
    AtomicFile output(arguments.output, fieldBytes(arguments.output, given, field));
    figures.seconds.write = watch.lap();
    std::optional<AtomicFile> report;
    if (!arguments.report.empty()) {
        report.emplace(arguments.report, fieldReportText(surface, field, figures));
    }
    beginWriting();
    output.commit();
    if (report) {
        report->commit();
    }
}

ExitCode compute(const FieldArguments& arguments, ProgressBar& bar) {
    checkOutputs(arguments);
    FieldRunFigures figures;
    figures.meshFile = arguments.mesh.string();
    figures.kind = name(arguments.field.kind);
    figures.naturalCost = name(naturalCost(arguments.field.kind));
    bar.show(0.0, "reading");
    Stopwatch watch;
    MeshFile file = readInputMesh(arguments.mesh, arguments.mending.strict);
    figures.seconds.read = watch.lap();
    throwIfInterrupted();
    if (arguments.field.kind == FieldKind::Quality && file.quality.empty()) {
        refuseMissingQuality(arguments.mesh);
    }
    const TriangleMesh given = file.mesh;
    const auto [surface, mending] = surfaceOfMended(std::move(file.mesh), arguments.mending);
    sayMended(mending);
    figures.seconds.validate = watch.lap();
    figures.repair = reportOf(mending);
    if (mending && !file.quality.empty()) {
        file.quality = mending->repair.carriedOver(file.quality);
    }
    const Region region = readRegion(
        arguments.region,
        surface,
        {.file = arguments.mesh,
         .faces = static_cast<int>(given.faces.size()),
         .quality = file.quality,
         .repair = mending ? &mending->repair : nullptr}
    );
    std::vector<double> field = makeField(
        surface,
        arguments.field,
        {.quality = file.quality, .region = region},
        progressPart(bar, 0.0, 1.0)
    );
    figures.seconds.field = watch.lap();
    if (mending) {
        field = mending->toOrigin(std::move(field));
    }
    bar.clear();
    writeResults(arguments, given, surface, field, figures);
    return ExitCode::Success;
}

}  // namespace

ExitCode runField(Arguments arguments) {
    const auto parsed = parseFieldArguments(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& field = std::get<FieldArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return compute(field, bar); });
}

}  // namespace bspline_curve::cli
