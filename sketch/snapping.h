// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sketch/sketch.h"
#include "surface/surface.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// What picks snap to, besides what the mesh and the sketch show by themselves.
struct SnapOptions {
    double creaseAngle = 40.0;  ///< edges whose faces' normals differ by more are creases, degrees
    /// Fields of FieldKind::Ridge and FieldKind::Valley, one value per vertex; null: picks do not
    /// snap to these.
    std::shared_ptr<const std::vector<double>> ridge, valley;
    /// Least value of a vertex on a ridge or in a valley: that of a cylinder whose radius is a
    /// tenth of the diagonal.
    double leastCrest = 0.5;
};

enum class SnapKind { None, Pick, Boundary, Crease, Ridge, Valley, Vertex };

/// For people: "a boundary", "a ridge", …; empty for None.
[[nodiscard]] const char* nameOf(SnapKind kind);

struct Snap {
    SnapKind kind = SnapKind::None;
    SurfacePoint point;  ///< unchanged where nothing is near
};

/// The feature to which a point of a surface snaps: of those within `reach` (user's unit) along
/// connected faces the nearest pick of a curve that is shown and other than `own` (-1: any), else
/// the nearest point of a boundary or crease edge, else the vertex with the largest ridge or
/// valley, else the nearest vertex. Linear in the number of faces within reach.
[[nodiscard]] Snap snap(
    const Surface& surface,
    const Sketch& sketch,
    int own,
    const SurfacePoint& point,
    double reach,
    const SnapOptions& options = {}
);

}  // namespace bspline_curve
