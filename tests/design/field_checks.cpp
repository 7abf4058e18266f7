// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_checks.h"

#include <cstddef>

namespace bspline_curve::test_support {
namespace {

/// By the trapezoidal rule; `isCounted` and `value` take the index of a vertex.
template <class IsCounted, class Value>
double meanOver(const SurfacePolyline& line, const IsCounted& isCounted, const Value& value) {
    double sum = 0.0;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        if (isCounted(i) && isCounted(i + 1)) {
            const double step = (line.points[i + 1] - line.points[i]).norm();
            sum += 0.5 * (value(i) + value(i + 1)) * step;
            length += step;
        }
    }
    return sum / length;
}

}  // namespace

std::vector<double> sampled(
    const TriangleMesh& mesh, const std::function<double(const Vec3&)>& function
) {
    std::vector<double> values;
    for (const Vec3& v : mesh.vertices) {
        values.push_back(function(v));
    }
    return values;
}

double valueAt(
    const Surface& surface, const SurfacePoint& point, const std::vector<double>& field
) {
    const Triangle& face = surface.faces()[point.face];
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        value += point.barycentric[static_cast<Eigen::Index>(k)] * field[face[k]];
    }
    return value;
}

double meanAlong(
    const Surface& surface, const SurfacePolyline& line, const std::vector<double>& field
) {
    return meanOver(
        line,
        [](std::size_t) { return true; },
        [&](std::size_t i) { return valueAt(surface, line.surfacePoints[i], field); }
    );
}

double meanWhere(
    const SurfacePolyline& line,
    const std::function<double(const Vec3&)>& function,
    const std::function<bool(const Vec3&)>& isCounted
) {
    return meanOver(
        line,
        [&](std::size_t i) { return isCounted(line.points[i]); },
        [&](std::size_t i) { return function(line.points[i]); }
    );
}

}  // namespace bspline_curve::test_support
