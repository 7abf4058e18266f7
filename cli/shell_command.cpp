// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve shell MESH --output FILE …: the shell of a mesh.
#include "cli/described_options.h"
#include "cli/interrupt.h"
#include "cli/loaded_mesh.h"
#include "cli/process_figures.h"
#include "cli/result_files.h"
#include "cli/verb_parser.h"
#include "filters/requests.h"
#include "io/report_writer.h"
#include "io/shell_report.h"
#include "io/shell_writer.h"
#include "io/tetrahedral_grid.h"
#include "io/text_parsing.h"
#include "shell/shell_store.h"
#include "surface/error_messages.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"
#ifdef BSPLINE_CURVE_TETGEN
#include "tetrahedra/conforming_tetrahedra.h"
#endif

#include <memory>
#include <optional>
#include <utility>

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

struct Built {
    const Surface& surface;
    std::shared_ptr<const ExtendedSurface> extended;
    ObtainedShell obtained;

    [[nodiscard]] const Shell& shell() const { return obtained.build.shell; }
};

/// Figures and checks are those of building a shell, so where these are asked for it is built; it
/// is stored all the same.
bool takesStoredShell(const ShellArguments& arguments) {
    return arguments.report.empty() && !arguments.check;
}

/// The shell of a mesh, from the cache where it is there; stages after the surface.
Built buildStages(
    const Workpiece& workpiece,
    const ShellArguments& arguments,
    const ShellStore* store,
    ShellRunFigures& figures,
    ProgressBar& bar
) {
    constexpr double kBuildStart = 0.1;  // for the bar only
    const Surface& surface = surfaceOf(workpiece);
    const ShellOptions& options = arguments.preparing.shell;
    Stopwatch watch;
    auto extended =
        std::make_shared<const ExtendedSurface>(extendSurface(surface, options.smoothingPasses));
    figures.seconds.extended = watch.lap();
    ObtainedShell obtained = findOrMakeShell(
        surface,
        extended,
        options,
        takesStoredShell(arguments) ? store : nullptr,
        progressPart(bar, kBuildStart, 1.0)
    );
    figures.seconds.shell = watch.lap();
    return {.surface = surface, .extended = std::move(extended), .obtained = std::move(obtained)};
}

void refuseEmptyShell(const Built& built) {
    if (built.shell().prismCount() == 0) {
        throw InputError(
            InputErrorCode::NoShell,
            "no face got a prism: the surface crosses itself or folds onto itself everywhere"
        );
    }
}

std::string failureMessage(const ShellCheck& check) {
    std::string text = "the shell is wrong:";
    const char* separator = " ";
    for (const InvariantCheck* const invariant : check.invariants()) {
        if (!invariant->holds) {
            const std::vector<std::int64_t> ids(
                invariant->firstIds.begin(), invariant->firstIds.end()
            );
            text.append(separator).append(invariant->name).append(" violated ");
            text += describeCount(invariant->violations, "time", "times");
            text += " (first ids " + describeElements(ids) + ")";
            separator = "; ";
        }
    }
    return text + "; please send the mesh to the authors";
}

/// The tetrahedra of TetGen. Not where the program was built without it.
TetrahedralGrid conformingGrid(
    [[maybe_unused]] const Built& built, [[maybe_unused]] const Progress& progress
) {
    TetrahedralGrid grid{
        .points = {}, .heights = {}, .tetrahedra = {}, .slabName = "side", .slabs = {}, .fields = {}
    };
#ifdef BSPLINE_CURVE_TETGEN
    ConformingTetrahedra made = conformToSurface(
        built.surface,
        *built.extended,
        built.shell(),
        built.obtained.build.report.blockedFaces,
        progress
    );
    grid.points = std::move(made.points);
    grid.heights = std::move(made.heights);
    grid.tetrahedra = std::move(made.tetrahedra);
    for (const SurfaceSide side : made.sides) {
        grid.slabs.push_back(static_cast<std::uint8_t>(side));
    }
#endif
    return grid;
}

/// The bytes of the output.
std::string outputBytes(const ShellArguments& arguments, const Built& built, ProgressBar& bar) {
    return arguments.isConforming
               ? gridBytes(arguments.output, conformingGrid(built, progressPart(bar, 0.0, 1.0)))
               : shellBytes(arguments.output, built.shell(), built.extended->frame);
}

/// Of a shell that is wrong only the report.
void writeResults(
    const ShellArguments& arguments,
    const Built& built,
    const std::optional<ShellCheck>& check,
    ShellRunFigures& figures,
    ProgressBar& bar
) {
    Stopwatch watch;
    ResultFiles files;
    if (!arguments.output.empty() && (!check || check->passed())) {
        files.add(arguments.output, outputBytes(arguments, built, bar));
        bar.clear();
    }
    figures.seconds.write = watch.lap();
    if (!arguments.report.empty()) {
        files.add(
            arguments.report,
            shellReportText(
                {.surface = built.surface,
                 .extended = *built.extended,
                 .build = built.obtained.build,
                 .check = check ? &*check : nullptr},
                figures
            )
        );
    }
    files.commit();
}

ExitCode build(const ShellArguments& arguments, ProgressBar& bar) {
    checkOutput(arguments.output, checkShellExtension);
    checkOutput(arguments.report, checkReportExtension);
    bar.show(0.0, "reading");
    LoadedMesh loaded = loadMesh(arguments.mesh, arguments.preparing.mending.strict);
    const std::optional<ShellCache> cache = cacheUnless(arguments.noCache);
    const ShellStore* const store = cache ? &*cache : nullptr;
    const double cpuBefore = processCpuSeconds();
    Stopwatch whole;
    bar.show(0.0, "validating");
    loaded.prepare(arguments.preparing);
    const Workpiece& workpiece = *loaded.workpiece;
    printNotes(loaded.notes());
    ShellRunFigures figures;
    Built built = buildStages(workpiece, arguments, store, figures, bar);
    figures.seconds.wall = whole.lap();
    figures.seconds.cpu = processCpuSeconds() - cpuBefore;
    figures.seconds.read = loaded.readSeconds;
    figures.seconds.validate = workpiece.seconds().validate;
    figures.peakMemoryBytes = peakMemoryBytes();
    figures.meshFile = arguments.mesh.string();
    figures.faces = static_cast<int>(workpiece.mesh().faces.size());
    figures.repair = workpiece.repair();
    refuseEmptyShell(built);
    std::optional<ShellCheck> check;
    if (arguments.check) {
        bar.show(1.0, "checking");
        Stopwatch watch;
        check = checkShell(
            built.surface, *built.extended, built.shell(), built.obtained.build.report.blockedFaces
        );
        figures.seconds.check = watch.lap();
        throwIfInterrupted();
    }
    if (!check || check->passed()) {
        keepShell(built.surface, *built.extended, arguments.preparing.shell, store, built.obtained);
    }
    bar.clear();
    figures.notes = built.obtained.notes;
    printNotes(figures.notes);
    writeResults(arguments, built, check, figures, bar);
    if (check && !check->passed()) {
        printError(failureMessage(*check));
        return ExitCode::Failure;
    }
    const std::filesystem::path& file =
        arguments.output.empty() ? arguments.mesh : arguments.output;
    bar.tell(
        file,
        "a shell of " + describeCount(built.shell().prismCount(), "prism", "prisms") +
            (check ? ", every invariant holds" : "")
    );
    return ExitCode::Success;
}

}  // namespace

ExitCode runShell(Arguments arguments) {
    return runParsed<ShellParser>(arguments, build);
}

}  // namespace bspline_curve::cli
