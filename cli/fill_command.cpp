// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve fill MESH --output FILE …: the holes that a mesh has, closed.
#include "bspline_curve/files.h"
#include "cli/described_options.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/verb_parser.h"
#include "text/error_messages.h"
#include "utility/stopwatch.h"

#include <optional>
#include <string_view>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct FillArguments : UseArguments {
    FillRequest request;
    std::optional<Vec3> seed;
};

struct FillParser {
    FillParser() {
        addMesh(app, arguments.drawing.mesh);
        addMeshOutput(
            app,
            arguments.output,
            "Mesh to write: " + meshExtensions() + "; .ply has -1 as `label` of new faces"
        );
        for (const std::string_view id : {"shape", "max_length", "max_edges"}) {
            described.add(id);
        }
        app.add_option("--seed", seed, "Close the hole alone whose rim comes nearest to this point")
            ->delimiter(',')
            ->type_size(3)
            ->type_name("x,y,z");
        addReport(app, arguments.report, "Write counts, parts and times");
    }

    FillArguments finish() {
        arguments.request = fillRequest(described.values());
        if (!seed.empty()) {
            arguments.seed = Vec3(seed[0], seed[1], seed[2]);
        }
        return arguments;
    }

    CLI::App app{
        "Closes the holes that a mesh has: all, those whose rims are short, or the one at a point. "
        "No new\nface crosses another one or the mesh. The outer boundary of an open mesh is a "
        "hole "
        "as well.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or no such hole; 2 wrong usage; 130 interrupted "
        "by\nCtrl-C. No output is written unless the status is 0.\n",
        "bspline_curve fill"
    };
    FillArguments arguments;
    DescribedOptions described{app, fillFilter()};
    std::vector<double> seed;
};

ExitCode closeHoles(const FillArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkMeshExtension);
    checkOutput(arguments.report);
    const ImprintedFile file = imprintedFile(arguments, {}, bar);
    Stopwatch watch;
    HoleChoice choice = arguments.request.choice();
    choice.seed = arguments.seed;
    const CutMeshes filled = holesFilled(
        file.imprint, choice, arguments.request.shape, progressPart(bar, kImprintedShare, 1.0)
    );
    CutFigures figures{
        .doubledVertices = 0,
        .cutSeconds = 0.0,
        .kept = filled.pieces.front().parts,
        .filledHoles = filled.filledHoles
    };
    ResultFiles files;
    files.add(arguments.output, file.bytesOf(arguments.output, filled.pieces.front().mesh));
    figures.cutSeconds = watch.lap();
    if (!arguments.report.empty()) {
        files.add(
            arguments.report,
            cutReportBytes(*file.imprint.mesh, file.imprint.parts, file.figures, figures)
        );
    }
    bar.clear();
    files.commit();
    printNotes(file.notesFor(arguments.output));
    printNotes(filled.notes);
    bar.tell(
        arguments.output,
        describeCount(filled.filledHoles, "hole", "holes") + " filled, " +
            describeCount(filled.pieces.front().mesh.mesh().faces.size(), "face", "faces")
    );
    return ExitCode::Success;
}

}  // namespace

ExitCode runFill(Arguments arguments) {
    return runParsed<FillParser>(arguments, closeHoles);
}

}  // namespace bspline_curve::cli
