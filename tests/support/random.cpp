// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/random.h"

#include <numbers>

namespace bspline_curve::test_support {

double Random::uniform(double low, double high) {
    // The distributions of <random> differ between libraries; the engine does not.
    const double unit = static_cast<double>(engine_() >> 11U) * 0x1p-53;
    return low + unit * (high - low);
}

int Random::integer(int low, int high) {
    const auto range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % range);
}

Vec3 Random::point(double low, double high) {
    const double x = uniform(low, high);
    const double y = uniform(low, high);
    const double z = uniform(low, high);
    return {x, y, z};
}

Vec3 Random::barycentric() {
    const double a = uniform(0.0, 1.0);
    const double b = uniform(0.0, 1.0);
    return a + b < 1.0 ? Vec3(a, b, 1.0 - a - b) : Vec3(1.0 - a, 1.0 - b, a + b - 1.0);
}

Vec3 Random::awkwardBarycentric() {
    Vec3 b = barycentric();
    const int corner = integer(0, 2);
    switch (integer(0, 4)) {
        case 0:
            b[corner] = 0.0;
            break;
        case 1:
            return Vec3::Unit(corner);
        case 2:
            b[corner] = 1e-11;
            break;
        case 3:
            b[corner] = 1e4;
            break;
        default:
            break;
    }
    return b / b.sum();
}

Eigen::Isometry3d Random::isometry(double reach) {
    Vec3 axis = point(-1.0, 1.0);
    while (axis.squaredNorm() > 1.0 || axis.squaredNorm() < 0.01) {
        axis = point(-1.0, 1.0);
    }
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    Eigen::Isometry3d motion(Eigen::AngleAxisd(angle, axis.normalized()));
    motion.pretranslate(point(-reach, reach));
    return motion;
}

}  // namespace bspline_curve::test_support
