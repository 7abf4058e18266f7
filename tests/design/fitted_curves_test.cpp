// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth curves along lines that are there already, judged from the outside.
#include "bspline_curve/error.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/spline.h"
#include "design/curve_checks.h"
#include "support/meshes.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

struct Line {
    std::vector<Vec3> points;
    bool closed = false;
};

/// The longest boundary of the faces whose middle is in a region.
Line boundaryOf(const TriangleMesh& mesh, const std::function<bool(const Vec3&)>& isInside) {
    std::vector<int> labels;
    for (const Triangle& face : mesh.faces) {
        const Vec3 sum = mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]];
        labels.push_back(isInside(sum / 3.0) ? 1 : 0);
    }
    const std::vector<BoundaryLine> lines = boundaryLines(mesh, labels);
    const auto longest = std::ranges::max_element(lines, {}, [](const BoundaryLine& line) {
        return line.vertices.size();
    });
    Line line{{}, longest->closed};
    for (const int vertex : longest->vertices) {
        line.points.push_back(mesh.vertices[vertex]);
    }
    return line;
}

SolverOptions optionsOf(const Line& line) {
    SolverOptions options;
    options.closed = line.closed;
    return options;
}

double distanceToLine(const Vec3& point, const Line& line) {
    double least = std::numeric_limits<double>::infinity();
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
        least =
            std::min(least, distanceToSegment(point, line.points[i], line.points[(i + 1) % count]));
    }
    return least;
}

/// Fits, and expects a strict curve that keeps the deviation.
Curve fitted(const CurveDesigner& designer, const Line& line, const FitOptions& fit = {}) {
    Curve curve = designer.fit(line.points, fit, optionsOf(line));
    EXPECT_TRUE(curve.report.usable);
    expectStrict(designer.surface(), curve.polyline);
    const double edge = designer.surface().averageEdgeLength();
    const double allowed = fit.deviation.value > 0.0 ? fit.deviation.in(edge) : edge;
    double farthest = 0.0;
    for (const Vec3& point : curve.polyline.points) {
        farthest = std::max(farthest, distanceToLine(point, line));
    }
    EXPECT_LE(farthest, allowed);
    // Between its points the line runs along the surface, here straight.
    EXPECT_GE(curve.report.lineDistance.value_or(0.0), 0.99 * farthest);
    return curve;
}

double rootMeanSquare(
    const SurfacePolyline& line, const std::function<double(const Vec3&)>& distance
) {
    double sum = 0.0;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const double step = (line.points[i + 1] - line.points[i]).norm();
        const double d = distance(0.5 * (line.points[i] + line.points[i + 1]));
        sum += step * d * d;
        length += step;
    }
    return std::sqrt(sum / length);
}

TEST(FittedCurves, AreNearTheCircleThatJaggedBoundariesFollow) {
    const CurveDesigner designer(jitteredPlate(60, 60, 0.2, 3));
    const Vec3 centre(0.47, 0.52, 0.0);
    constexpr double kRadius = 0.31;
    const auto offCircle = [&](const Vec3& p) { return std::abs((p - centre).norm() - kRadius); };
    const Line line =
        boundaryOf(designer.mesh(), [&](const Vec3& p) { return (p - centre).norm() < kRadius; });
    ASSERT_TRUE(line.closed);
    const double edge = designer.surface().averageEdgeLength();
    for (const FitOptions& fit : {FitOptions{}, FitOptions{{1.0, true}}}) {
        const Curve curve = fitted(designer, line, fit);
        EXPECT_LE(rootMeanSquare(curve.polyline, offCircle), 0.1 * edge);
        EXPECT_LE(
            std::abs(length(curve.polyline) / (2.0 * std::numbers::pi * kRadius) - 1.0), 0.02
        );
    }
}

/// A plate in pleats that lean over each other.
TriangleMesh pleated(TriangleMesh mesh) {
    constexpr double kWaves = 2.0 * std::numbers::pi * 6.0;
    for (Vec3& p : mesh.vertices) {
        const double wave = kWaves * p.x();
        p = {p.x() + std::sin(wave) / 40.0, p.y(), std::cos(wave) / 60.0};
    }
    return mesh;
}

TEST(FittedCurves, NeedFewKnotsAcrossPleats) {
    for (const unsigned seed : {1U, 3U}) {
        const TriangleMesh plate = jitteredPlate(60, 60, 0.2, seed);
        const Line flat = boundaryOf(plate, [&](const Vec3& p) {
            return (p - Vec3(0.47, 0.52, 0.0)).norm() < 0.31;
        });
        const CurveDesigner designer(pleated(plate));
        const Line line{pleated({flat.points, {}}).vertices, flat.closed};
        const Curve curve = fitted(designer, line, {{1.0, true}});
        EXPECT_LE(curve.spline.controlPoints.size(), 90U);
    }
}

TEST(FittedCurves, FollowStrokesThatShake) {
    const CurveDesigner designer(icosphere(4));
    std::mt19937 random(8);
    std::normal_distribution<double> noise(0.0, 0.02);
    Line stroke;
    const auto wave = [](double t) {
        return Vec3(std::cos(t), std::sin(t), 0.3 * std::sin(2.0 * t)).normalized();
    };
    constexpr int kPoints = 200;
    for (int i = 0; i <= kPoints; ++i) {
        const Vec3 shaken =
            wave(2.5 * i / kPoints) + Vec3(noise(random), noise(random), noise(random));
        stroke.points.push_back(shaken.normalized());
    }
    const Curve curve = fitted(designer, stroke, {{0.08, false}});
    const auto off = [&](const Vec3& p) {
        double least = 1.0;
        for (int i = 0; i <= 2000; ++i) {
            least = std::min(least, (p.normalized() - wave(2.5 * i / 2000.0)).norm());
        }
        return least;
    };
    EXPECT_LE(rootMeanSquare(curve.polyline, off), 0.012);
    EXPECT_LE(curve.spline.controlPoints.size(), 100U);
}

TEST(FittedCurves, HaveNoCornersWhereBoundariesAreJagged) {
    for (const unsigned seed : {3U, 4U, 5U}) {
        const CurveDesigner designer(jitteredPlate(60, 60, 0.2, seed));
        for (const double radius : {0.1, 0.2, 0.4}) {
            const Line line = boundaryOf(designer.mesh(), [&](const Vec3& p) {
                return (p - Vec3(0.47, 0.52, 0.0)).norm() < radius;
            });
            for (const FitOptions& fit : {FitOptions{}, FitOptions{{1.0, true}}}) {
                EXPECT_TRUE(cornersOf(fitted(designer, line, fit).spline).empty())
                    << "seed " << seed << ", radius " << radius;
            }
        }
    }
}

/// A square that stands on a corner, with half circles on its upper sides: a heart, whose corners
/// are the tip below and the notch above.
bool isInHeart(const Vec3& p) {
    constexpr double kHalfSide = 0.17;
    const double along = (p.x() + p.y() - 1.0) * std::numbers::sqrt2 / 2.0;
    const double across = (p.y() - p.x()) * std::numbers::sqrt2 / 2.0;
    return (std::abs(along) <= kHalfSide && std::abs(across) <= kHalfSide) ||
           std::hypot(along - kHalfSide, across) < kHalfSide ||
           std::hypot(along, across - kHalfSide) < kHalfSide;
}

/// Both corners are of 90 degrees, of which the steps of a boundary leave now and then less than
/// the 60 from which on fits have a corner.
TEST(FittedCurves, TurnAtTheCornersOfAHeart) {
    constexpr int kHearts = 10;
    const double corner = 0.17 * std::numbers::sqrt2;
    const Vec3 tip(0.5, 0.5 - corner, 0.0);
    const Vec3 notch(0.5, 0.5 + corner, 0.0);
    for (const FitOptions& fit : {FitOptions{}, FitOptions{{1.0, true}}}) {
        int found = 0;
        for (unsigned seed = 1; seed <= kHearts; ++seed) {
            SCOPED_TRACE(seed);
            const CurveDesigner designer(jitteredPlate(70, 70, 0.2, seed));
            const Line line = boundaryOf(designer.mesh(), isInHeart);
            const double edge = designer.surface().averageEdgeLength();
            const Curve curve = fitted(designer, line, fit);
            int tips = 0;
            int notches = 0;
            for (const int pick : cornersOf(curve.spline)) {
                const Vec3& point = curve.polyline.points[curve.polyline.picks[pick]];
                const bool isTip = (point - tip).norm() <= 1.5 * edge;
                const bool isNotch = (point - notch).norm() <= 1.5 * edge;
                EXPECT_TRUE(isTip || isNotch) << point.transpose();
                tips += isTip ? 1 : 0;
                notches += isNotch ? 1 : 0;
            }
            EXPECT_LE(tips, 1);
            EXPECT_LE(notches, 1);
            found += tips + notches;
            for (const double turn : curve.report.cornerTurns) {
                EXPECT_GE(turn, fit.cornerAngle);
                EXPECT_NEAR(turn, 90.0, 30.0);
            }
        }
        EXPECT_GE(found, 2 * kHearts - 3);
    }
    const CurveDesigner designer(jitteredPlate(70, 70, 0.2, 9));
    const Line line = boundaryOf(designer.mesh(), isInHeart);
    FitOptions without;
    without.cornerAngle = 180.0;
    EXPECT_TRUE(cornersOf(fitted(designer, line, without).spline).empty());
}

TEST(FittedCurves, TurnWhereAShakyStrokeDoes) {
    const CurveDesigner designer(plate(50, 50));
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, 0.004);
    Line stroke;
    for (int i = 0; i <= 200; ++i) {
        const double way = 0.006 * i - 0.6;
        stroke.points.emplace_back(
            std::min(way, 0.0) + 0.7 + noise(random), std::max(way, 0.0) + 0.2 + noise(random), 0.0
        );
    }
    const Curve curve = fitted(designer, stroke, {{0.02, false}});
    const std::vector<int> corners = cornersOf(curve.spline);
    ASSERT_EQ(corners.size(), 1U);
    const Vec3& at = curve.polyline.points[curve.polyline.picks[corners.front()]];
    EXPECT_LE((at - Vec3(0.7, 0.2, 0.0)).norm(), 0.01);
    EXPECT_NEAR(curve.report.cornerTurns.front(), 90.0, 10.0);
}

TEST(FittedCurves, KeepTheEndsOfOpenLines) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 5));
    const Line line = boundaryOf(designer.mesh(), [](const Vec3& p) {
        return p.y() < 0.5 + 0.2 * std::sin(4.0 * p.x());
    });
    ASSERT_FALSE(line.closed);
    const Curve curve = fitted(designer, line);
    EXPECT_LE((curve.polyline.points.front() - line.points.front()).norm(), 1e-12);
    EXPECT_LE((curve.polyline.points.back() - line.points.back()).norm(), 1e-12);
}

TEST(FittedCurves, ComeNearerWithTheDeviation) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 6));
    const Line line = boundaryOf(designer.mesh(), [](const Vec3& p) {
        return (p - Vec3(0.5, 0.5, 0.0)).norm() < 0.3;
    });
    double before = std::numeric_limits<double>::infinity();
    for (const double deviation : {1.0, 0.4}) {
        const Curve curve = fitted(designer, line, {{deviation, true}});
        EXPECT_LT(*curve.report.lineDistance, before);
        before = *curve.report.lineDistance;
    }
}

TEST(FittedCurves, FollowSmoothLinesToTheirOwnRoundings) {
    // A line without noise keeps its waves where no deviation is asked for.
    const CurveDesigner designer(plate(30, 30));
    Line line;
    for (int i = 0; i <= 300; ++i) {
        const double x = 0.1 + 0.8 * i / 300.0;
        line.points.emplace_back(x, 0.5 + 0.1 * std::sin(12.0 * x), 0.0);
    }
    const Curve curve = fitted(designer, line);
    EXPECT_LE(*curve.report.lineDistance, 1e-3);
}

TEST(FittedCurves, StayTheSameThroughTheirPicks) {
    const CurveDesigner designer(icosphere(4));
    const Line line = boundaryOf(designer.mesh(), [](const Vec3& p) { return p.z() > 0.4; });
    const Curve curve = fitted(designer, line);
    std::vector<Vec3> picks;
    for (const int vertex : curve.polyline.picks) {
        picks.push_back(curve.polyline.points[vertex]);
    }
    const Curve again = goodCurve(designer, picks, optionsOf(line));
    EXPECT_LE(
        largestDistance(curve.polyline, again.polyline),
        0.5 * designer.surface().averageEdgeLength()
    );
}

TEST(FittedCurves, OfFewPointsAreCurves) {
    const CurveDesigner designer(plate(20, 20));
    const auto& vertices = designer.mesh().vertices;
    static_cast<void>(fitted(designer, {{vertices[100], vertices[101]}, false}));
    static_cast<void>(fitted(designer, {{vertices[100], vertices[101], vertices[121]}, true}));
}

TEST(FittedCurves, OfMendedMeshesHaveTheIdsOfTheInput) {
    TriangleMesh mesh = plate(30, 30);
    std::reverse(mesh.faces.begin(), mesh.faces.end());
    mesh.faces.push_back({0, 0, 1});
    std::rotate(mesh.faces.rbegin(), mesh.faces.rbegin() + 1, mesh.faces.rend());
    const CurveDesigner designer(mesh);
    const Line line = boundaryOf(designer.mesh(), [](const Vec3& p) {
        return (p - Vec3(0.5, 0.5, 0.0)).norm() < 0.3;
    });
    const Curve curve = designer.fit(line.points, {}, optionsOf(line));
    for (std::size_t i = 0; i < curve.polyline.points.size(); ++i) {
        const SurfacePoint& point = curve.polyline.surfacePoints[i];
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            position += point.barycentric[k] * mesh.vertices[mesh.faces[point.face][k]];
        }
        ASSERT_LE((position - curve.polyline.points[i]).norm(), 1e-12);
    }
}

TEST(FittedCurves, SayWhatIsWrong) {
    const CurveDesigner designer(plate(20, 20));
    const Line line = boundaryOf(designer.mesh(), [](const Vec3& p) {
        return (p - Vec3(0.5, 0.5, 0.0)).norm() < 0.3;
    });
    const auto fitWith = [&](const FitOptions& fit) {
        return [&, fit] { return designer.fit(line.points, fit, optionsOf(line)); };
    };
    expectRefused(fitWith({{-1.0, false}}), InputErrorCode::BadOption, "deviation");
    FitOptions angle;
    angle.cornerAngle = 0.0;
    expectRefused(fitWith(angle), InputErrorCode::BadOption, "corner_angle");
    // Steps along edges turn by right angles, within a thousandth of an edge.
    expectRefused(fitWith({{1e-3, true}}), InputErrorCode::NoPath, "allow a larger deviation");
}

}  // namespace
}  // namespace bspline_curve
