// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/predicates.h"

#include <tetgen.h>

#include <array>

namespace bspline_curve::detail {

namespace {

using Point = std::array<double, 3>;

/// TetGen's orient3d with its constants set up once, without the static filter, whose bound would
/// hold for one bounding box only.
double tetgenOrient3d(Point a, Point b, Point c, Point d) {
    static const bool initialised = [] {
        constexpr int kVerbose = 0;
        constexpr int kNoExact = 0;
        constexpr int kNoFilter = 1;
        exactinit(kVerbose, kNoExact, kNoFilter, 1.0, 1.0, 1.0);
        return true;
    }();
    static_cast<void>(initialised);
    return orient3d(a.data(), b.data(), c.data(), d.data());
}

int signOf(double value) {
    return (value > 0.0 ? 1 : 0) - (value < 0.0 ? 1 : 0);
}

}  // namespace

int exactOrientationSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto point = [](const Vec3& p) { return Point{p[0], p[1], p[2]}; };
    // orient3d(p, q, r, s) is the determinant of (p-s, q-s, r-s): with s = a it is our volume.
    return signOf(tetgenOrient3d(point(b), point(c), point(d), point(a)));
}

int exactProjectedOrientationSign(const Vec3& a, const Vec3& b, const Vec3& c, int droppedAxis) {
    const int x = (droppedAxis + 1) % 3;
    const int y = (droppedAxis + 2) % 3;
    const auto flat = [&](const Vec3& p) { return Point{p[x], p[y], 0.0}; };
    // The rows of the determinant are (b-a, 0), (c-a, 0) and (0, 0, 1): it is the area of a, b, c.
    return signOf(tetgenOrient3d(flat(b), flat(c), Point{a[x], a[y], 1.0}, flat(a)));
}

}  // namespace bspline_curve::detail
