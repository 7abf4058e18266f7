// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve_designer.h"
#include "filter_bspline_curve/layer_mesh.h"

#include <common/ml_document/mesh_document.h>

#include <QVariant>
#include <map>
#include <span>
#include <string>

namespace bspline_curve {

/// Adds a layer with the curve and makes it the current one: vertices in order with edges between
/// them, in the coordinates of the surface's layer and under its matrix, so that both stay
/// together. Per vertex: quality (the field or, where there is none, the spline's parameter t), the
/// surface's normal, colour, and the custom attributes face_index (in the surface's layer),
/// barycentric, t.
MeshModel& addCurveLayer(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerMesh& mesh,
    const Curve& curve,
    std::span<const double> field
);

/// What the filter answers with; lengths and control points in world units.
[[nodiscard]] std::map<std::string, QVariant> figuresOf(
    const Curve& curve, const CurveDesigner& designer, double seconds
);

/// The scalar figures as one line "shell=cached key=value key=value ..." for the host's log.
[[nodiscard]] std::string logLine(
    const std::map<std::string, QVariant>& figures, const ShellSummary& shell
);

}  // namespace bspline_curve
