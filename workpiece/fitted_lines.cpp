// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/progress.h"
#include "imprint/projected_polyline.h"
#include "text/error_messages.h"

#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

std::vector<LineToFit> linesBetween(const TriangleMesh& mesh, std::span<const int> labels) {
    std::vector<LineToFit> lines;
    for (const BoundaryLine& boundary : boundaryLines(mesh, labels)) {
        LineToFit line{.points = {}, .closed = boundary.closed, .name = {}};
        for (const int vertex : boundary.vertices) {
            line.points.push_back(mesh.vertices[vertex]);
        }
        line.name = "the boundary of labels " + std::to_string(boundary.left) + " and " +
                    std::to_string(boundary.right) + " at vertex " +
                    std::to_string(boundary.vertices.front());
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<LineToFit> linesRound(const TriangleMesh& mesh, const Region& faces) {
    std::vector<int> labels(mesh.faces.size(), 0);
    for (const int face : faces) {
        labels[face] = 1;
    }
    std::vector<LineToFit> lines = linesBetween(mesh, labels);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lines[i].name = "boundary " + std::to_string(i + 1) + " of the faces";
    }
    return lines;
}

DrapedLines drapedLines(
    const Workpiece& workpiece, std::span<const LineToFit> lines, const Vec3& direction
) {
    DrapedLines result;
    std::vector<ProjectedLines> all;
    for (const LineToFit& line : lines) {
        all.push_back(projectedLines(
            workpiece, {.points = line.points, .closed = line.closed}, {.direction = direction}
        ));
        const std::vector<SurfacePolyline>& parts = all.back().lines;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::string name = parts.size() == 1
                                         ? line.name
                                         : "part " + std::to_string(i + 1) + " of " + line.name;
            result.lines.push_back({parts[i].points, parts[i].closed, name});
        }
    }
    const std::string which = lines.size() == 1
                                  ? lines.front().name
                                  : describeCount(lines.size(), "line", "lines") + " to fit";
    if (result.lines.empty()) {
        throw InputError(InputErrorCode::NoPath, which + kNothingMet);
    }
    if (const std::string note = projectionNote(all); !note.empty()) {
        result.notes.push_back(which + ": " + note);
    }
    return result;
}

FittedLines fitLines(
    const Workpiece& workpiece,
    std::span<const LineToFit> lines,
    const FitOptions& fit,
    const CurveOptions& options,
    const Progress& progress
) {
    FittedLines fitted;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LineToFit& line = lines[i];
        CurveOptions own = options;
        own.solver.closed = line.closed;
        try {
            DesignedCurve drawn =
                workpiece.fit(line.points, fit, own, stepOf(progress, i, lines.size()));
            for (const std::string& note : drawn.notes) {
                fitted.notes.push_back(line.name + ": " + note);
            }
            fitted.curves.push_back(std::move(drawn));
            fitted.lines.push_back(i);
        } catch (const InputError& error) {
            if (lines.size() == 1) {
                throw InputError(error.code(), line.name + ": " + error.what(), {}, error.remedy());
            }
            fitted.notes.push_back(line.name + " is left out: " + error.what());
        }
    }
    if (fitted.curves.empty()) {
        throw InputError(
            InputErrorCode::NoPath,
            lines.empty() ? "there is no line to follow: all faces have the same label"
                          : fitted.notes.front()
        );
    }
    return fitted;
}

}  // namespace bspline_curve
