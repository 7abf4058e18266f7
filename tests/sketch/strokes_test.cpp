// SPDX-License-Identifier: GPL-3.0-or-later
// Lines drawn freehand.
#include "bspline_curve/drawing_session.h"
#include "session_fixture.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kEdge = 0.07;  // of the sphere, about

class AStroke : public testing::Test {
protected:
    AStroke() : s_(withNoise(icosphere(4), 0.003, 7), Vec3::UnitZ()) {}

    [[nodiscard]] const SketchCurve& curve(int i = 0) const {
        return *s_.session.sketch().curves.at(i);
    }

    [[nodiscard]] std::size_t count() const { return s_.session.sketch().curves.size(); }

    [[nodiscard]] Pointer drawingOver(const Vec3& point) const {
        Pointer pointer = s_.camera.over(point);
        pointer.strokes = pointer.removes = true;  // the same key
        return pointer;
    }

    void begin(const std::vector<Vec3>& points) {
        EXPECT_TRUE(s_.session.press(drawingOver(points.front())));
        for (const Vec3& point : points) {
            EXPECT_TRUE(s_.session.move(drawingOver(point)));
        }
    }

    void draw(const std::vector<Vec3>& points) {
        begin(points);
        EXPECT_TRUE(s_.session.release(drawingOver(points.back())));
    }

    // On the front side: x from -0.5 to 0.5, y about a bump of some height, with a hand's
    // trembling.
    static std::vector<Vec3> line(double height, double trembling) {
        Random random(3);
        std::vector<Vec3> points;
        for (int i = 0; i <= 100; ++i) {
            const double x = -0.5 + i / 100.0;
            const double y =
                height * std::cos(std::numbers::pi * x) + trembling * random.uniform(-1.0, 1.0);
            points.emplace_back(x, y, std::sqrt(1.0 - x * x - y * y));
        }
        return points;
    }

    static double largest(const std::vector<Vec3>& points, const Vec3& along) {
        double most = points.front().dot(along);
        for (const Vec3& point : points) {
            most = std::max(most, point.dot(along));
        }
        return most;
    }

    // The largest angle between neighbouring segments, degrees; without the shortest.
    static double sharpestTurn(const std::vector<Vec3>& points) {
        std::vector<Vec3> ways;
        for (std::size_t i = 1; i < points.size(); ++i) {
            if ((points[i] - points[i - 1]).norm() > 0.02 * kEdge) {
                ways.push_back((points[i] - points[i - 1]).normalized());
            }
        }
        double sharpest = 0.0;
        for (std::size_t i = 1; i < ways.size(); ++i) {
            sharpest =
                std::max(sharpest, std::acos(std::clamp(ways[i].dot(ways[i - 1]), -1.0, 1.0)));
        }
        return sharpest * 180.0 / std::numbers::pi;
    }

    SessionFixture s_;
};

TEST_F(AStroke, BecomesASmoothCurveOfFewPicks) {
    const std::vector<Vec3> points = line(0.2, 0.004);
    begin(points);
    EXPECT_TRUE(s_.session.isDragging());
    EXPECT_GT(s_.session.stroke().size(), 20U);
    EXPECT_EQ(count(), 0U);
    s_.session.release(drawingOver(points.back()));
    EXPECT_FALSE(s_.session.isDragging());
    EXPECT_TRUE(s_.session.stroke().empty());
    ASSERT_EQ(count(), 1U);  // at once, and better soon
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    EXPECT_FALSE(curve().options.solver.closed);
    EXPECT_LE(curve().picks.size(), 12U);
    EXPECT_LE((curve().picks.front().position - points.front()).norm(), 0.02);
    EXPECT_LE((curve().picks.back().position - points.back()).norm(), 0.02);
    for (const Vec3& p : curve().settled->polyline.points) {
        EXPECT_NEAR(p.y(), 0.2 * std::cos(std::numbers::pi * p.x()), kEdge);
    }
    EXPECT_LT(sharpestTurn(curve().settled->polyline.points), 20.0);
    s_.expectAsDrawn();
}

TEST_F(AStroke, IsOneEntryOfTheHistory) {
    draw(line(0.2, 0.0));
    s_.session.settle();
    const std::vector<Vec3> drawn = curve().positions();
    s_.session.undo();
    EXPECT_EQ(count(), 0U);
    EXPECT_FALSE(s_.session.canUndo());
    s_.session.redo();
    s_.session.settle();
    EXPECT_EQ(curve().positions(), drawn);
}

TEST_F(AStroke, IsThereWhenItIsUndoneBeforeItsCurveIsKnown) {
    draw(line(0.2, 0.0));
    s_.session.undo();
    s_.session.settle();
    EXPECT_EQ(count(), 0U);
    s_.session.redo();
    s_.session.settle();
    ASSERT_EQ(count(), 1U);
    EXPECT_TRUE(curve().settled);
}

// Until its curve is known it has other picks, and more of them.
TEST_F(AStroke, HasItsPicksReplacedWhileOneOfThemIsSelected) {
    draw(line(0.3, 0.03));
    const auto before = static_cast<int>(curve().picks.size());
    s_.session.select(0, before - 1);
    s_.session.settle();
    ASSERT_LT(static_cast<int>(curve().picks.size()), before);
    EXPECT_EQ(s_.session.sketch().selected, -1);
    const std::size_t after = curve().picks.size();
    s_.session.select(0, 1);
    EXPECT_TRUE(s_.session.key(SketchKey::Remove, {}));
    EXPECT_EQ(curve().picks.size(), after - 1);
}

TEST_F(AStroke, HasItsPicksReplacedWhileOneOfThemIsPressed) {
    draw(line(0.3, 0.03));
    const Vec3 last = curve().picks.back().position;
    EXPECT_TRUE(s_.session.press(s_.camera.over(last)));
    s_.session.settle();
    EXPECT_FALSE(s_.session.isDragging());
    const std::vector<Vec3> picks = curve().positions();
    s_.session.move(s_.camera.over(Vec3(0.0, 0.0, 1.0)));
    s_.session.release(s_.camera.over(Vec3(0.0, 0.0, 1.0)));
    EXPECT_EQ(curve().positions(), picks);
}

TEST_F(AStroke, HasItsPicksReplacedWhileOneOfThemIsDraggedBesideTheSurface) {
    draw(line(0.3, 0.03));
    EXPECT_TRUE(s_.session.press(s_.camera.over(curve().picks.back().position)));
    s_.session.move(s_.camera.over(Vec3(3.0, 0.0, 0.0)));
    EXPECT_TRUE(s_.session.isDragging());
    s_.session.settle();
    EXPECT_FALSE(s_.session.isDragging());
    const std::vector<Vec3> picks = curve().positions();
    s_.session.move(s_.camera.over(Vec3(0.0, 0.0, 1.0)));
    s_.session.release(s_.camera.over(Vec3(0.0, 0.0, 1.0)));
    EXPECT_EQ(curve().positions(), picks);
}

TEST_F(AStroke, ThatKeepsTheSelectedPickOfACurveLeavesItSelected) {
    draw(line(0.0, 0.0));
    s_.session.settle();
    const Vec3 first = curve().picks.front().position;
    std::vector<Vec3> bump;  // over the middle
    for (int i = 0; i <= 40; ++i) {
        const double x = -0.2 + i / 100.0;
        const double y = 0.2 * std::cos(std::numbers::pi * x / 0.4);
        bump.emplace_back(x, y, std::sqrt(1.0 - x * x - y * y));
    }
    draw(bump);
    s_.session.select(0, 0);
    s_.session.settle();
    ASSERT_EQ(s_.session.sketch().selected, 0);
    EXPECT_EQ(curve().picks.front().position, first);
}

TEST_F(AStroke, ThatEndsWhereItBeganIsClosed) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 100; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 100.0;
        points.emplace_back(0.4 * std::cos(angle), 0.4 * std::sin(angle), std::sqrt(0.84));
    }
    draw(points);
    s_.session.settle();
    ASSERT_EQ(count(), 1U);
    EXPECT_TRUE(curve().options.solver.closed);
    ASSERT_TRUE(curve().settled);
    for (const Vec3& p : curve().settled->polyline.points) {
        EXPECT_NEAR(p.head<2>().norm(), 0.4, kEdge);
    }
}

TEST_F(AStroke, OverACurveReplacesThatStretchAndJoinsItSmoothly) {
    const std::vector<Vec3> straight = line(0.0, 0.0);
    s_.click({straight[0], straight[25], straight[50], straight[75], straight[100]});
    s_.session.settle();
    const std::vector<SketchPick> before = curve().picks;
    ASSERT_EQ(before.size(), 5U);
    // From x = -0.15 up and back to x = 0.15, drawn backwards.
    std::vector<Vec3> over;
    for (int i = 0; i <= 40; ++i) {
        const double x = 0.15 - 0.3 * i / 40.0;
        const double y = 0.12 * std::pow(std::cos(x / 0.15 * std::numbers::pi / 2.0), 2.0);
        over.emplace_back(x, y, std::sqrt(1.0 - x * x - y * y));
    }
    draw(over);
    s_.session.settle();
    ASSERT_EQ(count(), 1U);
    ASSERT_TRUE(curve().settled);
    // The outer picks stay, the middle one is gone, and the curve passes the bump.
    const std::vector<Vec3> now = curve().positions();
    for (const std::size_t i : {0U, 1U, 3U, 4U}) {
        EXPECT_TRUE(std::ranges::find(now, before[i].position) != now.end()) << i;
    }
    EXPECT_TRUE(std::ranges::find(now, before[2].position) == now.end());
    const std::vector<Vec3>& points = curve().settled->polyline.points;
    EXPECT_NEAR(largest(points, Vec3::UnitY()), 0.12, kEdge);
    EXPECT_LT(sharpestTurn(points), 30.0);
    for (const Vec3& p : points) {
        if (std::abs(p.x()) > 0.3) {
            EXPECT_NEAR(p.y(), 0.0, kEdge);  // as it was
        }
    }
    s_.expectAsDrawn();
    s_.session.undo();
    EXPECT_EQ(curve().positions().size(), 5U);
}

TEST_F(AStroke, OverAClosedCurveReplacesTheNearerPart) {
    std::vector<Vec3> ring;
    for (int i = 0; i < 8; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 8.0;
        ring.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), std::sqrt(0.75));
    }
    s_.click(ring);
    s_.session.setClosed(true);
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    // Across the first pick, which is at angle 0, farther out.
    std::vector<Vec3> over;
    for (int i = 0; i <= 40; ++i) {
        const double angle = (-60.0 + 3.0 * i) * std::numbers::pi / 180.0;
        const double r = 0.5 + 0.15 * std::cos(1.5 * angle);
        over.emplace_back(r * std::cos(angle), r * std::sin(angle), std::sqrt(1.0 - r * r));
    }
    draw(over);
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    EXPECT_TRUE(curve().options.solver.closed);
    const std::vector<Vec3>& points = curve().settled->polyline.points;
    EXPECT_NEAR(largest(points, Vec3::UnitX()), 0.65, kEdge);
    EXPECT_NEAR(largest(points, -Vec3::UnitX()), 0.5, kEdge);
}

TEST_F(AStroke, ThatDoesNotMoveIsAClick) {
    s_.session.press(drawingOver({0.0, 0.0, 1.0}));
    s_.session.release(drawingOver({0.0, 0.0, 1.0}));
    ASSERT_EQ(count(), 1U);
    EXPECT_EQ(curve().picks.size(), 1U);
    s_.session.press(drawingOver(curve().picks[0].position));  // with the key it removes
    s_.session.release(drawingOver(curve().picks[0].position));
    EXPECT_EQ(count(), 0U);
}

TEST_F(AStroke, CanBeCancelled) {
    begin(line(0.2, 0.0));
    s_.session.key(SketchKey::Cancel, s_.camera.off());
    EXPECT_FALSE(s_.session.isDragging());
    EXPECT_TRUE(s_.session.stroke().empty());
    EXPECT_EQ(count(), 0U);
    EXPECT_FALSE(s_.session.canUndo());
}

TEST_F(AStroke, LeavesTheCameraWhatBeginsBesideTheMesh) {
    Pointer pointer = s_.camera.off();
    pointer.strokes = true;
    EXPECT_FALSE(s_.session.press(pointer));
    EXPECT_FALSE(s_.session.isDragging());
}

}  // namespace
}  // namespace bspline_curve
