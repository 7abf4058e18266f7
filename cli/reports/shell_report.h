// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/repair.h"
#include "bspline_curve/whole_shell.h"
#include "bspline_curve/workpiece.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// What a run of the shell stage took, for the report.
struct ShellRunFigures {
    std::string meshFile;

    /// cpu: of this process, all threads, from arrays in memory to the shell (validate,
    /// base and shell), as wall; the others: wall clock of each stage.
    struct {
        double cpu = 0.0, wall = 0.0;
        double read = 0.0, check = 0.0, write = 0.0;
    } seconds;

    /// Largest resident memory of the program, until the shell was there.
    std::int64_t peakMemoryBytes = 0;
    std::optional<std::vector<ShellInvariant>> check{};  ///< none: not asked for
};

/// The report of a run as JSON.
[[nodiscard]] std::string shellReportText(
    const Workpiece& workpiece, const WholeShell& shell, const ShellRunFigures& figures
);

}  // namespace bspline_curve::cli
