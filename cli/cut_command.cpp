// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve cut MESH --curve FILE …: the mesh opened along curves, whole or in parts.
#include "bspline_curve/files.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/verb_parser.h"
#include "utility/stopwatch.h"

#include <algorithm>

namespace bspline_curve::cli {

namespace {

struct CutArguments : UseArguments {
    ImprintRequest request;
    CutChoice choice;
};

[[noreturn]] void refuseKeep(const std::string& word) {
    throw CLI::ValidationError(
        "--keep", word + " is none of all|largest|smallest|inside|outside|seed=x,y,z"
    );
}

struct CutParser {
    CutParser() {
        addMeshOutput(
            app,
            arguments.output,
            "Mesh to write: " + meshExtensions() +
                "; .ply has the part of each face as `label`, and the quality of the input"
        );
        auto* const keep = options.described.add(
            "keep",
            {.other = &keepWord,
             .otherHelp = "Points are seed=x,y,z or \"seed=x,y,z;x,y,z\".",
             .otherType = "=x,y,z"}
        );
        options.described
            .add(
                "split",
                {.help = "Write each part at a curve to a file of its own, and all that no curve "
                         "parts to one, the largest first: FILE.ply, FILE-2.ply, …"}
            )
            ->excludes(keep);
        auto* const fill = options.described.add("fill")->needs(keep);
        options.described.add("drop_untouched")->needs(keep);
        options.described.add("relief")->needs(keep)->excludes(fill);
        options.described.add("snap");
        addReport(app, arguments.report, "Write counts, parts, moves and times");
    }

    CutArguments finish() {
        options.finish();
        DescribedOptions& described = options.described;
        const std::string seed = "seed=";
        if (keepWord.starts_with(seed)) {
            std::string point = keepWord.substr(seed.size());
            std::ranges::replace(point, ',', ' ');
            described.set("keep", std::string("seed"));
            described.set("seed", point);
        } else if (!keepWord.empty()) {
            refuseKeep(keepWord);
        }
        const CutRequest request = cutRequest(described.values());
        arguments.request = request.imprint;
        try {
            arguments.choice = cutChoice(request.words, {});
        } catch (const InputError&) {  // no point
            refuseKeep(keepWord.empty() ? "seed" : keepWord);
        }
        return arguments;
    }

    CLI::App app{
        "Opens the mesh along curves: vertices on them are doubled, so that each side has its own. "
        "An open\ncurve becomes a slit. Parts are numbered from the largest area to the "
        "smallest.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, curves that are not on this mesh or open "
        "nothing; 2\nwrong usage; 130 interrupted by Ctrl-C. No output is written unless the "
        "status is 0.\n",
        "bspline_curve cut"
    };
    CutArguments arguments;
    UseOptions options{app, arguments, cutFilter()};
    std::string keepWord;
};

ExitCode cutAlong(const CutArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkMeshExtension);
    checkOutput(arguments.report);
    const ImprintedFile file = imprintedFile(arguments, arguments.request, bar);
    Stopwatch watch;
    const CutMeshes cut =
        cutOn(file.imprint, arguments.choice, progressPart(bar, kImprintedShare, 1.0));
    CutFigures figures{
        .doubledVertices = cut.doubledVertices,
        .cutSeconds = 0.0,
        .kept = {},
        .filledHoles = cut.filledHoles
    };
    ResultFiles files;
    std::filesystem::path last;
    for (const auto& [parts, mesh] : cut.pieces) {
        last = files.nextAfter(arguments.output);
        files.add(last, file.bytesOf(last, mesh));
        figures.kept.insert(figures.kept.end(), parts.begin(), parts.end());
    }
    files.replaceSeries(arguments.output);
    figures.cutSeconds = watch.lap();
    if (!arguments.report.empty()) {
        files.add(
            arguments.report,
            cutReportBytes(*file.imprint.mesh, file.imprint.parts, file.figures, figures)
        );
    }
    bar.clear();
    files.commit();
    printRemoved(files.stale());
    printNotes(file.notesFor(arguments.output));
    printNotes(cut.notes);
    bar.tell(arguments.output, describeSeries(cut.pieces.size(), "mesh", "meshes", last));
    return ExitCode::Success;
}

}  // namespace

ExitCode runCut(Arguments arguments) {
    return runParsed<CutParser>(arguments, cutAlong);
}

}  // namespace bspline_curve::cli
