// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/reopen.h"

#include "bspline_curve/mesh.h"
#include "filter_bspline_curve/common/curve_source.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {

namespace {

/// A pick stays where it is to within this, relative to the diagonal: more than the rounding of
/// floats, less than anybody moves a vertex.
constexpr double kSamePlace = 1e-6;

double diagonalOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices) {
        if (vertex.allFinite()) {
            box.extend(vertex);
        }
    }
    return box.diagonal().norm();
}

}  // namespace

std::optional<DrawnCurve> reopened(
    const MeshModel& layer, const MeshModel& surface, const LayerArrays& arrays
) {
    const CurveSource* const source = sourceOf(layer);
    if (source == nullptr || source->surface != surface.id() || !source->options) {
        return std::nullopt;
    }
    const TriangleMesh& mesh = arrays.input.mesh;
    const double tolerance = kSamePlace * diagonalOf(mesh);
    DrawnCurve curve;
    for (std::size_t i = 0; i < source->picks.size(); ++i) {
        SurfacePoint point = source->picks[i];
        const auto found = std::ranges::lower_bound(arrays.faceIds, point.face);
        if (found == arrays.faceIds.end() || *found != point.face) {
            return std::nullopt;
        }
        point.face = static_cast<int>(found - arrays.faceIds.begin());
        if (!((positionOf(mesh, point) - source->positions[i]).norm() <= tolerance)) {
            return std::nullopt;
        }
        curve.picks.push_back({point, source->positions[i]});
    }
    for (const int corner : source->corners) {
        curve.picks[corner].isCorner = true;
    }
    for (const auto& [pick, tangent] : source->tangents) {
        curve.picks[pick].tangent = tangent;
    }
    curve.options = *source->options;
    curve.options.closed = source->closed;
    curve.name = layer.label().toStdString();
    curve.colour = colourOf(layer);
    return curve;
}

}  // namespace bspline_curve
