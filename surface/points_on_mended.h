// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/repair.h"

#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// The way from points of a mesh as it was given to those of the mended one: the inverse of
/// MeshRepair::toOrigin().
class PointsOnMended {
public:
    /// `repair` must outlive this. O(n log n).
    explicit PointsOnMended(const MeshRepair& repair);

    /// None where the face was removed. In a face that was split, points up to kSnapBarycentric
    /// from the edge between its parts come onto it. O(log n).
    [[nodiscard]] std::optional<SurfacePoint> pointAt(const SurfacePoint& given) const;

    /// Throws InputError (NoPath), with the face, where pointAt() has none. Segments are not
    /// checked: a curve may pass from sheet to sheet where mending parts them. O(m log n).
    [[nodiscard]] SurfacePolyline lineAt(const SurfacePolyline& given) const;

private:
    const MeshRepair& repair_;
    std::vector<std::pair<int, int>> facesOf_;  ///< (given, mended), ascending
};

}  // namespace bspline_curve
