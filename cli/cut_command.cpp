// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve cut MESH --curve FILE …: the mesh opened along curves, whole or in parts.
#include "cli/command.h"
#include "cli/imprint_input.h"
#include "cli/interrupt.h"
#include "cli/numbered_file.h"
#include "cli/parse_with.h"
#include "cli/progress_bar.h"
#include "cli/value_checks.h"
#include "cli/verb.h"
#include "fill/part_filling.h"
#include "fill/raised_parts.h"
#include "imprint/part_choice.h"
#include "io/atomic_file.h"
#include "io/imprint_writer.h"
#include "io/mesh_writer.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <limits>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

struct CutArguments {
    ImprintInput input;
    std::filesystem::path output;
    std::filesystem::path report;    ///< empty: none asked for
    std::optional<PartChoice> keep;  ///< none: all parts
    bool split = false;
    std::optional<FillShape> fill;  ///< none: holes stay
    double relief = 0.0;            ///< height that the parts to keep are moved by; 0: they are cut
};

/// Null where the word is no choice.
std::optional<PartChoice> partChoiceOf(const std::string& word) {
    using Which = PartChoice::Which;
    for (const auto& [name, which] :
         {std::pair{"largest", Which::Largest},
          std::pair{"smallest", Which::Smallest},
          std::pair{"inside", Which::Inside}}) {
        if (word == name) {
            return PartChoice{.which = which};
        }
    }
    const std::string seed = "seed=";
    if (!word.starts_with(seed)) {
        return std::nullopt;
    }
    PartChoice choice{.which = Which::Seed};
    const std::vector<std::string> numbers = CLI::detail::split(word.substr(seed.size()), ',');
    bool isPoint = numbers.size() == 3;
    for (std::size_t k = 0; isPoint && k < 3; ++k) {
        isPoint = CLI::detail::lexical_cast(numbers[k], choice.seed[static_cast<int>(k)]);
    }
    return isPoint ? std::optional(choice) : std::nullopt;
}

class CutParser {
public:
    CutParser() {
        app_.add_option(
                "--output",
                arguments_.output,
                "Mesh to write: " + meshExtensions() +
                    "; .ply has the part of each face as `label`, and the quality of the input"
        )
            ->required()
            ->type_name("FILE");
        const auto isChoice = [](const std::string& word) {
            return partChoiceOf(word) ? std::string()
                                      : word + " is none of largest|smallest|inside|seed=x,y,z";
        };
        auto* const keep =
            app_.add_option(
                    "--keep",
                    keep_,
                    "Write only the largest or the smallest part at curves, all but the largest "
                    "(inside), or the part at a point (seed=x,y,z)"
            )
                ->check(CLI::Validator(isChoice, ""))
                ->type_name("PART");
        app_.add_flag(
                "--split",
                arguments_.split,
                "Write each part at a curve to a file of its own, and all that no curve parts to "
                "one, "
                "the largest first: FILE.ply, FILE-2.ply, …"
        )
            ->excludes(keep);
        auto* const fill =
            app_.add_option(
                    "--fill",
                    fill_,
                    "What becomes of holes that the other parts leave: none (open), flat (no new "
                    "vertices) or smooth (as dense as around, with its tangent planes)"
            )
                ->check(oneOf({"none", "flat", "smooth"}))
                ->needs(keep)
                ->capture_default_str()
                ->type_name("SHAPE");
        app_.add_option(
                "--relief",
                arguments_.relief,
                "Write the whole mesh, with the parts of --keep moved by this along their normals, "
                "in its unit, and walls around them; negative: engraved"
        )
            ->check(atLeast(std::numeric_limits<double>::lowest()).validator())
            ->needs(keep)
            ->excludes(fill)
            ->type_name("HEIGHT");
        app_.add_option("--report", arguments_.report, "Write counts, parts, moves and times")
            ->type_name("FILE.json");
    }

    /// Throws CLI::ParseError.
    CutArguments parse(Arguments words) {
        // CLI11 takes them in reverse order.
        app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        input_.finish();
        arguments_.keep = partChoiceOf(keep_);
        if (fill_ != "none") {
            arguments_.fill = fill_ == "flat" ? FillShape::Flat : FillShape::Smooth;
        }
        return arguments_;
    }

    [[nodiscard]] const CLI::App& app() const { return app_; }

private:
    CLI::App app_{
        "Opens the mesh along curves: vertices on them are doubled, so that each side has its own. "
        "An open\ncurve becomes a slit. Parts are numbered from the largest area to the "
        "smallest.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, curves that are not on this mesh or open "
        "nothing; 2\nwrong usage; 130 interrupted by Ctrl-C. No output is written unless the "
        "status is 0.\n",
        "bspline_curve cut"
    };
    CutArguments arguments_;
    ImprintInputOptions input_{app_, arguments_.input};
    std::string keep_;
    std::string fill_ = "none";
};

/// Says of rims that were not filled.
void sayOpenRims(int openRims) {
    if (openRims > 0) {
        std::cerr << "bspline_curve: " << openRims
                  << " rims stay open, since the boundary of the mesh is part of them\n";
    }
}

/// The parts that one file gets.
FilledParts partsOfFile(
    const CutArguments& arguments,
    const ImprintedFile& file,
    const CutMesh& cut,
    const std::vector<int>& chosen,
    const Progress& progress
) {
    if (arguments.relief == 0.0) {
        return takenParts(file.imprinted, cut, file.parts, chosen, arguments.fill, progress);
    }
    RaisedParts raised = raisedParts(file.imprinted, file.parts, chosen, arguments.relief);
    if (raised.turnedFaces > 0) {
        std::cerr << "bspline_curve: the relief turns " << raised.turnedFaces
                  << " faces over; take a smaller height\n";
    }
    return std::move(raised.whole);
}

ExitCode cutAlong(const CutArguments& arguments, ProgressBar& bar) {
    checkMeshExtension(arguments.output);
    checkWritable(arguments.output);
    if (!arguments.report.empty()) {
        checkWritable(arguments.report);
    }
    const ImprintedFile file = readAndImprint(arguments.input, bar);
    constexpr double kImprintedShare = 0.7;
    throwIfInterrupted();
    bar.show(kImprintedShare, "cutting");
    const Progress progress = progressPart(bar, kImprintedShare, 1.0);
    Stopwatch watch;
    const CutMesh cut = openedAlongCurves(file.imprinted);
    const std::size_t doubled = cut.mesh.vertices.size() - file.imprinted.mesh.vertices.size();
    const std::vector<std::vector<int>> files =
        partsPerMesh(file.imprinted, file.parts, arguments.keep, arguments.split);
    CutFigures figures{.doubledVertices = static_cast<int>(doubled), .cutSeconds = 0.0, .kept = {}};
    // All files appear, or none.
    std::list<AtomicFile> written;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::filesystem::path name = numberedFile(arguments.output, i);
        const FilledParts taken =
            partsOfFile(arguments, file, cut, files[i], stepOf(progress, i, files.size()));
        const std::vector<double> quality =
            file.quality.empty() ? std::vector<double>() : taken.carried(file.quality);
        figures.filledHoles += static_cast<int>(taken.rims.size());
        sayOpenRims(taken.openRims);
        written.emplace_back(
            name,
            meshBytes(name, taken.mesh, {.vertexQuality = quality, .faceLabels = taken.labels})
        );
        figures.kept.insert(figures.kept.end(), files[i].begin(), files[i].end());
    }
    figures.cutSeconds = watch.lap();
    if (!arguments.report.empty()) {
        written.emplace_back(
            arguments.report, cutReportBytes(file.imprinted, file.parts, file.figures, figures)
        );
    }
    bar.clear();
    beginWriting();
    for (AtomicFile& each : written) {
        each.commit();
    }
    saySlits(file.imprinted, file.parts, !arguments.keep);
    if (files.size() > 1) {
        std::cerr << "bspline_curve: the mesh is in " << files.size() << " files, the last is "
                  << numberedFile(arguments.output, files.size() - 1).string() << '\n';
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runCut(Arguments arguments) {
    const auto parsed = parseWith<CutParser>(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& asked = std::get<CutArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return cutAlong(asked, bar); });
}

}  // namespace bspline_curve::cli
