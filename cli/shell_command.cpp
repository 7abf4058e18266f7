// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve shell MESH --output FILE …: the shell of a mesh.
#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/conforming_grid.h"
#include "cli/interrupt.h"
#include "cli/mesh_input.h"
#include "cli/process_figures.h"
#include "cli/progress_bar.h"
#include "cli/shell_cache_option.h"
#include "cli/shell_options.h"
#include "cli/verb.h"
#include "io/atomic_file.h"
#include "io/report_writer.h"
#include "io/shell_report.h"
#include "io/shell_writer.h"
#include "io/tetrahedral_grid.h"
#include "shell/shell_store.h"
#include "surface/error_messages.h"
#include "utility/stopwatch.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// Refuses what could only fail after the work.
void checkOutputs(const ShellArguments& arguments) {
    if (!arguments.output.empty()) {
        checkShellExtension(arguments.output);
        checkWritable(arguments.output);
    }
    if (!arguments.report.empty()) {
        checkReportExtension(arguments.report);
        checkWritable(arguments.report);
    }
}

struct Built {
    Surface surface;
    std::shared_ptr<const ExtendedSurface> extended;
    ObtainedShell obtained;

    [[nodiscard]] const Shell& shell() const { return obtained.build.shell; }
};

/// Figures and checks are those of building a shell, so where these are asked for it is built; it
/// is stored all the same.
bool takesStoredShell(const ShellArguments& arguments) {
    return arguments.report.empty() && !arguments.check;
}

/// Validates the mesh, mended where needed, and builds its shell (or takes it from the cache), one
/// stage after the other.
Built buildStages(
    TriangleMesh mesh,
    const ShellArguments& arguments,
    const ShellStore* store,
    ShellRunFigures& figures,
    ProgressBar& bar
) {
    constexpr double kBuildStart = 0.1;  // for the bar only
    const double cpuBefore = processCpuSeconds();
    Stopwatch whole;
    Stopwatch watch;
    figures.faces = static_cast<int>(mesh.faces.size());
    bar.show(0.0, "validating");
    auto [surface, mending] = surfaceOfMended(std::move(mesh), arguments.mending);
    sayMended(mending);
    figures.repair = reportOf(mending);
    figures.seconds.validate = watch.lap();
    auto extended = std::make_shared<const ExtendedSurface>(
        extendSurface(surface, arguments.shell.smoothingPasses)
    );
    figures.seconds.extended = watch.lap();
    ObtainedShell obtained = findOrMakeShell(
        surface,
        extended,
        arguments.shell,
        takesStoredShell(arguments) ? store : nullptr,
        progressPart(bar, kBuildStart, 1.0)
    );
    figures.seconds.shell = watch.lap();
    figures.seconds.wall = whole.lap();
    figures.seconds.cpu = processCpuSeconds() - cpuBefore;
    figures.peakMemoryBytes = peakMemoryBytes();
    return {
        .surface = std::move(surface),
        .extended = std::move(extended),
        .obtained = std::move(obtained)
    };
}

void refuseEmptyShell(const Built& built) {
    if (built.shell().prismCount() == 0) {
        throw InputError(
            InputErrorCode::NoShell,
            "no face got a prism: the surface crosses itself or folds onto itself everywhere, so "
            "repair it with MeshLab's filters 'Remove Duplicate Faces' and 'Merge Close Vertices'"
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

/// The bytes of the output.
std::string outputBytes(const ShellArguments& arguments, const Built& built, ProgressBar& bar) {
    if (arguments.isConforming) {
        const TetrahedralGrid grid = conformingGrid(
            built.surface,
            *built.extended,
            built.shell(),
            built.obtained.build.report.blockedFaces,
            progressPart(bar, 0.0, 1.0)
        );
        return gridBytes(arguments.output, grid);
    }
    return shellBytes(arguments.output, built.shell(), built.extended->frame);
}

/// Writes shell and report together: both files appear, or none. Of a shell that is wrong only the
/// report.
void writeResults(
    const ShellArguments& arguments,
    const Built& built,
    const std::optional<ShellCheck>& check,
    ShellRunFigures& figures,
    ProgressBar& bar
) {
    Stopwatch watch;
    std::optional<AtomicFile> output;
    std::optional<AtomicFile> report;
    if (!arguments.output.empty() && (!check || check->passed())) {
        output.emplace(arguments.output, outputBytes(arguments, built, bar));
        bar.clear();
    }
    figures.seconds.write = watch.lap();
    if (!arguments.report.empty()) {
        report.emplace(
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
    beginWriting();
    if (output) {
        output->commit();
    }
    if (report) {
        report->commit();
    }
}

ExitCode build(const ShellArguments& arguments, ProgressBar& bar) {
    checkOutputs(arguments);
    ShellRunFigures figures;
    figures.meshFile = arguments.mesh.string();
    bar.show(0.0, "reading");
    Stopwatch watch;
    TriangleMesh mesh = readInputMesh(arguments.mesh, arguments.mending.strict).mesh;
    figures.seconds.read = watch.lap();
    throwIfInterrupted();
    const std::optional<ShellCache> cache = cacheUnless(arguments.noCache);
    const ShellStore* const store = cache ? &*cache : nullptr;
    Built built = buildStages(std::move(mesh), arguments, store, figures, bar);
    refuseEmptyShell(built);
    std::optional<ShellCheck> check;
    if (arguments.check) {
        bar.show(1.0, "checking");
        watch.lap();
        check = checkShell(
            built.surface, *built.extended, built.shell(), built.obtained.build.report.blockedFaces
        );
        figures.seconds.check = watch.lap();
        throwIfInterrupted();
    }
    if (!check || check->passed()) {
        keepShell(built.surface, *built.extended, arguments.shell, store, built.obtained);
    }
    bar.clear();
    figures.notes = built.obtained.notes;
    printNotes(figures.notes);
    writeResults(arguments, built, check, figures, bar);
    if (check && !check->passed()) {
        printError(failureMessage(*check));
        return ExitCode::Failure;
    }
    return ExitCode::Success;
}

}  // namespace

ExitCode runShell(Arguments arguments) {
    const auto parsed = parseShellArguments(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& shell = std::get<ShellArguments>(parsed);
    return runVerb([&](ProgressBar& bar) { return build(shell, bar); });
}

}  // namespace bspline_curve::cli
