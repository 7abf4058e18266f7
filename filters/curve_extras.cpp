// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_extras.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "design/curve_tube.h"
#include "filters/utf8_path.h"
#include "surface/surface.h"
#include "text/error_messages.h"

namespace bspline_curve {

namespace {

ControlPolygon controlPolygonOf(const SplineData& spline) {
    ControlPolygon polygon{.points = spline.controlPoints, .closed = spline.closed};
    if (spline.closed) {
        const auto repeated = static_cast<std::size_t>(spline.degree);
        polygon.points.resize(polygon.points.size() - repeated);
    }
    return polygon;
}

}  // namespace

void checkSaveFile(const CurveRequest& request) {
    if (!request.saveFile.empty()) {
        const std::filesystem::path file = utf8Path(request.saveFile);
        checkCurveExtension(file);
        checkWritable(file);
    }
}

void checkTube(const CurveRequest& request, const Workpiece& workpiece) {
    if (request.tubeRadius > workpiece.diagonal()) {
        throw InputError(
            InputErrorCode::BadOption,
            "tube radius is " + describeNumber(request.tubeRadius) +
                ", but must be at most the diagonal of the mesh, " +
                describeNumber(workpiece.diagonal())
        );
    }
}

void addExtras(
    const CurveRequest& request,
    const Workpiece& workpiece,
    std::span<const double> along,
    CurveResult& result
) {
    const Curve& curve = result.curve;
    if (request.tubeRadius > 0.0) {
        result.tube = makeTube(curve.polyline.points, curve.polyline.closed, request.tubeRadius);
    }
    if (request.controlPolygon) {
        result.controlPolygon = controlPolygonOf(curve.spline);
    }
    if (request.shellLayers) {
        result.shellLayers = workpiece.shellLayers();
    }
    if (request.saveFile.empty()) {
        return;
    }
    writeCurve(utf8Path(request.saveFile), curve, along, workpiece.checksum());
}

}  // namespace bspline_curve
