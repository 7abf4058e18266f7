// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/offset_curves.h"

#include "bspline_curve/error.h"
#include "design/strict_polyline.h"
#include "offset/distance_beams.h"
#include "offset/level_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {

namespace {

bool isOn(CurveSide side, OffsetSides sides) {
    return sides == OffsetSides::Both ||
           side == (sides == OffsetSides::Left ? CurveSide::Left : CurveSide::Right);
}

/// The parts of a line on the sides that are asked for.
std::vector<LevelLine> partsOn(const LevelLine& line, OffsetSides sides) {
    const int count = static_cast<int>(line.points.size());
    int outside = -1;
    for (int i = 0; i < count && outside < 0; ++i) {
        outside = isOn(line.sides[i], sides) ? -1 : i;
    }
    if (outside < 0) {
        return {line};
    }
    std::vector<LevelLine> parts(1);
    // A closed line is cut at a point that is not asked for.
    const int first = line.closed ? outside : 0;
    for (int i = 0; i < count; ++i) {
        const int at = (first + i) % count;
        if (isOn(line.sides[at], sides)) {
            parts.back().points.push_back(line.points[at]);
            parts.back().sides.push_back(line.sides[at]);
        } else if (!parts.back().points.empty()) {
            parts.emplace_back();
        }
    }
    std::erase_if(parts, [](const LevelLine& part) { return part.points.size() < 2; });
    return parts;
}

/// Without segments of no length; t by length.
std::pair<double, SurfacePolyline> polylineOf(const Surface& surface, const LevelLine& line) {
    SurfacePolyline result;
    result.closed = line.closed;
    double length = 0.0;
    for (const SurfacePoint& point : line.points) {
        const Vec3 position = surface.position(point);
        if (!result.points.empty()) {
            const double step = (position - result.points.back()).norm();
            if (step == 0.0) {
                continue;
            }
            length += step;
        }
        result.surfacePoints.push_back(point);
        result.points.push_back(position);
        result.parameters.push_back(length);
    }
    if (result.closed) {
        length += (result.points.front() - result.points.back()).norm();
    }
    for (double& t : result.parameters) {
        t = length > 0.0 ? t / length : 0.0;
    }
    return {length, std::move(result)};
}

void checkInput(const Surface& surface, const SurfacePolyline& line, const OffsetOptions& options) {
    options.validate();
    if (line.surfacePoints.size() < 2) {
        throw InputError(
            InputErrorCode::NoPath,
            "the curve has fewer than 2 points; draw it with at least 2 picks"
        );
    }
    if (!isStrict(surface, line)) {
        throw InputError(
            InputErrorCode::NoPath,
            "the curve does not lie on this mesh: a segment of it is not in one face; draw it on "
            "this mesh"
        );
    }
}

}  // namespace

void OffsetOptions::validate() const {
    if (!std::isfinite(distance) || distance <= 0.0) {
        throw InputError(InputErrorCode::BadOption, "distance must be a number above 0");
    }
    if (!std::isfinite(step) || step <= 0.0 || step > 1.0) {
        throw InputError(InputErrorCode::BadOption, "step must be above 0 and at most 1");
    }
}

std::vector<SurfacePolyline> offsetPolylines(
    const Surface& surface, const SurfacePolyline& line, const OffsetOptions& options
) {
    checkInput(surface, line, options);
    const DistanceBeams beams(surface, line, options.distance);
    std::vector<std::pair<double, SurfacePolyline>> pieces;
    for (const LevelLine& level : levelLines(surface, beams, options.distance, options.step)) {
        for (const LevelLine& part : partsOn(level, options.sides)) {
            pieces.push_back(polylineOf(surface, part));
        }
    }
    std::erase_if(pieces, [](const auto& piece) { return piece.second.points.size() < 2; });
    std::ranges::stable_sort(pieces, std::greater(), [](const auto& piece) { return piece.first; });
    std::vector<SurfacePolyline> result;
    for (auto& piece : pieces) {
        result.push_back(std::move(piece.second));
    }
    return result;
}

SplineData polygonSpline(const SurfacePolyline& line) {
    SplineData spline;
    spline.degree = 1;
    spline.closed = line.closed;
    spline.controlPoints = line.points;
    const std::vector<double>& t = line.parameters;
    spline.knots.push_back(line.closed ? t.back() - 1.0 : t.front());
    spline.knots.insert(spline.knots.end(), t.begin(), t.end());
    spline.knots.push_back(1.0);
    if (line.closed) {
        spline.controlPoints.push_back(line.points.front());
        spline.knots.push_back(1.0 + t[1]);
    }
    return spline;
}

std::vector<char> facesWithin(
    const Surface& surface, const SurfacePolyline& line, const OffsetOptions& options
) {
    checkInput(surface, line, options);
    const DistanceBeams beams(surface, line, options.distance);
    std::vector<char> within(surface.faceCount(), 0);
    for (const int f : beams.reachedFaces()) {
        const SidedDistance middle =
            beams.at({.face = f, .barycentric = Vec3::Constant(1.0 / 3.0)});
        within[f] = middle.distance <= options.distance && isOn(middle.side, options.sides) ? 1 : 0;
    }
    return within;
}

}  // namespace bspline_curve
