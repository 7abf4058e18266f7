// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve imprint MESH --curve FILE …: curves as edges of the mesh.
#include "bspline_curve/files.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/verb_parser.h"
#include "text/error_messages.h"

namespace bspline_curve::cli {

namespace {

struct ImprintArguments : UseArguments {
    std::filesystem::path map;  ///< empty: none asked for
    ImprintRequest request;
};

struct ImprintParser {
    ImprintParser() {
        addMeshOutput(
            app,
            arguments.output,
            "Mesh to write: " + meshExtensions() +
                "; .ply has the part of each face as `label`, and the quality of the input"
        );
        addFile(
            app,
            "--map",
            arguments.map,
            "Write where each face, vertex and curve comes from",
            "FILE.json"
        );
        addReport(app, arguments.report, "Write counts, parts, moves and times");
        options.described.add("snap");
    }

    ImprintArguments finish() {
        options.finish();
        arguments.request = imprintRequest(options.described.values());
        return arguments;
    }

    CLI::App app{
        "Makes curves edges of the mesh. Vertices of the mesh come first, as they are; only faces "
        "that a\ncurve passes are divided. Curves may cross themselves and each other.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a curve that is not on this mesh; 2 wrong "
        "usage; 130\ninterrupted by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve imprint"
    };
    ImprintArguments arguments;
    UseOptions options{app, arguments, imprintFilter()};
};

ExitCode imprintCurves(const ImprintArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkMeshExtension);
    checkOutput(arguments.map);
    checkOutput(arguments.report);
    const ImprintedFile file = imprintedFile(arguments, arguments.request, bar);
    const ImprintedMesh& imprinted = *file.imprint.mesh;
    const MeshParts& parts = file.imprint.parts;
    bar.show(kImprintedShare, "writing");
    const MadeMesh whole = wholeMesh(file.imprint);
    ResultFiles files;
    files.add(arguments.output, file.bytesOf(arguments.output, whole));
    if (!arguments.map.empty()) {
        const std::vector<double> carried = file.qualityOf(whole);
        files.add(arguments.map, imprintMapBytes(imprinted, parts, file.quality, carried));
    }
    if (!arguments.report.empty()) {
        files.add(arguments.report, imprintReportBytes(imprinted, parts, file.figures));
    }
    bar.clear();
    files.commit();
    printNotes(file.notesFor(arguments.output));
    bar.tell(
        arguments.output,
        describeCount(parts.parts.size(), "part", "parts") + ", " +
            describeCount(whole.mesh().faces.size(), "face", "faces")
    );
    return ExitCode::Success;
}

}  // namespace

ExitCode runImprint(Arguments arguments) {
    return runParsed<ImprintParser>(arguments, imprintCurves);
}

}  // namespace bspline_curve::cli
