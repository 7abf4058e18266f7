// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/pattern.h"
#include "pattern/carried_drawing.h"
#include "pattern/curve_chart.h"
#include "pattern/pattern_layout.h"
#include "pattern/point_chart.h"
#include "pattern/relief_smoothing.h"
#include "surface/picks.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"
#include "text/error_messages.h"
#include "workpiece/workpiece_parts.h"

#include <cmath>

namespace bspline_curve {

namespace {

SurfacePoint centreOn(const CurveDesigner& designer, const Vec3& centre) {
    if (!centre.allFinite()) {
        throw InputError(
            InputErrorCode::NonFiniteCoordinate, "the centre must have three finite coordinates"
        );
    }
    const TriangleTree::Closest closest = designer.tree().closestPoint(centre);
    const double away = std::sqrt(closest.squaredDistance);
    if (away > kPickReachRelative * designer.surface().diagonal()) {
        throw InputError(
            InputErrorCode::PickTooFar,
            "the centre is " + describeNumber(away) +
                " away from the mesh; give a point on it (within 1 % of its diagonal)"
        );
    }
    return snapped(closest.point, kOnEdgeBarycentric);
}

/// The surface that the ways of a drawing are found on: one of the same faces.
class WaySurface {
public:
    WaySurface(const Surface& detailed, int passes) : detailed_(detailed) {
        if (passes > 0) {
            smoothed_.emplace(smoothedRelief(detailed, passes));
        }
    }

    [[nodiscard]] const Surface& surface() const { return smoothed_ ? *smoothed_ : detailed_; }

private:
    const Surface& detailed_;
    std::optional<Surface> smoothed_;
};

}  // namespace

Pattern patternRoundPoint(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const Vec3& centre,
    const std::optional<Vec3>& up,
    const DrawingScale& scale,
    const PatternOptions& options,
    const Progress& progress
) {
    options.validate();
    const CurveDesigner& designer = designerOf(workpiece);
    const WaySurface ways(designer.surface(), options.smoothing);
    const Surface& surface = ways.surface();
    const SurfacePoint place = centreOn(designer, centre);
    const PointChart chart(surface, place, up ? *up : PointChart::defaultUp(surface, place));
    return carriedDrawing(
        designer,
        chart,
        laidRoundPoint(drawing, scale, designer.surface().diagonal()),
        options,
        progress
    );
}

Pattern patternAlongCurve(
    const Workpiece& workpiece,
    const Drawing& drawing,
    const SurfacePolyline& curve,
    const RowLayout& layout,
    const PatternOptions& options,
    const Progress& progress
) {
    options.validate();
    const CurveDesigner& designer = designerOf(workpiece);
    const WaySurface ways(designer.surface(), options.smoothing);
    const Surface& surface = ways.surface();
    const CurveChart chart(
        surface,
        strictLine(designer.surface(), curve, "the curve of the row"),
        surface.averageEdgeLength()
    );
    return carriedDrawing(
        designer,
        chart,
        laidAlongCurve(drawing, layout, chart.length(), chart.closed()),
        options,
        progress
    );
}

}  // namespace bspline_curve
