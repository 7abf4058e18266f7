// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_checks.h"

#include "design/curve_designer.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace bspline_curve::test_support {
namespace {

std::size_t segmentCount(const SurfacePolyline& line) {
    return line.points.size() - (line.closed ? 0 : 1);
}

}  // namespace

double distanceToPolyline(const Vec3& p, const SurfacePolyline& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < segmentCount(line); ++i) {
        least = std::min(
            least, distanceToSegment(p, line.points[i], line.points[(i + 1) % line.points.size()])
        );
    }
    return least;
}

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

CurveDesigner designerIn(ShellKind kind, TriangleMesh mesh) {
    return CurveDesigner(std::move(mesh), {.kind = kind});
}

CurveDesigner EitherShell::designerOn(TriangleMesh mesh) {
    return designerIn(GetParam(), std::move(mesh));
}

std::string nameOf(ShellKind kind) {
    switch (kind) {
        case ShellKind::Simplified:
            return "Simplified";
        case ShellKind::FullResolution:
            return "FullResolution";
        case ShellKind::Local:
            return "Local";
    }
    return "";
}

std::string nameOfShell(const testing::TestParamInfo<ShellKind>& instance) {
    return nameOf(instance.param);
}

Vec3 pointOfSpline(const SplineData& spline, double t) {
    const int degree = spline.degree;
    const int last = static_cast<int>(spline.controlPoints.size()) - 1;
    int k = degree;
    while (k < last && spline.knots[k + 1] <= t) {
        ++k;
    }
    std::vector<Vec3> d;
    for (int j = 0; j <= degree; ++j) {
        d.push_back(spline.controlPoints[j + k - degree]);
    }
    for (int r = 1; r <= degree; ++r) {
        for (int j = degree; j >= r; --j) {
            const double left = spline.knots[j + k - degree];
            const double right = spline.knots[j + 1 + k - r];
            const double a = (t - left) / (right - left);
            d[j] = (1.0 - a) * d[j - 1] + a * d[j];
        }
    }
    return d[degree];
}

double largestGap(const SplineData& a, const SplineData& b, bool reversed, int count) {
    double largest = 0.0;
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        const double other = reversed ? 1.0 - t : t;
        largest = std::max(largest, (pointOfSpline(a, t) - pointOfSpline(b, other)).norm());
    }
    return largest;
}

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double squared = ab.squaredNorm();
    const double s = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
    return (p - (a + s * ab)).norm();
}

double largestDistance(const SurfacePolyline& a, const SurfacePolyline& b) {
    double largest = 0.0;
    for (const Vec3& p : a.points) {
        largest = std::max(largest, distanceToPolyline(p, b));
    }
    for (const Vec3& p : b.points) {
        largest = std::max(largest, distanceToPolyline(p, a));
    }
    return largest;
}

double length(const std::vector<Vec3>& points) {
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        sum += (points[i] - points[i - 1]).norm();
    }
    return sum;
}

double length(const SurfacePolyline& line) {
    const double closing = line.closed ? (line.points.front() - line.points.back()).norm() : 0.0;
    return length(line.points) + closing;
}

double turnsAboutZ(const SurfacePolyline& line, const Vec3& centre) {
    double angle = 0.0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec3 a = line.points[i] - centre;
        const Vec3 b = line.points[(i + 1) % line.points.size()] - centre;
        angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
    }
    return angle / (2.0 * std::numbers::pi);
}

void expectStrict(const Surface& surface, const SurfacePolyline& line) {
    constexpr double kRounding = 1e-14;
    const std::size_t n = line.points.size();
    ASSERT_GE(n, 2U);
    ASSERT_EQ(line.surfacePoints.size(), n);
    ASSERT_EQ(line.parameters.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
        const SurfacePoint& point = line.surfacePoints[i];
        ASSERT_GE(point.face, 0) << "vertex " << i;
        ASSERT_LT(point.face, surface.faceCount()) << "vertex " << i;
        EXPECT_GE(point.barycentric.minCoeff(), 0.0) << "vertex " << i;
        EXPECT_LE(point.barycentric.maxCoeff(), 1.0) << "vertex " << i;
        EXPECT_NEAR(point.barycentric.sum(), 1.0, kRounding) << "vertex " << i;
        const Triangle& face = surface.faces()[point.face];
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            position += point.barycentric[k] * surface.vertices()[face[k]];
        }
        const double magnitude = surface.diagonal() + position.norm();
        EXPECT_LE((position - line.points[i]).norm(), kRounding * magnitude) << "vertex " << i;
    }
    for (std::size_t i = 0; i < segmentCount(line); ++i) {
        const std::size_t next = (i + 1) % n;
        EXPECT_GE(commonFace(surface, line.surfacePoints[i], line.surfacePoints[next]), 0)
            << "segment " << i << " of " << n << ", t = " << line.parameters[i];
        EXPECT_GT((line.points[next] - line.points[i]).norm(), 0.0) << "segment " << i;
        if (next > 0) {
            EXPECT_LT(line.parameters[i], line.parameters[next]) << "segment " << i;
        }
    }
    EXPECT_EQ(line.parameters.front(), 0.0);
    if (line.closed) {
        EXPECT_LT(line.parameters.back(), 1.0);
    } else {
        EXPECT_EQ(line.parameters.back(), 1.0);
    }
}

void expectGoodCurve(
    const CurveDesigner& designer, const Curve& curve, const std::vector<Vec3>& picks
) {
    EXPECT_TRUE(curve.report.usable)
        << name(curve.report.status) << ", max distance " << curve.report.maxDistance << " edges";
    expectStrict(designer.surface(), curve.polyline);
    EXPECT_LE(curve.report.maxPickGap, 1e-9);
    ASSERT_EQ(curve.polyline.picks.size(), picks.size());
    ASSERT_EQ(curve.spline.pickParameters.size(), picks.size());
    const double near = 1e-9 * designer.surface().diagonal();
    int before = -1;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const int index = curve.polyline.picks[i];
        ASSERT_GT(index, before) << "pick " << i;
        ASSERT_LT(index, static_cast<int>(curve.polyline.points.size())) << "pick " << i;
        before = index;
        EXPECT_LE((curve.polyline.points[index] - picks[i]).norm(), near) << "pick " << i;
        const double t = curve.spline.pickParameters[i];
        EXPECT_EQ(curve.polyline.parameters[index], t) << "pick " << i;
        EXPECT_LE((pointOfSpline(curve.spline, t) - picks[i]).norm(), near) << "pick " << i;
    }
    EXPECT_EQ(curve.polyline.picks.front(), 0);
}

Curve goodCurve(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const CurveInputs& inputs
) {
    Curve curve = designer.design(picks, options, {}, inputs);
    expectGoodCurve(designer, curve, picks);
    return curve;
}

void expectSameBits(const Curve& curve, const Curve& reference) {
    EXPECT_EQ(curve.spline.knots, reference.spline.knots);
    EXPECT_TRUE(curve.spline.controlPoints == reference.spline.controlPoints)
        << "gap " << largestGap(curve.spline, reference.spline);
    EXPECT_TRUE(curve.polyline.points == reference.polyline.points);
    EXPECT_EQ(curve.polyline.parameters, reference.polyline.parameters);
    EXPECT_EQ(curve.polyline.picks, reference.polyline.picks);
}

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
