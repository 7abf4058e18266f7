// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/pattern_report.h"

#include "bspline_curve/curve.h"
#include "text/json_text.h"

#include <utility>

namespace bspline_curve::cli {

namespace {

Json distortionJson(const Distortion& distortion) {
    const Vec3& at = distortion.position;
    return {
        {"ratio", distortion.ratio},
        {"path", distortion.path},
        {"copy", distortion.copy},
        {"position", {at.x(), at.y(), at.z()}},
    };
}

Json curveJsonOf(const PatternCurve& each) {
    const SurfacePolyline& line = each.curve.polyline;
    return {
        {"path", each.path},
        {"copy", each.copy},
        {"closed", line.closed},
        {"picks", line.picks.size()},
        {"length", lengthOf(line)},
        {"usable", each.curve.report.usable},
    };
}

}  // namespace

std::string patternReportBytes(const Pattern& pattern, const PatternFigures& figures) {
    Json curves = Json::array();
    for (const PatternCurve& each : pattern.curves) {
        curves.push_back(curveJsonOf(each));
    }
    Json document{
        {"curves", std::move(curves)},
        {"tolerance", pattern.tolerance},
        {"largest_deviation", pattern.largestDeviation},
        {"distortion",
         {{"shortest", distortionJson(pattern.shortest)},
          {"longest", distortionJson(pattern.longest)}}},
        {"seconds",
         {{"read", figures.readSeconds},
          {"prepare", figures.prepareSeconds},
          {"draw", figures.drawSeconds}}},
    };
    if (!figures.font.empty()) {
        document["font"] = figures.font;
    }
    return jsonText(document);
}

}  // namespace bspline_curve::cli
