// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve cut MESH --curve FILE …: the mesh opened along curves, whole or in parts.
#include "bspline_curve/files.h"
#include "cli/result_files.h"
#include "cli/use_input.h"
#include "cli/verb_parser.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct CutArguments : UseArguments {
    ImprintRequest request;
    CutChoice choice;
    double stroke = 0.0;
};

constexpr const char* kSlotHelp =
    "Sink slots of this width and depth along the curves: --stroke WIDTH --relief -DEPTH";

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
        auto* const fill = options.described.add("fill");
        options.described.add("drop_untouched")->needs(keep);
        auto* const relief = options.described.add("relief")->excludes(fill);
        auto* const stroke = options.described.add("stroke");
        app.add_option("--slot", slot, kSlotHelp)
            ->delimiter(',')
            ->expected(2)
            ->type_name("WIDTH,DEPTH")
            ->excludes(relief)
            ->excludes(stroke)
            ->excludes(fill);
        options.described.add("profile");
        options.described.add("profile_width");
        auto* const thickness = options.described.add("thickness");
        for (const char* id : {"base", "base_direction", "base_height"}) {
            options.described.add(id, {.otherType = "X,Y,Z"})->excludes(thickness);
        }
        options.described.add("snap");
        listIn(app, "Parts", {"--keep", "--split", "--fill", "--drop-untouched"});
        listIn(
            app,
            "Strokes and reliefs",
            {"--relief", "--stroke", "--slot", "--profile", "--profile-width"}
        );
        listIn(app, "Solids", {"--thickness", "--base", "--base-direction", "--base-height"});
        addReport(app, arguments.report, "Write counts, parts, moves and times");
    }

    CutArguments finish() {
        options.finish();
        DescribedOptions& described = options.described;
        if (!slot.empty()) {
            const bool isSlot = slot.size() == 2 && std::isfinite(slot[0]) && slot[0] > 0.0 &&
                                std::isfinite(slot[1]) && slot[1] != 0.0;
            if (!isSlot) {
                throw CLI::ValidationError(
                    "--slot", "needs a width above 0, a comma and a depth that is not 0"
                );
            }
            described.set("stroke", slot[0]);
            described.set("relief", -slot[1]);
        }
        checkPartsAreMeant();
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
        arguments.stroke = request.words.stroke;
        try {
            arguments.choice = cutChoice(request.words, {});
        } catch (const InputError&) {  // no point
            refuseKeep(keepWord.empty() ? "seed" : keepWord);
        }
        return arguments;
    }

    void checkPartsAreMeant() const {
        if (!keepWord.empty() || options.described.isGiven("keep")) {
            return;
        }
        if (options.described.isGiven("relief") && !options.described.isGiven("stroke")) {
            throw CLI::ValidationError("--relief", "requires --keep or --stroke");
        }
        for (const char* id : {"fill", "thickness", "base", "base_direction"}) {
            if (options.described.isGiven(id) && !options.described.isGiven("split")) {
                throw CLI::ValidationError(flagOf(id), "requires --keep or --split");
            }
        }
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
    std::vector<double> slot;  // width and depth
};

ExitCode cutAlong(const CutArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkMeshExtension);
    checkOutput(arguments.report);
    const ImprintedFile file = imprintedFile(arguments, arguments.request, bar, arguments.stroke);
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
