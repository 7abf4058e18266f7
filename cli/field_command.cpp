// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve field MESH --kind KIND --output FILE …: a field on a mesh.
#include "bspline_curve/files.h"
#include "cli/described_options.h"
#include "cli/loaded_mesh.h"
#include "cli/region_options.h"
#include "cli/reports/curve_report.h"
#include "cli/reports/field_report.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "filters/requests.h"
#include "text/error_messages.h"
#include "utility/stopwatch.h"

#include <algorithm>

namespace bspline_curve::cli {

namespace {

struct FieldArguments {
    std::filesystem::path mesh, output;
    std::filesystem::path report;  ///< empty: none asked for
    std::filesystem::path region;  ///< likewise
    FieldLayerRequest request;
};

struct FieldParser {
    FieldParser() {
        addMesh(app, arguments.mesh);
        options.add("kind", {.isRequired = true});
        addOutput(
            app,
            arguments.output,
            "Field to write: .ply (the mesh with the field as per-vertex quality), .npy or .txt",
            "FILE",
            ".txt"
        );
        addReport(
            app,
            arguments.report,
            "Write minimum, mean and maximum of the field, and times, as .json"
        );
        for (const ParameterDescription& parameter : fieldFilter().parameters) {
            // The region is a selection elsewhere; here it is a file or a threshold.
            if (parameter.id != "kind" && parameter.id != "region") {
                options.add(parameter.id);
            }
        }
    }

    FieldArguments finish() {
        arguments.request = fieldRequest(options.values());
        arguments.request.region = region.choice(arguments.request.options.kind);
        arguments.region = region.file();
        return arguments;
    }

    CLI::App app{
        "Computes a field on a triangle mesh, one value per vertex, that curves can follow or "
        "avoid:\ngive it to a curve by --field, or look at it in MeshLab.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or nothing there to make the field from; 2 "
        "wrong\nusage; 130 interrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve field"
    };
    FieldArguments arguments;
    DescribedOptions options{app, fieldFilter()};
    RegionOptions region{app, kMainGroup, "--"};
};

ExitCode compute(FieldArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkFieldExtension);
    checkOutput(arguments.report, checkReportExtension);
    FieldLayerRequest& request = arguments.request;
    bar.show(0.0, "reading");
    LoadedMesh loaded = loadMesh(arguments.mesh, request.mending.strict);
    loaded.prepare({.mending = request.mending});
    bar.clear();
    printNotes(loaded.notes());
    const Workpiece& workpiece = *loaded.workpiece;
    Stopwatch watch;
    if (!arguments.region.empty()) {
        request.region.ids = regionOf(arguments.region, workpiece.mesh());
    }
    const ScalarField field = workpiece.field(loaded.layer, request, progressPart(bar, 0.0, 1.0));
    FieldRunFigures figures{
        .meshFile = arguments.mesh.string(),
        .kind = name(request.options.kind),
        .naturalCost = name(naturalCost(request.options.kind)),
        .seconds = {}
    };
    figures.seconds.read = loaded.readSeconds;
    figures.seconds.validate = workpiece.seconds().validate;
    figures.seconds.field = watch.lap();
    bar.clear();
    ResultFiles files;
    files.add(arguments.output, fieldBytes(arguments.output, workpiece.mesh(), field.values()));
    figures.seconds.write = watch.lap();
    if (!arguments.report.empty()) {
        files.add(arguments.report, fieldReportText(workpiece, field.values(), figures));
    }
    files.commit();
    const auto [least, most] = std::ranges::minmax(field.values());
    bar.tell(
        arguments.output,
        figures.kind + ", from " + describeNumber(least) + " to " + describeNumber(most)
    );
    return ExitCode::Success;
}

}  // namespace

ExitCode runField(Arguments arguments) {
    return runParsed<FieldParser>(arguments, compute);
}

}  // namespace bspline_curve::cli
