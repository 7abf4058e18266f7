// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/faired_shape.h"

#include <algorithm>

namespace bspline_curve {

FairedShape::Derivatives FairedShape::at(double parameter) const {
    if (empty()) {
        return {Vec3::Zero(), Vec3::Zero()};
    }
    const auto above = std::ranges::upper_bound(points, parameter, {}, &Point::parameter);
    const auto next = std::clamp<std::ptrdiff_t>(above - points.begin(), 1, std::ssize(points) - 1);
    const Point& a = points[next - 1];
    const Point& b = points[next];
    const double gap = b.parameter - a.parameter;
    const double s = std::clamp((parameter - a.parameter) / gap, 0.0, 1.0);
    return {
        strength / gap * (b.position - a.position), strength * ((1.0 - s) * a.second + s * b.second)
    };
}

HeldPoints::HeldPoints(const FairedShape& shape, const SplineSpace& space)
    : first_(space.spanCount() + 1, 0) {
    points_.reserve(shape.points.size());
    int span = 0;
    for (const FairedShape::Point& point : shape.points) {
        if (point.share == 0.0) {
            continue;
        }
        while (span + 1 < space.spanCount() && point.parameter > space.breaks()[span + 1]) {
            first_[++span] = points_.size();
        }
        const double tau = (point.parameter - space.breaks()[span]) / space.spanLength(span);
        points_.push_back(
            {tau,
             shape.strength * shape.stiffness * point.share,
             point.position,
             space.basisAt(span, tau)}
        );
    }
    while (span < space.spanCount()) {
        first_[++span] = points_.size();
    }
}

}  // namespace bspline_curve
