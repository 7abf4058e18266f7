// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets against exact answers: on the plane and on the sphere.
#include "offset/offset_curves.h"

#include "bspline_curve/error.h"
#include "design/curve_designer.h"
#include "imprint/imprint.h"
#include "offset/distance_beams.h"
#include "shell/extended_surface.h"
#include "support/meshes.h"
#include "surface/strict_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

SurfacePolyline drawn(const TriangleMesh& mesh, const std::vector<Vec3>& picks, bool closed) {
    const CurveDesigner designer(mesh);
    SolverOptions options;
    options.closed = closed;
    return designer.design(picks, options).polyline;
}

double distanceTo(const SurfacePolyline& line, const Vec3& point) {
    double best = 1e300;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + 1 < count + (line.closed ? 1 : 0); ++i) {
        const Vec3& a = line.points[i];
        const Vec3 along = line.points[(i + 1) % count] - a;
        const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (point - a - t * along).norm());
    }
    return best;
}

/// Largest error of vertices and middles of segments, in distances.
double planeError(const SurfacePolyline& curve, const SurfacePolyline& offset, double distance) {
    double worst = 0.0;
    const std::size_t count = offset.points.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const Vec3 middle = 0.5 * (offset.points[i] + offset.points[i + 1]);
        worst = std::max(worst, std::abs(distanceTo(curve, offset.points[i]) - distance));
        worst = std::max(worst, std::abs(distanceTo(curve, middle) - distance));
    }
    return worst / distance;
}

/// Strict pieces, everywhere at their distance, that make one ring together.
void expectRingAtDistance(const Surface& surface, const SurfacePolyline& curve, double distance) {
    const auto pieces = offsetPolylines(surface, curve, {.distance = distance});
    ASSERT_GE(pieces.size(), 1U);
    Vec3 ends = Vec3::Zero();
    for (const SurfacePolyline& piece : pieces) {
        EXPECT_TRUE(isStrict(surface, piece));
        EXPECT_LT(planeError(curve, piece, distance), 1e-3);
        ends += piece.closed ? Vec3::Zero().eval() : Vec3(piece.points.back() - piece.points[0]);
    }
    EXPECT_LT(ends.norm(), 1e-14);
}

std::vector<FittedLine> fittedBeside(
    const Surface& surface, const SurfacePolyline& curve, const OffsetOptions& options
) {
    const ExtendedSurface extended = extendSurface(surface, ShellOptions().smoothingPasses);
    return offsetCurves(surface, extended, curve, options);
}

/// Neither a piece with itself nor with another.
bool doCross(const Surface& surface, const std::vector<FittedLine>& pieces) {
    std::vector<SurfacePolyline> lines;
    for (const FittedLine& piece : pieces) {
        lines.push_back(piece.line);
    }
    return !imprint(surface, lines, {}).crossings.empty();
}

/// Where the spline of a piece is at a parameter.
Vec3 splineAt(const SplineData& spline, double t) {
    const int degree = spline.degree;
    const auto count = static_cast<int>(spline.controlPoints.size());
    int k = degree;
    while (k + 1 < count && spline.knots[k + 1] <= t) {
        ++k;
    }
    std::vector<Vec3> points(
        spline.controlPoints.begin() + k - degree, spline.controlPoints.begin() + k + 1
    );
    for (int r = 1; r <= degree; ++r) {
        for (int j = degree; j >= r; --j) {
            const double low = spline.knots[j + k - degree];
            const double share = (t - low) / (spline.knots[j + 1 + k - r] - low);
            points[j] = (1 - share) * points[j - 1] + share * points[j];
        }
    }
    return points[degree];
}

/// Cubic, everywhere at the distance, and each vertex where the spline is.
void expectFitted(const SurfacePolyline& curve, const FittedLine& piece, double distance) {
    EXPECT_TRUE(piece.isFitted);
    EXPECT_EQ(piece.spline.degree, 3);
    for (const Vec3& point : piece.line.points) {
        ASSERT_NEAR(distanceTo(curve, point), distance, 1e-3 * distance);
    }
    EXPECT_NEAR(piece.deviation, planeError(curve, piece.line, distance), 1e-6);
    EXPECT_LT(piece.deviation, 1e-3);
    EXPECT_LT(5 * piece.spline.controlPoints.size(), piece.line.points.size());
    for (std::size_t i = 0; i < piece.line.points.size(); ++i) {
        const Vec3 at = splineAt(piece.spline, piece.line.parameters[i]);
        ASSERT_LT((at - piece.line.points[i]).norm(), 1e-9) << i;
    }
}

TEST(OffsetCurves, OfACurveOnAPlaneAreAtTheirDistanceWhateverTheFaces) {
    for (const int cells : {2, 9, 60}) {
        const TriangleMesh mesh = jitteredPlate(cells, cells, 0.25, 7);
        const Surface surface(mesh);
        const SurfacePolyline curve =
            drawn(mesh, {{0.25, 0.4, 0}, {0.5, 0.6, 0}, {0.75, 0.4, 0}}, false);
        for (const double distance : {0.02, 0.08, 0.2}) {
            SCOPED_TRACE(testing::Message() << cells << " cells, distance " << distance);
            expectRingAtDistance(surface, curve, distance);
        }
    }
}

TEST(OffsetCurves, HaveTheLengthOfAStadium) {
    const TriangleMesh mesh = jitteredPlate(20, 20, 0.25, 3);
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(mesh, {{0.3, 0.5, 0}, {0.7, 0.5, 0}}, false);
    const double distance = 0.1;
    const auto pieces = offsetPolylines(surface, curve, {.distance = distance});
    ASSERT_EQ(pieces.size(), 1U);
    const double exact = 2 * lengthOf(curve) + 2 * std::numbers::pi * distance;
    EXPECT_NEAR(lengthOf(pieces[0]), exact, 1e-3 * exact);
}

/// The least and the greatest of a coordinate, or of what `value` makes of the points.
template <class Value>
std::pair<double, double> rangeOf(const SurfacePolyline& line, const Value& value) {
    std::pair<double, double> range(1e300, -1e300);
    for (const Vec3& point : line.points) {
        range = {std::min(range.first, value(point)), std::max(range.second, value(point))};
    }
    return range;
}

/// The one piece on a side.
SurfacePolyline onSide(
    const Surface& surface, const SurfacePolyline& curve, double distance, OffsetSides sides
) {
    auto pieces = offsetPolylines(surface, curve, {.distance = distance, .sides = sides});
    EXPECT_EQ(pieces.size(), 1U);
    return pieces.empty() ? SurfacePolyline{} : pieces.front();
}

TEST(OffsetCurves, HaveFewPointsOnLargeFaces) {
    // Two faces, over which a search in steps of the distance has 131,000 places each.
    const TriangleMesh mesh = plate(1, 1);
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(mesh, {{0.2, 0.3, 0}, {0.8, 0.4, 0}}, false);
    constexpr double kDistance = 0.01;
    const DistanceBeams beams(surface, curve, {.from = 0.9 * kDistance, .to = 1.1 * kDistance});
    const auto lines = wholeLinesAt(surface, beams, kDistance, OffsetOptions().step);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed && isStrict(surface, lines[0]));
    EXPECT_LT(planeError(curve, lines[0], kDistance), 3e-4);
    EXPECT_LT(lines[0].points.size(), 400U);
}

TEST(OffsetCurves, AreFittedByFewControlPointsOnAPlane) {
    for (const int cells : {9, 60}) {
        const TriangleMesh mesh = jitteredPlate(cells, cells, 0.25, 7);
        const Surface surface(mesh);
        const SurfacePolyline curve =
            drawn(mesh, {{0.25, 0.4, 0}, {0.5, 0.6, 0}, {0.75, 0.4, 0}}, false);
        for (const double distance : {0.02, 0.08, 0.2}) {
            SCOPED_TRACE(testing::Message() << cells << " cells, distance " << distance);
            const auto pieces = fittedBeside(surface, curve, {.distance = distance});
            ASSERT_GE(pieces.size(), 1U);
            for (const FittedLine& piece : pieces) {
                EXPECT_TRUE(isStrict(surface, piece.line));
                expectFitted(curve, piece, distance);
            }
            EXPECT_FALSE(doCross(surface, pieces));
        }
    }
}

/// The closed line of a mesh at a height.
SurfacePolyline sectionAt(const Surface& surface, double height) {
    const auto above = [&](int f, int k) {
        return surface.vertices()[surface.faces()[f][k]].z() > height;
    };
    // The side through which the line leaves a face, with what is above to its left.
    const auto exitOf = [&](int f) {
        int k = 0;
        while (k < 3 && !(above(f, (k + 1) % 3) && !above(f, (k + 2) % 3))) {
            ++k;
        }
        return k;
    };
    int first = 0;
    while (exitOf(first) == 3) {
        ++first;
    }
    SurfacePolyline line;
    line.closed = true;
    int face = first;
    do {
        const int k = exitOf(face);
        const double high = surface.vertices()[surface.faces()[face][(k + 1) % 3]].z();
        const double low = surface.vertices()[surface.faces()[face][(k + 2) % 3]].z();
        SurfacePoint point{.face = face};
        point.barycentric[(k + 1) % 3] = (height - low) / (high - low);
        point.barycentric[(k + 2) % 3] = 1 - point.barycentric[(k + 1) % 3];
        line.surfacePoints.push_back(point);
        line.points.push_back(surface.position(point));
        line.parameters.push_back(static_cast<double>(line.points.size()));
        face = surface.faceNeighbours()[face][k];
    } while (face != first);
    for (double& t : line.parameters) {
        t = (t - 1) / static_cast<double>(line.points.size());
    }
    return line;
}

TEST(OffsetCurves, OfACircleOfLatitudeAreCirclesOfLatitude) {
    const TriangleMesh mesh = icosphere(6);
    const Surface surface(mesh);
    const double latitude = 0.4;
    const SurfacePolyline curve = sectionAt(surface, std::sin(latitude));
    ASSERT_TRUE(isStrict(surface, curve));
    for (const double distance : {0.1, 0.3, 0.6}) {
        SCOPED_TRACE(distance);
        const auto pieces = fittedBeside(surface, curve, {.distance = distance});
        ASSERT_EQ(pieces.size(), 2U);
        for (const FittedLine& piece : pieces) {
            EXPECT_TRUE(piece.isFitted && piece.line.closed);
            EXPECT_LT(piece.deviation, 1e-3);
            for (const Vec3& point : piece.line.points) {
                const double away = std::abs(std::asin(point.normalized().z()) - latitude);
                ASSERT_NEAR(away, distance, 1e-3 * distance);
            }
        }
        EXPECT_FALSE(doCross(surface, pieces));
    }
}

TEST(OffsetCurves, AreFittedWhereTheyBendBehindVertices) {
    // Behind each bump the line bends a little, by less than what is cut as a corner.
    const Surface surface(withNoise(icosphere(4), 0.01, 3));
    const SurfacePolyline curve = sectionAt(surface, 0.3);
    for (const double distance : {0.1, 0.3}) {
        SCOPED_TRACE(distance);
        for (const FittedLine& piece : fittedBeside(surface, curve, {.distance = distance})) {
            EXPECT_TRUE(piece.isFitted);
            EXPECT_TRUE(isStrict(surface, piece.line));
            EXPECT_LE(piece.deviation, OffsetOptions().tolerance);
        }
    }
}

TEST(OffsetCurves, AreCutAtCorners) {
    // Two sides of a right angle, rounded by the curve with a small radius: the inner offset has
    // one corner, and is symmetric about the diagonal.
    const TriangleMesh mesh = jitteredPlate(30, 30, 0.2, 5);
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(
        mesh,
        {{0.2, 0.9, 0},
         {0.2, 0.5, 0},
         {0.2, 0.25, 0},
         {0.25, 0.2, 0},
         {0.5, 0.2, 0},
         {0.9, 0.2, 0}},
        false
    );
    const auto pieces = fittedBeside(surface, curve, {.distance = 0.2, .sides = OffsetSides::Left});
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_FALSE(doCross(surface, pieces));
    const std::array ends{
        pieces[0].line.points.front(),
        pieces[0].line.points.back(),
        pieces[1].line.points.front(),
        pieces[1].line.points.back()
    };
    const bool meet = ends[0] == ends[3] || ends[1] == ends[2];
    EXPECT_TRUE(meet);
    const Vec3 corner = ends[0] == ends[3] ? ends[0] : ends[1];
    EXPECT_NEAR(corner.x(), 0.4, 0.03);
    EXPECT_NEAR(corner.y(), 0.4, 0.03);
    for (const FittedLine& piece : pieces) {
        expectFitted(curve, piece, 0.2);
    }
}

TEST(OffsetCurves, LieOnTheSideThatIsAskedFor) {
    const TriangleMesh mesh = plate(20, 20);
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(mesh, {{0.3, 0.5, 0}, {0.7, 0.5, 0}}, false);
    const auto height = [](const Vec3& point) { return point.y(); };
    for (const OffsetSides sides : {OffsetSides::Left, OffsetSides::Right}) {
        const SurfacePolyline piece = onSide(surface, curve, 0.11, sides);
        EXPECT_FALSE(piece.closed);
        EXPECT_NEAR(lengthOf(piece), lengthOf(curve), 0.02);
        const double y = sides == OffsetSides::Left ? 0.61 : 0.39;
        EXPECT_NEAR(rangeOf(piece, height).first, y, 1e-4);
        EXPECT_NEAR(rangeOf(piece, height).second, y, 1e-4);
    }
}

TEST(OffsetCurves, OfACircleOfASphereAreCirclesToTheMeshsError) {
    const TriangleMesh mesh = icosphere(6);
    const Surface surface(mesh);
    const double latitude = 0.4;
    std::vector<Vec3> picks;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * std::numbers::pi * i / 12;
        picks.emplace_back(
            std::cos(latitude) * std::cos(angle),
            std::cos(latitude) * std::sin(angle),
            std::sin(latitude)
        );
    }
    const SurfacePolyline curve = drawn(mesh, picks, true);
    const auto latitudeOf = [](const Vec3& point) { return std::asin(point.normalized().z()); };
    // The curve is no exact circle: distances are measured from the band that it stays in.
    const auto [low, high] = rangeOf(curve, latitudeOf);
    EXPECT_LT(high - low, 0.01);
    const double distance = 0.3;
    const auto left = rangeOf(onSide(surface, curve, distance, OffsetSides::Left), latitudeOf);
    EXPECT_GT(left.first, low + distance * (1 - 1e-3));
    EXPECT_LT(left.second, high + distance * (1 + 1e-3));
    const auto right = rangeOf(onSide(surface, curve, distance, OffsetSides::Right), latitudeOf);
    EXPECT_GT(right.first, low - distance * (1 + 1e-3));
    EXPECT_LT(right.second, high - distance * (1 - 1e-3));
}

TEST(OffsetCurves, EndWhereTheyRunIntoEachOther) {
    // A U: its arms are 0.2 apart, so that at 0.12 the offset does not enter between them.
    const TriangleMesh mesh = jitteredPlate(25, 25, 0.25, 11);
    const Surface surface(mesh);
    SurfacePolyline curve;
    const CurveDesigner designer(mesh);
    curve =
        designer
            .design({{0.4, 0.75, 0}, {0.4, 0.4, 0}, {0.5, 0.3, 0}, {0.6, 0.4, 0}, {0.6, 0.75, 0}})
            .polyline;
    const auto pieces = offsetPolylines(surface, curve, {.distance = 0.12});
    ASSERT_GE(pieces.size(), 1U);
    for (const SurfacePolyline& piece : pieces) {
        EXPECT_TRUE(isStrict(surface, piece));
        EXPECT_LT(planeError(curve, piece, 0.12), 1e-3);
    }
}

TEST(OffsetCurves, GoRoundASaddleVertexByItsAngles) {
    // Beyond the inner corner of an L the nearest points are seen around that corner.
    TriangleMesh mesh = plate(20, 20);
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        const Vec3 middle =
            (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3;
        return middle.x() > 0.5 && middle.y() > 0.5;
    });
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(mesh, {{0.42, 0.8, 0}, {0.42, 0.95, 0}}, false);
    const DistanceBeams beams(surface, curve, {.from = 0.0, .to = 1.0});
    double worst = 0.0;
    for (int f = 0; f < surface.faceCount(); ++f) {
        const SurfacePoint middle{.face = f, .barycentric = Vec3::Constant(1.0 / 3.0)};
        const Vec3 at = surface.position(middle);
        const Vec3 corner(0.5, 0.5, 0);
        const Vec3 end = curve.points.front();
        // Whether the straight way to the curve's end passes the cut.
        const double bend = (corner - end).cross(at - end).z();
        double exact = distanceTo(curve, at);
        if (at.x() > 0.5 && bend > 0) {
            exact = (corner - end).norm() + (at - corner).norm();
        }
        if (exact < 0.99) {
            worst = std::max(worst, std::abs(beams.at(middle).distance - exact));
        }
    }
    EXPECT_LT(worst, 1e-6);
}

TEST(OffsetCurves, RefuseDistancesThatAreNone) {
    const TriangleMesh mesh = plate(4, 4);
    const Surface surface(mesh);
    const SurfacePolyline curve = drawn(mesh, {{0.3, 0.5, 0}, {0.7, 0.5, 0}}, false);
    EXPECT_THROW((void)offsetPolylines(surface, curve, {.distance = 0.0}), InputError);
    EXPECT_THROW((void)offsetPolylines(surface, curve, {.distance = std::nan("")}), InputError);
    EXPECT_THROW((void)offsetPolylines(surface, {}, {.distance = 0.1}), InputError);
    EXPECT_THROW(
        (void)offsetPolylines(surface, curve, {.distance = 1, .tolerance = 0}), InputError
    );
    EXPECT_TRUE(offsetPolylines(surface, curve, {.distance = 5.0}).empty());
}

}  // namespace

}  // namespace bspline_curve
