// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "surface/plane_vectors.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace bspline_curve {

/// The angle from one direction to another, counter-clockwise, in (-pi, pi].
[[nodiscard]] inline double angleBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::atan2(cross(a, b), a.dot(b));
}

/// A quarter turn to the left.
[[nodiscard]] inline Eigen::Vector2d turnedLeft(const Eigen::Vector2d& v) {
    return {-v.y(), v.x()};
}

/// A face laid in the plane: corner frame + 1 at the origin, corner frame + 2 on the positive x
/// axis, corner frame above it.
struct FaceLayout {
    FaceLayout(const std::vector<Vec3>& vertices, const Triangle& face, int frame) {
        const int a = (frame + 1) % 3;
        const int b = (frame + 2) % 3;
        const Vec3 base = vertices[face[b]] - vertices[face[a]];
        const Vec3 apex = vertices[face[frame]] - vertices[face[a]];
        const double length = base.norm();
        corners[a] = {0.0, 0.0};
        corners[b] = {length, 0.0};
        corners[frame] = {apex.dot(base) / length, base.cross(apex).norm() / length};
    }

    FaceLayout(double length, const Eigen::Vector2d& apex, int frame) {
        corners[(frame + 1) % 3] = {0.0, 0.0};
        corners[(frame + 2) % 3] = {length, 0.0};
        corners[frame] = apex;
    }

    [[nodiscard]] Eigen::Vector2d position(const Vec3& barycentric) const {
        return barycentric[0] * corners[0] + barycentric[1] * corners[1] +
               barycentric[2] * corners[2];
    }

    /// Length of the longest side.
    [[nodiscard]] double size() const {
        return std::max(
            {(corners[1] - corners[0]).norm(),
             (corners[2] - corners[1]).norm(),
             (corners[0] - corners[2]).norm()}
        );
    }

    /// At least the length of the longest side, and less than twice that.
    [[nodiscard]] double extent() const {
        double left = 0.0;
        double right = 0.0;
        double top = 0.0;
        for (const Eigen::Vector2d& corner : corners) {
            left = std::min(left, corner.x());
            right = std::max(right, corner.x());
            top = std::max(top, corner.y());
        }
        return right - left + top;
    }

    std::array<Eigen::Vector2d, 3> corners;
};

}  // namespace bspline_curve
