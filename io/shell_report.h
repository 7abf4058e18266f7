// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check_shell.h"
#include "shell/shell_builder.h"
#include "surface/repair.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bspline_curve {

/// What a program measured around one shell.
struct ShellRunFigures {
    std::string meshFile;

    int faces = 0;  ///< of the input

    /// cpu: of this process, all threads, from arrays in memory to the shell (validate,
    /// base and shell), as wall; the others: wall clock of each stage.
    struct {
        double cpu = 0.0, wall = 0.0;
        double read = 0.0, validate = 0.0, extended = 0.0, shell = 0.0;
        double check = 0.0, write = 0.0;
    } seconds;

    /// Largest resident memory of the program, until the shell was there.
    std::int64_t peakMemoryBytes = 0;
    const RepairReport* repair = nullptr;  ///< null: nothing was repaired
    std::vector<std::string> notes;        ///< about the cache; empty where all is well
};

/// How thick a shell is: from top to bottom along each pillar of a prism over the surface (not
/// beyond its boundary), relative to the longest side of the surface's box.
struct ShellThickness {
    double mean = 0.0;
    double p5 = 0.0;  ///< 5th percentile, linear between the two nearest
    double min = 0.0;
};

[[nodiscard]] ShellThickness measureThickness(
    const Surface& surface, const ShellFrame& frame, const Shell& shell
);

/// What a report is about.
struct ReportedShell {
    const Surface& surface;
    const ExtendedSurface& extended;
    const ShellBuild& build;
    const ShellCheck* check = nullptr;  ///< null: not asked for
};

/// The report as JSON: counts, thickness, times, memory, and how each invariant fared.
[[nodiscard]] std::string shellReportText(
    const ReportedShell& reported, const ShellRunFigures& figures
);

}  // namespace bspline_curve
