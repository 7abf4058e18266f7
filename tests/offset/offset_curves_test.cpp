// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets against exact answers: on the plane and on the sphere.
#include "offset/offset_curves.h"

#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "design/strict_polyline.h"
#include "offset/distance_beams.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

double lengthOf(const SurfacePolyline& line) {
    double length = 0.0;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + 1 < count + (line.closed ? 1 : 0); ++i) {
        length += (line.points[(i + 1) % count] - line.points[i]).norm();
    }
    return length;
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

/// One closed, strict piece, everywhere at its distance.
void expectRingAtDistance(const Surface& surface, const SurfacePolyline& curve, double distance) {
    const auto pieces = offsetPolylines(surface, curve, {.distance = distance});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0].closed);
    EXPECT_TRUE(isStrict(surface, pieces[0]));
    EXPECT_LT(planeError(curve, pieces[0], distance), 1e-3);
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
    const DistanceBeams beams(surface, curve, 1.0);
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
    EXPECT_TRUE(offsetPolylines(surface, curve, {.distance = 5.0}).empty());
}

}  // namespace

}  // namespace bspline_curve
