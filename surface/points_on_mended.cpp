// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/points_on_mended.h"

#include "bspline_curve/error.h"
#include "surface/surface_point.h"

#include <Eigen/LU>

#include <algorithm>
#include <string>

namespace bspline_curve {

PointsOnMended::PointsOnMended(const MeshRepair& repair) : repair_(repair) {
    facesOf_.reserve(repair.faceOrigins.size());
    for (int face = 0; face < static_cast<int>(repair.faceOrigins.size()); ++face) {
        facesOf_.emplace_back(repair.faceOrigins[face], face);
    }
    std::ranges::sort(facesOf_);
}

std::optional<SurfacePoint> PointsOnMended::pointAt(const SurfacePoint& given) const {
    SurfacePoint best;
    bool isInSplit = false;
    for (const auto& [origin, face] :
         std::ranges::equal_range(facesOf_, given.face, {}, &std::pair<int, int>::first)) {
        SurfacePoint point{.face = face, .barycentric = given.barycentric};
        bool isTurnedOnly = true;
        const auto changed = repair_.changedCorners.find(face);
        if (changed != repair_.changedCorners.end()) {
            const Eigen::Matrix3d& corners = changed->second;
            point.barycentric = corners.inverse() * given.barycentric;
            isTurnedOnly = (corners.array() == corners.array().square()).all();
        }
        if (!point.barycentric.allFinite()) {
            continue;  // the part of a split face that has no width but for rounding
        }
        if (best.face < 0 || point.barycentric.minCoeff() > best.barycentric.minCoeff()) {
            best = point;
            isInSplit = !isTurnedOnly;
        }
    }
    if (best.face < 0) {
        return std::nullopt;
    }
    return isInSplit ? snapped(best, kSnapBarycentric) : best;
}

SurfacePolyline PointsOnMended::lineAt(const SurfacePolyline& given) const {
    SurfacePolyline line = given;
    for (SurfacePoint& point : line.surfacePoints) {
        const std::optional<SurfacePoint> there = pointAt(point);
        if (!there) {
            throw InputError(
                InputErrorCode::NoPath,
                "the curve passes face " + std::to_string(point.face) +
                    ", which is left out of the mended mesh; draw it again",
                {point.face}
            );
        }
        point = *there;
    }
    return line;
}

}  // namespace bspline_curve
