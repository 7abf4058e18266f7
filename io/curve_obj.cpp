// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"
#include "text/number_text.h"

namespace bspline_curve {

namespace {

constexpr const char* kTitle = "# B-spline curve on a triangle mesh";

void appendPoints(std::string& bytes, std::span<const Vec3> points) {
    for (const Vec3& p : points) {
        bytes += 'v';
        for (const double x : p) {
            bytes.append(" ").append(numberText(x));
        }
        bytes += '\n';
    }
}

}  // namespace

std::string curveObj(std::span<const CurveContent> contents) {
    std::string bytes = std::string(kTitle) + ": its polyline\n";
    std::size_t before = 1;  // vertices count from 1
    for (const CurveContent& content : contents) {
        const SurfacePolyline& polyline = content.curve.polyline;
        appendPoints(bytes, polyline.points);
        for (const auto& [from, to] : segmentsOf(polyline)) {
            bytes +=
                "l " + std::to_string(before + from) + ' ' + std::to_string(before + to) + '\n';
        }
        before += polyline.points.size();
    }
    return bytes;
}

std::string splineObj(const CurveContent& content) {
    const SplineData& spline = content.curve.spline;
    // The repeated control points of a closed spline are named again, not written again: so readers
    // see that it is closed.
    const std::size_t count = spline.controlPoints.size();
    const std::size_t repeated = spline.closed ? static_cast<std::size_t>(spline.degree) : 0;
    const std::size_t distinct = count - repeated;
    std::string bytes = std::string(kTitle) + ": its spline\n";
    appendPoints(bytes, std::span(spline.controlPoints).first(distinct));
    bytes += "cstype bspline\ndeg " + std::to_string(spline.degree) + "\ncurv 0 1";
    for (std::size_t i = 0; i < count; ++i) {
        bytes.append(" ").append(std::to_string(i % distinct + 1));
    }
    bytes += "\nparm u";
    for (const double knot : spline.knots) {
        bytes.append(" ").append(numberText(knot));
    }
    return bytes + "\nend\n";
}

}  // namespace bspline_curve
