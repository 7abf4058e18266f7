// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/fit_report.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/spline.h"
#include "text/json_text.h"

#include <cstddef>

namespace bspline_curve::cli {

std::string fitReportBytes(std::span<const FitFigures> curves, std::span<const std::string> notes) {
    Json list = Json::array();
    for (const auto& [line, curve, seconds] : curves) {
        const SplineData& spline = curve->spline;
        Json corners = Json::array();
        const std::vector<int> picks = cornersOf(spline);
        for (std::size_t i = 0; i < curve->report.cornerTurns.size(); ++i) {
            corners.push_back({{"pick", picks[i]}, {"turn", curve->report.cornerTurns[i]}});
        }
        const std::size_t repeated = spline.closed ? static_cast<std::size_t>(spline.degree) : 0;
        list.push_back({
            {"line", line},
            {"closed", spline.closed},
            {"length", lengthOf(curve->polyline)},
            {"deviation", curve->report.lineDistance.value_or(0.0)},
            {"degree", spline.degree},
            {"control_points", spline.controlPoints.size() - repeated},
            {"picks", curve->polyline.picks.size()},
            {"corners", corners},
            {"status", name(curve->report.status)},
            {"usable", curve->report.usable},
            {"seconds", seconds},
        });
    }
    Json said = Json::array();
    for (const std::string& note : notes) {
        said.push_back(note);
    }
    return jsonText({{"curves", list}, {"notes", said}});
}

}  // namespace bspline_curve::cli
