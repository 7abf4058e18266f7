// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/point_chart.h"

#include "bspline_curve/error.h"
#include "pattern/straightest_path.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace bspline_curve {

namespace {

/// The cosine of 20 degrees.
constexpr double kAlongNormal = 0.94;

}  // namespace

PointChart::PointChart(const Surface& surface, const SurfacePoint& centre, const Vec3& up)
    : surface_(surface), centre_(centre), fan_(fanOf(surface, centre)) {
    const std::optional<double> angle = angleOfDirection(surface, fan_, up);
    if (!angle) {
        throw InputError(
            InputErrorCode::BadOption,
            "up has no direction on the surface at the centre: it is the surface's normal there, "
            "or leads off the surface; give another up or another centre"
        );
    }
    up_ = *angle;
}

Vec3 PointChart::defaultUp(const Surface& surface, const SurfacePoint& centre) {
    return std::abs(surface.faceNormal(centre.face).y()) < kAlongNormal ? Vec3::UnitY()
                                                                        : Vec3::UnitZ();
}

CarriedPoint PointChart::at(const Eigen::Vector2d& point) const {
    const double distance = point.norm();
    if (distance == 0.0) {
        return {.point = centre_};
    }
    const double fromUp = std::atan2(point.y(), point.x()) - std::numbers::pi / 2;
    const double scale = fan_.closed ? fan_.angle / (2 * std::numbers::pi) : 1.0;
    const StraightestPath path =
        straightestPath(surface_, centre_, fan_, up_ + scale * fromUp, distance);
    if (!path.isWhole) {
        return {.status = CarriedPoint::Status::BeyondBoundary, .point = {}};
    }
    return {.point = path.points.back()};
}

}  // namespace bspline_curve
