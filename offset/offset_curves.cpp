// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/offset_curves.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "imprint/imprint.h"
#include "offset/distance_beams.h"
#include "offset/level_lines.h"
#include "offset/line_corners.h"
#include "surface/strict_line.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace bspline_curve {

namespace {

/// So far from the offset's distance others are known, in tolerances: what is farther off is off
/// the distance anyway.
constexpr double kMargin = 2.0;
/// Shares of the progress: up to the end of the distances, of the lines there, of their fits.
constexpr double kDistancesShare = 0.6, kLinesShare = 0.7, kFitsShare = 0.95;
/// Lines that cross are fitted again with this times the tolerance, so often at most.
constexpr double kCloser = 0.25;
constexpr int kCloserFits = 3;

DistanceRange rangeAround(const OffsetOptions& options) {
    const double margin = kMargin * options.tolerance * options.distance;
    return {.from = options.distance - margin, .to = options.distance + margin};
}

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

/// The pieces of all lines at the distance on the sides asked for, the longest first.
std::vector<SurfacePolyline> linesAt(
    const Surface& surface,
    const DistanceBeams& beams,
    const OffsetOptions& options,
    const Progress& progress
) {
    std::vector<std::pair<double, SurfacePolyline>> pieces;
    for (const LevelLine& level :
         levelLines(surface, beams, options.distance, options.step, progress)) {
        for (const LevelLine& part : partsOn(level, options.sides)) {
            for (const LevelLine& smooth : cutAtCorners(surface, part, options.distance)) {
                pieces.push_back(polylineOf(surface, smooth));
            }
        }
    }
    std::erase_if(pieces, [](const auto& piece) {
        const SurfacePolyline& line = piece.second;
        return line.points.size() < (line.closed ? 3U : 2U);
    });
    std::ranges::stable_sort(pieces, std::greater(), [](const auto& piece) { return piece.first; });
    std::vector<SurfacePolyline> result;
    for (auto& piece : pieces) {
        result.push_back(std::move(piece.second));
    }
    return result;
}

/// Lines that cross themselves or others, ascending.
std::vector<int> crossedLines(const Surface& surface, const std::vector<FittedLine>& fitted) {
    std::vector<SurfacePolyline> lines;
    for (const FittedLine& each : fitted) {
        lines.push_back(each.line);
    }
    if (lines.empty()) {
        return {};
    }
    const ImprintedMesh imprinted = imprintOwn(surface, lines, {});
    std::vector<int> crossed;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::vector<int>& vertices = imprinted.curves[i].vertices;
        if (std::ranges::any_of(vertices, [&](int v) {
                return indexIn(imprinted.crossings, v) >= 0;
            })) {
            crossed.push_back(static_cast<int>(i));
        }
    }
    return crossed;
}

/// The line with the surface's own faces.
SurfacePolyline checkedInput(
    const Surface& surface, const SurfacePolyline& line, const OffsetOptions& options
) {
    options.validate();
    if (line.surfacePoints.size() < 2) {
        throw InputError(
            InputErrorCode::NoPath,
            "the curve has fewer than 2 points; draw it with at least 2 picks"
        );
    }
    return strictLine(surface, line, "the curve to offset");
}

}  // namespace

void OffsetOptions::validate() const {
    if (!std::isfinite(distance) || distance <= 0.0) {
        throw InputError(InputErrorCode::BadOption, "distance must be a number above 0");
    }
    if (!std::isfinite(step) || step <= 0.0 || step > 1.0) {
        throw InputError(InputErrorCode::BadOption, "step must be above 0 and at most 1");
    }
    if (!std::isfinite(tolerance) || tolerance <= 0.0 || tolerance > 0.1) {
        throw InputError(InputErrorCode::BadOption, "tolerance must be above 0 and at most 0.1");
    }
}

std::vector<SurfacePolyline> wholeLinesAt(
    const Surface& surface,
    const DistanceBeams& beams,
    double distance,
    double step,
    const Progress& progress
) {
    std::vector<SurfacePolyline> lines;
    for (const LevelLine& level : levelLines(surface, beams, distance, step, progress)) {
        lines.push_back(polylineOf(surface, level).second);
    }
    std::erase_if(lines, [](const SurfacePolyline& line) {
        return line.points.size() < (line.closed ? 3U : 2U);
    });
    return lines;
}

std::vector<SurfacePolyline> offsetPolylines(
    const Surface& surface,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress
) {
    const DistanceBeams beams(
        surface,
        checkedInput(surface, line, options),
        rangeAround(options),
        partOf(progress, 0.0, kDistancesShare)
    );
    std::vector<SurfacePolyline> lines =
        linesAt(surface, beams, options, partOf(progress, kDistancesShare, 1.0));
    for (SurfacePolyline& each : lines) {
        surface.provenance().bringToInput(each);
    }
    return lines;
}

std::vector<FittedLine> offsetCurves(
    const Surface& surface,
    const ExtendedSurface& extended,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress
) {
    const DistanceBeams beams(
        surface,
        checkedInput(surface, line, options),
        rangeAround(options),
        partOf(progress, 0.0, kDistancesShare)
    );
    const std::vector<SurfacePolyline> lines =
        linesAt(surface, beams, options, partOf(progress, kDistancesShare, kLinesShare));
    const LineFitter fitter(surface, extended, beams, options.distance);
    std::vector<FittedLine> fitted;
    const Progress fits = partOf(progress, kLinesShare, kFitsShare);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        fitted.push_back(fitter.fitted(lines[i], options.tolerance, stepOf(fits, i, lines.size())));
    }
    double tolerance = options.tolerance;
    for (int attempt = 0; attempt <= kCloserFits; ++attempt) {
        report(progress, std::lerp(kFitsShare, 1.0, 0.2 * attempt), "looking for crossings");
        const std::vector<int> crossed = crossedLines(surface, fitted);
        if (crossed.empty()) {
            break;
        }
        tolerance *= kCloser;
        for (const int i : crossed) {
            fitted[i] = attempt < kCloserFits ? fitter.fitted(lines[i], tolerance)
                                              : fitter.unfitted(lines[i]);
        }
    }
    for (FittedLine& each : fitted) {
        surface.provenance().bringToInput(each.line);
    }
    return fitted;
}

std::vector<char> facesWithin(
    const Surface& surface,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress
) {
    const SurfacePolyline own = checkedInput(surface, line, options);
    // Sides are known where distances are.
    const bool needSides = options.sides != OffsetSides::Both;
    const DistanceRange range{.from = needSides ? 0.0 : options.distance, .to = options.distance};
    const DistanceBeams beams(surface, own, range, progress);
    std::vector<char> within(surface.faceCount(), 0);
    for (const int f : beams.reachedFaces()) {
        const SidedDistance middle =
            beams.at({.face = f, .barycentric = Vec3::Constant(1.0 / 3.0)});
        within[f] = middle.distance <= options.distance && isOn(middle.side, options.sides) ? 1 : 0;
    }
    return surface.provenance().flagsOfInput(std::move(within));
}

}  // namespace bspline_curve
