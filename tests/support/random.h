// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <random>

namespace bspline_curve::test_support {

/// Random numbers that are the same on every platform. Tests that use it print the seed on failure:
/// SCOPED_TRACE("seed " + std::to_string(seed)).
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [low, high).
    double uniform(double low, double high);
    /// In [low, high], both included.
    int integer(int low, int high);
    /// Uniform in the cube [low, high)^3.
    Vec3 point(double low, double high);
    /// Barycentric coordinates, uniform in the triangle.
    Vec3 barycentric();
    /// Barycentric coordinates inside of a triangle, on an edge, in a vertex, or next to them.
    Vec3 awkwardBarycentric();
    /// A rotation by a random angle about a random axis, then a translation of at most `reach`
    /// along each axis.
    Eigen::Isometry3d isometry(double reach);

private:
    std::mt19937_64 engine_;
};

}  // namespace bspline_curve::test_support
