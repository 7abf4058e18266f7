// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

// A candidate is optimal if it sees every normal at least as well as its supports; rounding of unit
// vectors aside.
constexpr double kRounding = 1e-12;

struct Best {
    Vec3 direction = Vec3::Zero();
    double cosine = -2.0;

    void offer(const Vec3& candidate, std::span<const Vec3> normals) {
        const double length = candidate.norm();
        if (length < kRounding) {
            return;
        }
        const Vec3 unit = candidate / length;
        const double least = leastCosine(unit, normals);
        if (least > cosine) {
            cosine = least;
            direction = unit;
        }
    }
};

}  // namespace

Vec3 directionOfLeastAngle(std::span<const Vec3> normals) {
    // The smallest spherical cap around the normals touches two or three of them (a cap of one is
    // the trivial case). Start with the most opposed pair: it supports the cap in most cases, and
    // is then optimal.
    Best best;
    const std::size_t m = normals.size();
    if (m == 1) {
        return normals[0];
    }
    double mostOpposed = 2.0;
    Vec3 bisector = Vec3::Zero();
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            const double cosine = normals[i].dot(normals[j]);
            if (cosine < mostOpposed) {
                mostOpposed = cosine;
                bisector = normals[i] + normals[j];
            }
        }
    }
    best.offer(bisector, normals);
    const double bound = std::sqrt(std::max(0.0, 0.5 * (1.0 + mostOpposed)));
    if (best.cosine >= bound - kRounding) {
        return best.direction;
    }
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            for (std::size_t k = j + 1; k < m; ++k) {
                Vec3 pole = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                if (pole.dot(normals[i]) < 0.0) {
                    pole = -pole;
                }
                best.offer(pole, normals);
            }
        }
    }
    if (best.cosine < -1.0) {
        best.direction = normals.empty() ? Vec3::UnitZ() : normals[0];
    }
    return best.direction;
}

}  // namespace bspline_curve
