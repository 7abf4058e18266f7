// SPDX-License-Identifier: GPL-3.0-or-later
// Paths between picks: pulled taut, with chords close to the surface, and on it.
#include "curve_checks.h"
#include "design/close_chords.h"
#include "design/initial_path.h"
#include "design/shortened_path.h"
#include "surface/surface_point.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A path pulled taut; none where it is refused.
std::optional<ShortenedPath> shortened(
    const TestSurface& ground, const std::vector<Vec3>& way, const FieldTravel& travel = {}
) {
    return shortenPath(ground.extended, nullptr, travel, ground.nearest(way));
}

/// Its points.
std::vector<Vec3> taut(
    const TestSurface& ground, const std::vector<Vec3>& way, const FieldTravel& travel = {}
) {
    const std::optional<ShortenedPath> path = shortened(ground, way, travel);
    return path ? ground.positions(path->points) : std::vector<Vec3>{};
}

/// From (1, 0, 0) to (cos(angle), sin(angle), 0) on the unit sphere, `aside` of it half way and
/// winding beside that.
std::vector<Vec3> windingWay(double angle, double aside, double winding) {
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0;
        const double z = aside * std::sin(std::numbers::pi * t) + (i % 2 == 1 ? winding : 0.0);
        way.push_back(Vec3(std::cos(angle * t), std::sin(angle * t), z).normalized());
    }
    return way;
}

TEST(TautPaths, LieOnGreatCircles) {
    const TestSurface ground(icosphere(5));
    for (const double angle : {0.5, 1.5, 2.5}) {
        SCOPED_TRACE(angle);
        const std::vector<Vec3> points = taut(ground, windingWay(angle, 0.3, 0.05));
        ASSERT_FALSE(points.empty());
        for (const Vec3& point : points) {
            EXPECT_LT(std::abs(point.z()), 2e-3);
        }
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_NEAR((points[i] - points[i - 1]).norm() * 32.0 / angle, 1.0, 0.02);
        }
    }
}

TEST(TautPaths, HardlyDependOnTheWayThatTheyComeFrom) {
    const TestSurface ground(icosphere(5));
    const std::vector<Vec3> a = taut(ground, windingWay(1.5, 0.3, 0.05));
    const std::vector<Vec3> b = taut(ground, windingWay(1.5, -0.2, 0.1));
    ASSERT_EQ(std::min(a.size(), b.size()), 33U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a[i] - b[i]).norm(), 1e-3);
    }
}

TEST(TautPaths, FollowAValleyOfAField) {
    const TestSurface ground(plate(80, 80));
    const auto valley = [](double x) { return 0.5 + 0.1 * std::sin(2.0 * std::numbers::pi * x); };
    std::vector<double> costs;
    for (const Vec3& v : ground.surface.vertices()) {
        costs.push_back(std::min(1.0, std::abs(v.y() - valley(v.x())) / 0.1));
    }
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) {
        const double x = 0.1 + 0.02 * i;
        way.emplace_back(x, valley(x) + (i % 2 == 0 ? 0.0 : 0.04), 0.0);
    }
    const std::vector<Vec3> guided = taut(ground, way, {costs, 10.0, 0.0});
    ASSERT_FALSE(guided.empty());
    double aside = 0.0;
    for (const Vec3& point : guided) {
        aside += std::abs(point.y() - valley(point.x())) / static_cast<double>(guided.size());
    }
    EXPECT_LT(aside, 0.01);
    const std::vector<Vec3> straight = taut(ground, way);
    ASSERT_FALSE(straight.empty());
    for (const Vec3& point : straight) {
        const double share = (point.x() - way.front().x()) / 0.8;
        EXPECT_NEAR(point.y(), way.front().y() + share * (way.back().y() - way.front().y()), 1e-6);
    }
}

TEST(TautPaths, DoNotPassThroughAThinPlate) {
    const TestSurface ground(box(24, {1.0, 1.0, 0.01}));
    std::vector<Vec3> way;
    for (int i = 0; i <= 20; ++i) {
        way.emplace_back(0.7 + 0.3 * i / 20.0, 0.5, 0.01);
    }
    for (int i = 0; i <= 20; ++i) {
        way.emplace_back(1.0 - 0.3 * i / 20.0, 0.52, 0.0);
    }
    const std::optional<ShortenedPath> path = shortened(ground, way);
    double farthest = 0.0;
    for (const Vec3& point : taut(ground, way)) {
        farthest = std::max(farthest, point.x());
    }
    // None, or round the rim, or it says where it slipped through.
    EXPECT_TRUE(!path || farthest > 0.99 || !path->gaps.empty());
}

TEST(TautPaths, HaveGapsOnlyOverSharpEdges) {
    const TestSurface ground(wedge(100));
    const std::optional<ShortenedPath> path =
        shortened(ground, {{0.3, 0.4, 1.0}, {1.0, 0.5, 1.0}, {0.8, 0.6, 0.3}});
    ASSERT_TRUE(path);
    const std::vector<Vec3> points = ground.positions(path->points);
    EXPECT_EQ(points.size(), 33U);
    ASSERT_EQ(path->gaps.size(), 1U);
    EXPECT_GT(points[path->gaps.front()].z(), 1.0 - 1e-9);
    EXPECT_LT(points[path->gaps.front() + 1].z(), 1.0 - 1e-9);
    const TestSurface sphere(icosphere(5));
    EXPECT_TRUE(shortened(sphere, windingWay(1.5, 0.3, 0.05))->gaps.empty());
}

TEST(TautPaths, AreRefusedWithoutTwoEndsApart) {
    EXPECT_FALSE(shortened(TestSurface(plate(4, 4)), {{0.4, 0.4, 0.0}, {0.4, 0.4, 0.0}}));
}

// ---- Chords close to the surface ----

std::vector<Vec3> quarterOfCircle() {
    std::vector<Vec3> way;
    for (int i = 0; i <= 4; ++i) {
        const double angle = i * std::atan(1.0) / 2.0;
        way.emplace_back(std::cos(angle), std::sin(angle), 0.1);
    }
    return way;
}

class CloseChords : public testing::Test {
protected:
    /// `distance`: in user units.
    [[nodiscard]] static std::optional<std::vector<SurfacePoint>> close(
        const TestSurface& ground, const std::vector<SurfacePoint>& path, double distance
    ) {
        return withCloseChords(
            ground.extended, nullptr, path, distance / ground.extended.frame.scale
        );
    }

    [[nodiscard]] static double farthest(
        const TestSurface& ground, const std::vector<SurfacePoint>& path
    ) {
        return ground.farthestChord(ground.positions(path));
    }

    TestSurface sphere_{withNoise(icosphere(4), 0.01, 3)};
    std::vector<SurfacePoint> path_ = sphere_.nearest(quarterOfCircle());
};

TEST_F(CloseChords, LieWithinTheDistanceOfTheSurface) {
    std::size_t before = path_.size();
    for (const double distance : {1e-2, 1e-3, 1e-4}) {
        ASSERT_GT(farthest(sphere_, path_), distance);
        const auto chords = close(sphere_, path_, distance);
        ASSERT_TRUE(chords.has_value());
        EXPECT_LE(farthest(sphere_, *chords), distance);
        EXPECT_GT(chords->size(), before) << distance;
        before = chords->size();
    }
}

TEST_F(CloseChords, PassTheSamePointsInOrder) {
    const auto chords = close(sphere_, path_, 1e-3);
    ASSERT_TRUE(chords.has_value());
    auto passed = chords->begin();
    for (const SurfacePoint& point : path_) {
        passed = std::find_if(passed, chords->end(), [&](const SurfacePoint& other) {
            return other.face == point.face && other.barycentric == point.barycentric;
        });
        ASSERT_NE(passed, chords->end());
    }
    EXPECT_EQ(passed + 1, chords->end());
}

// Where chords are close none is halved. On a thin plate no chord from the lower side to the upper
// one can be close: each is halved on the lower side and leaves another one to halve.
TEST_F(CloseChords, StayWholeWhereTheyAreCloseAndEndAcrossAThinPlate) {
    const TestSurface flat(plate(20, 20));
    const auto whole = close(
        flat,
        flat.nearest(std::vector<Vec3>{{0.1, 0.2, 0.0}, {0.5, 0.7, 0.0}, {0.9, 0.1, 0.0}}),
        1e-9
    );
    ASSERT_TRUE(whole.has_value());
    EXPECT_EQ(whole->size(), 3U);
    const TestSurface thin(box(8, {1.0, 1.0, 0.01}));
    const auto across =
        close(thin, thin.nearest(std::vector<Vec3>{{0.2, 0.3, 0.0}, {0.8, 0.6, 0.01}}), 1e-9);
    ASSERT_TRUE(across.has_value());
    EXPECT_EQ(across->size(), 2U + 8U);
}

TEST_F(CloseChords, AreNoneOverASlit) {
    const int cells = 21;
    TriangleMesh bent = withoutFaces(plate(cells, cells), [](const Vec3& p) {
        return std::abs(p.x() - 0.5) < 0.5 / cells && std::abs(p.y() - 0.5) < 0.2;
    });
    for (Vec3& vertex : bent.vertices) {
        vertex.z() = 0.5 * vertex.x() * vertex.x();
    }
    const TestSurface ground(std::move(bent));
    const auto acrossAt = [&](double y) {
        const std::vector<Vec3> way = {{0.2, y, 0.02}, {0.8, y, 0.32}};
        return close(ground, ground.nearest(way), 1e-3);
    };
    EXPECT_TRUE(acrossAt(0.2).has_value());
    EXPECT_FALSE(acrossAt(0.5).has_value());
}

// ---- Initial paths ----

/// Paths on a rough sphere with as many faces as it takes to find ways among patches.
class InitialPaths : public testing::Test {
protected:
    static constexpr double kChordDistance = 1e-4;

    [[nodiscard]] PickPath path(PathKind kind, WorkerThread* side = nullptr) const {
        const std::vector<SurfacePoint> picks = {
            {0, Vec3(1.0, 0.0, 0.0)}, {7000, Vec3(0.2, 0.3, 0.5)}, {14000, Vec3(0.0, 0.5, 0.5)}
        };
        return makePickPath(
            ground_.surface,
            ground_.extended,
            picks,
            true,
            {.blockedFaces = {},
             .patches = &patches_,
             .kind = kind,
             .chordDistance = kChordDistance,
             .side = side}
        );
    }

    /// Between how many of its points a path leaves the surface.
    [[nodiscard]] int gapsIn(const PickPath& path) const {
        const std::vector<InitialPath::Point>& points = path.path.points;
        int gaps = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            gaps += commonFace(ground_.surface, points[i - 1].point, points[i].point) < 0 ? 1 : 0;
        }
        return gaps;
    }

    /// In the shell's frame.
    [[nodiscard]] double farthestChord(const PickPath& path) const {
        std::vector<Vec3> points = positions(path);
        for (Vec3& point : points) {
            point = ground_.extended.frame.toUser(point);
        }
        return ground_.farthestChord(points) / ground_.extended.frame.scale;
    }

    [[nodiscard]] static std::vector<Vec3> positions(const PickPath& path) {
        std::vector<Vec3> result;
        for (const InitialPath::Point& point : path.path.points) {
            result.push_back(point.position);
        }
        return result;
    }

private:
    TestSurface ground_{withNoise(icosphere(5), 0.003, 3)};
    PatchLevels patches_{ground_.surface};
};

TEST_F(InitialPaths, AreTheSameOnTwoThreads) {
    WorkerThread side;
    for (const PathKind kind : {PathKind::Quick, PathKind::Close, PathKind::OnSurface}) {
        const PickPath alone = path(kind);
        const PickPath both = path(kind, &side);
        ASSERT_EQ(alone.path.points.size(), both.path.points.size());
        for (std::size_t i = 0; i < alone.path.points.size(); ++i) {
            EXPECT_EQ(alone.path.points[i].parameter, both.path.points[i].parameter);
            EXPECT_EQ(alone.path.points[i].position, both.path.points[i].position);
        }
    }
}

TEST_F(InitialPaths, LieOnTheSurfaceWhereAsked) {
    const PickPath onSurface = path(PathKind::OnSurface);
    EXPECT_EQ(gapsIn(onSurface), 0);
    EXPECT_GT(gapsIn(path(PathKind::Quick)), 0);
    EXPECT_EQ(onSurface.path.points.back().parameter, 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(onSurface.path.points, {}, &InitialPath::Point::parameter));
}

TEST_F(InitialPaths, HaveChordsCloseToTheSurfaceWhereAsked) {
    EXPECT_GT(farthestChord(path(PathKind::Quick)), 10.0 * kChordDistance);
    EXPECT_LE(farthestChord(path(PathKind::Close)), kChordDistance);
}

TEST_F(InitialPaths, AreAsLongEitherWay) {
    const double quick = length(positions(path(PathKind::Quick)));
    EXPECT_NEAR(length(positions(path(PathKind::OnSurface))), quick, 0.02 * quick);
    EXPECT_NEAR(length(positions(path(PathKind::Close))), quick, 0.02 * quick);
}

// The way leads round the disc, and a string pulled taut would leave that way again.
TEST(InitialPathsBesideObstacles, StayOutside) {
    const TestSurface ground(plate(70, 70));
    const PatchLevels patches(ground.surface);
    ASSERT_FALSE(patches.levels().empty());
    const Region disc = facesWhere(ground.surface, ball({0.5, 0.5, 0.0}, 0.1));
    const Obstacles obstacles(ground.surface, ground.extended, disc, 0.02);
    const PickPath path = makePickPath(
        ground.surface,
        ground.extended,
        ground.nearest(std::vector<Vec3>{{0.1, 0.48, 0.0}, {0.9, 0.49, 0.0}}),
        false,
        {.blockedFaces = {}, .obstacles = &obstacles, .patches = &patches}
    );
    for (const InitialPath::Point& point : path.path.points) {
        EXPECT_FALSE(obstacles.isAvoided(point.point.face));
    }
}

/// A quick path between the points of a mesh that are nearest to two others.
std::vector<Vec3> quickPath(const TriangleMesh& mesh, const std::vector<Vec3>& ends) {
    const TestSurface ground(mesh);
    const PatchLevels patches(ground.surface);
    const PickPath path = makePickPath(
        ground.surface,
        ground.extended,
        ground.nearest(ends),
        false,
        {.blockedFaces = {}, .patches = &patches}
    );
    std::vector<Vec3> points;
    for (const InitialPath::Point& point : path.path.points) {
        points.push_back(ground.surface.position(point.point));
    }
    return points;
}

// No walk leads over the edge of the wedge, but the string stays one, with a path over the edge.
TEST(InitialPathsOverEdges, ArePolylinesBesideThese) {
    constexpr int kCells = 100;
    const std::vector<Vec3> points = quickPath(wedge(kCells), {{0.3, 0.4, 1.0}, {0.76, 0.6, 0.2}});
    int apart = 0;
    bool isOnEdge = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        apart += (points[i] - points[i - 1]).norm() > 1.5 / kCells ? 1 : 0;
        isOnEdge = isOnEdge || (points[i] - Vec3(1.0, points[i].y(), 1.0)).norm() < 1e-9;
    }
    EXPECT_GT(apart, 27);  // of 32
    EXPECT_TRUE(isOnEdge);
}

TEST(InitialPathsOverEdges, DoNotPassThroughAThinPlate) {
    const double around =
        length(quickPath(box(60, {1.0, 1.0, 0.01}), {{0.7, 0.5, 0.01}, {0.7, 0.52, 0.0}}));
    EXPECT_GT(around, 0.6);
    EXPECT_LT(around, 0.7);
}

}  // namespace
}  // namespace bspline_curve
