// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strict_line.h"

#include "bspline_curve/error.h"
#include "surface/surface_point.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bspline_curve {

bool isStrict(const Surface& surface, const SurfacePolyline& line) {
    const std::vector<SurfacePoint>& points = line.surfacePoints;
    for (std::size_t i = line.closed ? 0 : 1; i < points.size(); ++i) {
        const SurfacePoint& before = points[i > 0 ? i - 1 : points.size() - 1];
        if (before.face != points[i].face && commonFace(surface, before, points[i]) < 0) {
            return false;
        }
    }
    return true;
}

SurfacePolyline strictLine(const Surface& surface, SurfacePolyline line, const std::string& name) {
    for (SurfacePoint& point : line.surfacePoints) {
        const std::optional<SurfacePoint> there = surface.provenance().fromInput(point);
        if (!there) {
            throw InputError(
                InputErrorCode::NoPath,
                name + " passes face " + std::to_string(point.face) +
                    ", which is left out of the mended mesh; draw it again",
                {point.face}
            );
        }
        point = *there;
    }
    if (!isStrict(surface, line)) {
        const bool isMended = !surface.provenance().isIdentity();
        throw InputError(
            InputErrorCode::NoPath,
            name + (isMended
                        ? ": a segment of the curve is not in one face of the mended mesh: it "
                          "passes from sheet to sheet at an edge of more than two faces, where "
                          "they are parted, or the curve is of another mesh; move its picks so "
                          "that it stays on one sheet"
                        : ": a segment of the curve is not in one face of this mesh; give the "
                          "mesh that it was drawn on, or draw it again")
        );
    }
    return line;
}

double lengthOf(const SurfacePolyline& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        length += (line.points[i] - line.points[i - 1]).norm();
    }
    return line.closed ? length + (line.points.front() - line.points.back()).norm() : length;
}

}  // namespace bspline_curve
