// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/workpiece.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// What a program measured around one curve; all times in seconds.
struct RunFigures {
    std::string meshFile;
    double readSeconds = 0.0;  ///< reading the mesh file
    double coldSeconds = 0.0;  ///< from arrays in memory to the polyline; a stored shell may help
    std::optional<double> warmSeconds;  ///< median of further curves with the shell kept
    double fieldSeconds = 0.0;          ///< the part of coldSeconds for the field
    double designSeconds = 0.0;         ///< the part of coldSeconds after shell and field
    std::string field, fieldCost;       ///< kind and cost of the field; empty: none
    StageSeconds stages;
    std::int64_t peakMemoryBytes = 0;  ///< of the program until the first curve was there
    std::int64_t readMemoryBytes = 0;  ///< likewise until the mesh was read
    ShellSummary shell;
    std::vector<std::string> notes;  ///< what people must know
};

/// The report as JSON: how long each stage took, why the solver stopped, figures of mesh, shell and
/// curve, every round and every iteration. Lengths in the user's unit, but max_distance in average
/// edge lengths and max_pick_gap relative to the diagonal.
[[nodiscard]] std::string reportText(
    const Curve& curve, const Workpiece& workpiece, const RunFigures& figures
);

/// Throws InputError (UnwritableFile) where the extension is not .json.
void checkReportExtension(const std::filesystem::path& file);

}  // namespace bspline_curve::cli
