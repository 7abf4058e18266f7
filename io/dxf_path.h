// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dxf_entities.h"
#include "io/space_paths.h"

#include <Eigen/Geometry>

#include <span>

namespace bspline_curve {

/// Whether an entity is one that pathOfDxf() makes paths of.
[[nodiscard]] bool isDxfCurve(const DxfEntity& entity);

/// The curve of an entity: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, SPLINE, or POLYLINE with the
/// VERTEX entities behind it; without arcs where it is another one. Throws InputError
/// (UnreadableFile) naming the line where it cannot be drawn.
[[nodiscard]] SpacePath pathOfDxf(const DxfEntity& entity, std::span<const DxfEntity> vertices);

/// From an entity's own coordinates, at a height, to those of the drawing.
[[nodiscard]] Eigen::Affine3d ownDxfPlane(const DxfEntity& entity, double height);

/// Every point of a path mapped.
[[nodiscard]] SpacePath mapped(SpacePath path, const Eigen::Affine3d& map);

}  // namespace bspline_curve
