// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"

#include <span>
#include <string>

namespace bspline_curve::cli {

/// What a program did around one field; wall clock.
struct FieldRunFigures {
    std::string meshFile;
    std::string kind;         ///< as users write it
    std::string naturalCost;  ///< likewise

    struct {
        double read = 0.0, validate = 0.0, field = 0.0, write = 0.0;
    } seconds;
};

/// The report as JSON: kind, minimum, mean and maximum over the vertices, times, mesh.
[[nodiscard]] std::string fieldReportText(
    const Workpiece& workpiece, std::span<const double> field, const FieldRunFigures& figures
);

}  // namespace bspline_curve::cli
