// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings on surfaces: on a plane they come out as drawn.
#include "pattern/carried_drawing.h"

#include "bspline_curve/drawing_builder.h"
#include "bspline_curve/pattern.h"
#include "design/curve_designer.h"
#include "pattern/curve_chart.h"
#include "pattern/pattern_layout.h"
#include "pattern/point_chart.h"
#include "pattern/relief_smoothing.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "surface/segment_distance.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;
using Vec2 = Eigen::Vector2d;

constexpr double kPi = std::numbers::pi;

/// A square, a circle in it, an open curve and a line.
Drawing shapes() {
    DrawingBuilder pen;
    pen.moveTo({-1, -1});
    pen.lineTo({1, -1});
    pen.lineTo({1, 1});
    pen.lineTo({-1, 1});
    pen.close();
    pen.moveTo({0.5, 0});
    pen.follow(ellipticalArc(Vec2::Zero(), {0.5, 0}, {0, 0.5}, 0.0, 2 * kPi));
    pen.close();
    pen.moveTo({-0.9, 0});
    pen.curveTo({{-0.9, 0.6}, {-0.2, 0.9}, {0.6, 0.8}});
    pen.moveTo({-0.8, -0.7});
    pen.lineTo({0.7, -0.9});
    return pen.take();
}

/// The largest distance of points of a drawing to curves, in the plane z = 0, less `centre`.
double farthest(const Drawing& drawing, const Pattern& pattern, const Vec3& centre) {
    double worst = 0.0;
    for (const SmoothPiece& piece : smoothPieces(drawing, 0.3)) {
        for (int i = 0; i <= 50 * static_cast<int>(piece.arcs.size()); ++i) {
            const Vec2 flat = piece.at(i / 50.0);
            const Vec3 point = centre + Vec3(flat.x(), flat.y(), 0.0);
            double least = 1e300;
            for (const PatternCurve& each : pattern.curves) {
                const SurfacePolyline& line = each.curve.polyline;
                const std::size_t count = line.points.size();
                for (std::size_t v = 0; v + (line.closed ? 0 : 1) < count; ++v) {
                    least = std::min(
                        least,
                        distanceToSegment(point, line.points[v], line.points[(v + 1) % count])
                    );
                }
            }
            worst = std::max(worst, least);
        }
    }
    return worst;
}

PointChart chartAt(const CurveDesigner& designer, const Vec3& centre) {
    return {
        designer.surface(),
        snapped(designer.tree().closestPoint(centre).point, kOnEdgeBarycentric),
        Vec3::UnitY()
    };
}

TEST(CarriedDrawing, ComesOutAsDrawnOnAPlane) {
    const Vec3 centre(0.5, 0.5, 0.0);
    for (const int cells : {1, 14}) {
        const CurveDesigner designer(jitteredPlate(cells, cells, 0.25, 8));
        const Drawing drawing = laidRoundPoint(shapes(), {.size = 0.8}, 1.0);
        const PointChart chart = chartAt(designer, centre);
        const Pattern coarse = carriedDrawing(designer, chart, drawing, {.tolerance = 1e-3});
        EXPECT_LT(farthest(drawing, coarse, centre), 1e-3);
        const Pattern fine = carriedDrawing(designer, chart, drawing, {.tolerance = 1e-5});
        EXPECT_LT(farthest(drawing, fine, centre), 2e-5);
        EXPECT_LE(fine.largestDeviation, 1e-5);
        EXPECT_NEAR(fine.shortest.ratio, 1.0, 1e-3);
        EXPECT_NEAR(fine.longest.ratio, 1.0, 1e-3);
    }
}

TEST(CarriedDrawing, PartsPathsAtCornersWhereCurvesMeetExactly) {
    const CurveDesigner designer(icosphere(4));
    const Pattern pattern = carriedDrawing(
        designer,
        chartAt(designer, Vec3(0.2, 0.3, 0.9).normalized()),
        laidRoundPoint(shapes(), {.size = 0.9}, 1.0),
        {}
    );
    ASSERT_EQ(pattern.curves.size(), 7U);  // four sides, a circle, a curve, a line
    EXPECT_TRUE(pattern.curves[4].curve.polyline.closed);
    for (int side = 0; side < 4; ++side) {
        const SurfacePolyline& line = pattern.curves[side].curve.polyline;
        const SurfacePolyline& next = pattern.curves[(side + 1) % 4].curve.polyline;
        EXPECT_FALSE(line.closed);
        EXPECT_EQ(pattern.curves[side].path, 0);
        EXPECT_EQ(line.points.back(), next.points.front());
    }
    for (const PatternCurve& each : pattern.curves) {
        EXPECT_TRUE(each.curve.report.usable);
        EXPECT_TRUE(isStrict(designer.surface(), each.curve.polyline));
    }
    // Vertices of the sphere bend what passes them.
    EXPECT_LE(pattern.largestDeviation, 0.05 * designer.surface().averageEdgeLength());
    // On a sphere circles round the centre become shorter.
    EXPECT_LT(pattern.shortest.ratio, 0.99);
    EXPECT_GT(pattern.shortest.ratio, 0.9);
}

TEST(CarriedDrawing, NamesPathsThatTheBoundaryCuts) {
    const CurveDesigner designer(plate(6, 6));
    expectRefused(
        [&] {
            return carriedDrawing(
                designer,
                chartAt(designer, {0.5, 0.5, 0}),
                laidRoundPoint(shapes(), {.size = 1.2}, 1.0),
                {}
            );
        },
        InputErrorCode::NoPath,
        "path 0 of the drawing",
        std::vector<std::int64_t>{0, 2, 3}
    );
}

TEST(CarriedDrawing, RepeatsAMotifRoundAClosedCurve) {
    const TriangleMesh mesh = torus(48, 24);
    const CurveDesigner designer(mesh);
    SolverOptions closed;
    closed.closed = true;
    const SurfacePolyline ring =
        designer.design({{1.3, 0, 0}, {0, 1.3, 0}, {-1.3, 0, 0}, {0, -1.3, 0}}, closed).polyline;
    const CurveChart chart(designer.surface(), ring, 0.05);
    DrawingBuilder pen;  // a battlement: its ends meet those of the next copy
    pen.moveTo({0, 0});
    pen.lineTo({0, 0.1});
    pen.lineTo({0.5, 0.1});
    pen.lineTo({0.5, 0});
    pen.lineTo({1, 0});
    const Drawing row =
        laidAlongCurve(pen.take(), {.scale = {}, .repeat = 9}, chart.length(), true);
    ASSERT_EQ(row.paths.size(), 9U);
    const Pattern pattern = carriedDrawing(designer, chart, row, {});
    ASSERT_EQ(pattern.curves.size(), 36U);
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_EQ(pattern.curves[i].copy, static_cast<int>(i / 4));
        EXPECT_EQ(
            pattern.curves[i].curve.polyline.points.back(),
            pattern.curves[(i + 1) % 36].curve.polyline.points.front()
        );
    }
    // Wide on the outer equator of the torus, shorter to both of its sides.
    EXPECT_LE(pattern.longest.ratio, 1.001);
}

TEST(CarriedDrawing, ComesOutMoreEvenlyWhereARoughSurfaceIsSmoothed) {
    const Workpiece workpiece(withNoise(icosphere(4), 0.008, 3));
    const Vec3 centre = Vec3(0.2, 0.3, 0.9).normalized();
    const auto worst = [&](int passes) {
        const Pattern pattern = patternRoundPoint(
            workpiece, shapes(), centre, std::nullopt, {.size = 0.9}, {.smoothing = passes}
        );
        return std::max(pattern.longest.ratio - 1.0, 1.0 - pattern.shortest.ratio);
    };
    EXPECT_LT(worst(5), 0.6 * worst(0));
}

TEST(ReliefSmoothing, LeavesWhatIsFlat) {
    const Surface surface(jitteredPlate(9, 9, 0.25, 3));
    const TriangleMesh smoothed = smoothedRelief(surface, 7);
    EXPECT_EQ(smoothed.vertices, surface.vertices());
    EXPECT_EQ(smoothed.faces, surface.faces());
    const Surface sphere(icosphere(3));
    for (const Vec3& vertex : smoothedRelief(sphere, 10).vertices) {
        EXPECT_NEAR(vertex.norm(), 1.0, 0.01);
    }
}

TEST(PatternLayout, FitsCopiesToTheCurve) {
    DrawingBuilder pen;
    pen.moveTo({3, 5});
    pen.lineTo({5, 6});
    const Drawing motif = pen.take();
    const auto starts = [&](const RowLayout& layout, bool closed) {
        std::vector<double> result;
        for (const DrawingPath& path : laidAlongCurve(motif, layout, 10.0, closed).paths) {
            result.push_back(path.arcs.front().points.front().x());
        }
        return result;
    };
    using Places = std::vector<double>;
    EXPECT_EQ(starts({.scale = {.scale = 1.0}}, false), Places({0}));
    EXPECT_EQ(starts({.scale = {.scale = 1.0}, .repeat = 3}, false), Places({0, 4, 8}));
    EXPECT_EQ(starts({.scale = {.scale = 1.0}, .spacing = 3.0}, false), Places({0, 3, 6}));
    EXPECT_EQ(
        starts({.scale = {.size = 2.0}, .spacing = 4.0, .start = 1.0}, false), Places({1, 5})
    );
    EXPECT_EQ(starts({.scale = {.scale = 1.0}, .spacing = 2.6}, true), Places({0, 2.5, 5, 7.5}));
    EXPECT_EQ(starts({.scale = {}, .repeat = 2}, true), Places({0, 5}));
    expectRefused(
        [&] { return starts({.scale = {.size = 11.0}}, false); },
        InputErrorCode::BadOption,
        "longer than the curve"
    );
    expectRefused(
        [&] { return starts({.scale = {.size = 1.0, .scale = 1.0}}, false); },
        InputErrorCode::BadOption,
        "exclude"
    );
}

TEST(Drawing, HasTheBoxOfItsArcs) {
    DrawingBuilder pen;
    pen.moveTo({0, 0});
    pen.curveTo({{0, 1}, {2, 1}, {2, 0}});
    EXPECT_NEAR(pen.take().box().max().y(), 0.75, 1e-9);
    const auto arcs = ellipticalArc(Vec2::Zero(), {2, 0}, {0, 3}, kPi / 4, kPi);
    pen.moveTo(arcs.front().points.front());
    pen.follow(arcs);
    const auto box = pen.take().box();
    EXPECT_NEAR(box.max().y(), 3.0, 1e-9);
    EXPECT_NEAR(box.min().x(), -2.0, 1e-9);
}

TEST(Drawing, ClosesPathsWhoseEndsMeet) {
    DrawingBuilder pen;
    pen.moveTo({0, 0});
    pen.lineTo({1, 0});
    pen.lineTo({1, 1});
    pen.lineTo({1e-8, -1e-8});
    const Drawing drawing = pen.take();
    ASSERT_EQ(drawing.paths.size(), 1U);
    EXPECT_TRUE(drawing.paths[0].closed);
    EXPECT_EQ(drawing.paths[0].arcs.size(), 3U);
    EXPECT_EQ(smoothPieces(drawing, 0.5).size(), 3U);
    EXPECT_EQ(smoothPieces(drawing, 3.0).size(), 1U);
}

TEST(Drawing, LeavesOutSpecksWhereItIsParted) {
    for (const double speck : {1e-7, 1e-9, 1e-12}) {
        DrawingBuilder pen;
        pen.moveTo({0, 0});
        pen.lineTo({1, 0});
        pen.lineTo({1, speck});  // a corner, at rounding size
        pen.lineTo({1, 1});
        pen.lineTo({0, 1});
        pen.close();
        const Drawing drawing = pen.take();
        const std::vector<SmoothPiece> pieces = smoothPieces(drawing, 0.5);
        ASSERT_EQ(pieces.size(), 4U);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_EQ(
                pieces[i].arcs.back().points.back(), pieces[(i + 1) % 4].arcs.front().points.front()
            );
        }
    }
}

TEST(Drawing, WithHugeNumbersIsRefused) {
    const Workpiece workpiece(test_support::icosphere(1));
    DrawingBuilder pen;
    pen.moveTo({-1.7e308, 0});
    pen.lineTo({1.7e308, 1});
    const Drawing drawing = pen.take();
    test_support::expectRefused(
        [&] {
            return patternRoundPoint(
                workpiece, drawing, workpiece.mesh().vertices[0], Vec3(1, 2, 3), {.size = 0.1}, {}
            );
        },
        InputErrorCode::BadOption,
        "the drawing has"
    );
}

}  // namespace

}  // namespace bspline_curve
