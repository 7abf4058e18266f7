// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/offset_report.h"

#include "bspline_curve/curve.h"
#include "text/json_text.h"

#include <cstddef>

namespace bspline_curve::cli {

std::string offsetReportBytes(
    const std::vector<FittedLine>& pieces,
    const OffsetOptions& options,
    double drawSeconds,
    double offsetSeconds
) {
    Json list = Json::array();
    for (const FittedLine& piece : pieces) {
        const std::size_t repeated =
            piece.spline.closed ? static_cast<std::size_t>(piece.spline.degree) : 0;
        list.push_back({
            {"closed", piece.line.closed},
            {"vertices", piece.line.points.size()},
            {"length", lengthOf(piece.line)},
            {"deviation", piece.deviation},
            {"fitted", piece.isFitted},
            {"degree", piece.spline.degree},
            {"control_points", piece.spline.controlPoints.size() - repeated},
        });
    }
    const Json report = {
        {"distance", options.distance},
        {"tolerance", options.tolerance},
        {"pieces", list},
        {"seconds", {{"draw", drawSeconds}, {"offset", offsetSeconds}}},
    };
    return jsonText(report);
}

}  // namespace bspline_curve::cli
