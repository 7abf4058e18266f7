// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/field_report.h"

#include "cli/reports/mesh_json.h"
#include "text/json_text.h"

#include <algorithm>
#include <numeric>

namespace bspline_curve::cli {

std::string fieldReportText(
    const Workpiece& workpiece, std::span<const double> field, const FieldRunFigures& figures
) {
    const auto [minimum, maximum] = std::ranges::minmax(field);
    const double sum = std::accumulate(field.begin(), field.end(), 0.0);
    const auto& seconds = figures.seconds;
    const Json document = {
        {"kind", figures.kind},
        {"natural_cost", figures.naturalCost},
        {"minimum", minimum},
        {"mean", sum / static_cast<double>(field.size())},
        {"maximum", maximum},
        {"seconds",
         {{"read", seconds.read},
          {"validate", seconds.validate},
          {"field", seconds.field},
          {"write", seconds.write}}},
        {"repair", repairJson(workpiece.repair())},
        {"mesh", meshJson(workpiece, figures.meshFile)},
    };
    // A file name may hold bytes that are not UTF-8; they become replacement characters.
    return jsonText(document);
}

}  // namespace bspline_curve::cli
