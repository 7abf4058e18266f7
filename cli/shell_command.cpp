// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve shell MESH --output FILE …: the shell of a mesh.
#include "bspline_curve/whole_shell.h"
#include "cli/described_options.h"
#include "cli/interrupt.h"
#include "cli/loaded_mesh.h"
#include "cli/process_figures.h"
#include "cli/reports/curve_report.h"
#include "cli/reports/shell_report.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "filters/requests.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"
#include "utility/stopwatch.h"
#ifdef BSPLINE_CURVE_TETGEN
#include "tetrahedra/conforming_file.h"
#endif

namespace bspline_curve::cli {

namespace {

#ifdef BSPLINE_CURVE_TETGEN
constexpr bool kHasTetgen = true;
#else
constexpr bool kHasTetgen = false;
#endif

struct ShellArguments {
    std::filesystem::path mesh;
    std::filesystem::path output, report;  ///< empty: not asked for
    bool check = false;
    bool isConforming = false;  ///< tetrahedra that conform to the surface
    bool noCache = false;
    PreparingOptions preparing;
};

struct ShellParser {
    ShellParser() {
        addFiles();
        options.set("shell", std::string(name(ShellKind::Simplified)));
        for (const char* const id :
             {"shell",
              "target_thickness",
              "target_edge_length",
              "shell_thickness",
              "shell_smoothing_passes",
              "strict",
              "weld",
              "slits"}) {
            options.add(id);
        }
    }

    ShellArguments finish() {
        if (arguments.output.empty() && arguments.report.empty() && !arguments.check) {
            throw CLI::RequiredError("one of --output, --report, --check");
        }
        const CurveRequest request = curveRequest(options.values());
        arguments.preparing = {.mending = request.mending, .shell = request.shell};
        if (arguments.preparing.shell.kind == ShellKind::Local) {
            throw CLI::ValidationError(
                "--shell",
                "a local shell has no prisms, only the fibres near a curve: use simplified or full"
            );
        }
        if (arguments.isConforming) {
            checkConforming();
        }
        return arguments;
    }

    void addFiles() {
        addMesh(app, arguments.mesh);
        addFile(
            app,
            "--output",
            arguments.output,
            "Shell to write: .vtu or .msh (tetrahedra with f in [-1, 1]) or .ply (top, middle and "
            "bottom as triangles); may be left out with --report or --check"
        );
        app.add_flag(
            "--conforming-to-surface",
            arguments.isConforming,
            "Write tetrahedra of a simplified shell that the surface does not cut, made anew by "
            "TetGen: its vertices first, its faces among those of the tetrahedra; .vtu or .msh. "
            "Those of a full shell conform to the surface as they are"
        );
        addReport(
            app,
            arguments.report,
            "Write counts, thickness, times and memory as .json; also of a shell that is wrong"
        );
        app.add_flag(
            "--check",
            arguments.check,
            "Check every invariant of the shell with exact predicates and code of its own; exit "
            "status 1 where one does not hold"
        );
        addCacheOption(app, arguments.noCache);
    }

    void checkConforming() const {
        const char* const option = "--conforming-to-surface";
        if (arguments.output.empty()) {
            throw CLI::RequiredError("--output with --conforming-to-surface");
        }
        if (lowerCaseExtension(arguments.output) == ".ply") {
            throw CLI::ValidationError(option, "a .ply file holds no tetrahedra: use .vtu or .msh");
        }
        if (arguments.preparing.shell.kind != ShellKind::Simplified) {
            throw CLI::ValidationError(
                option, "the tetrahedra of a full shell conform to the surface as they are"
            );
        }
        if (!kHasTetgen) {
            throw CLI::ValidationError(
                option, "this program was built without TetGen (libtet1.5-dev)"
            );
        }
    }

    CLI::App app{
        "Builds the shell of a triangle mesh: prisms around the surface, every one split into six\n"
        "tetrahedra, with a piecewise affine f that is -1 at the bottom, 0 in the middle, 1 at the "
        "top.\n\n"
        "Exit status: 0 done; 1 bad mesh or file, or a check failed; 2 wrong usage; 130 "
        "interrupted\n"
        "by Ctrl-C. No output is written unless the status is 0.\n",
        "bspline_curve shell"
    };
    ShellArguments arguments;
    DescribedOptions options{app, curveFilter()};
};

/// Figures and checks are those of making a shell, so where these are asked for it is made; it
/// is kept all the same.
bool takesKeptShell(const ShellArguments& arguments) {
    return !arguments.noCache && arguments.report.empty() && !arguments.check;
}

bool passed(const std::vector<ShellInvariant>& check) {
    return std::ranges::all_of(check, &ShellInvariant::holds);
}

std::string failureMessage(const std::vector<ShellInvariant>& check) {
    std::string text = "the shell is wrong:";
    const char* separator = " ";
    for (const ShellInvariant& invariant : check) {
        if (!invariant.holds) {
            const std::vector<std::int64_t> ids(
                invariant.firstIds.begin(), invariant.firstIds.end()
            );
            text.append(separator).append(invariant.name).append(" violated ");
            text += describeCount(invariant.violations, "time", "times");
            text += " (first ids " + describeElements(ids) + ")";
            separator = "; ";
        }
    }
    return text + "; please send the mesh to the authors";
}

/// The bytes of the output.
std::string outputBytes(
    const ShellArguments& arguments, const WholeShell& shell, [[maybe_unused]] ProgressBar& bar
) {
#ifdef BSPLINE_CURVE_TETGEN
    if (arguments.isConforming) {
        return conformingFileBytes(arguments.output, shell, progressPart(bar, 0.0, 1.0));
    }
#endif
    return shell.bytes(arguments.output);
}

/// Of a shell that is wrong only the report.
void writeResults(
    const ShellArguments& arguments,
    const Workpiece& workpiece,
    const WholeShell& shell,
    ShellRunFigures& figures,
    ProgressBar& bar
) {
    Stopwatch watch;
    ResultFiles files;
    if (!arguments.output.empty() && (!figures.check || passed(*figures.check))) {
        files.add(arguments.output, outputBytes(arguments, shell, bar));
        bar.clear();
    }
    figures.seconds.write = watch.lap();
    if (!arguments.report.empty()) {
        files.add(arguments.report, shellReportText(workpiece, shell, figures));
    }
    files.commit();
}

ExitCode build(const ShellArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkShellExtension);
    checkOutput(arguments.report, checkReportExtension);
    bar.show(0.0, "reading");
    LoadedMesh loaded = loadMesh(arguments.mesh, arguments.preparing.mending.strict);
    ShellRunFigures figures;
    figures.meshFile = arguments.mesh.string();
    figures.seconds.read = loaded.readSeconds;
    const double cpuBefore = processCpuSeconds();
    Stopwatch whole;
    bar.show(0.0, "validating");
    loaded.prepare(arguments.preparing);
    const Workpiece& workpiece = *loaded.workpiece;
    printNotes(loaded.notes());
    WholeShell shell(workpiece, takesKeptShell(arguments), progressPart(bar, 0.0, 1.0));
    figures.seconds.wall = whole.lap();
    figures.seconds.cpu = processCpuSeconds() - cpuBefore;
    figures.peakMemoryBytes = peakMemoryBytes();
    if (arguments.check) {
        bar.show(1.0, "checking");
        Stopwatch watch;
        figures.check = shell.check();
        figures.seconds.check = watch.lap();
        throwIfInterrupted();
    }
    const bool isWrong = figures.check && !passed(*figures.check);
    if (!arguments.noCache && !isWrong) {
        shell.keep();
    }
    bar.clear();
    printNotes(shell.notes());
    writeResults(arguments, workpiece, shell, figures, bar);
    if (isWrong) {
        printError(failureMessage(*figures.check));
        return ExitCode::Failure;
    }
    const std::filesystem::path& file =
        arguments.output.empty() ? arguments.mesh : arguments.output;
    bar.tell(
        file,
        "a shell of " + describeCount(shell.figures().prisms, "prism", "prisms") +
            (figures.check ? ", every invariant holds" : "")
    );
    return ExitCode::Success;
}

}  // namespace

ExitCode runShell(Arguments arguments) {
    return runParsed<ShellParser>(arguments, build);
}

}  // namespace bspline_curve::cli
