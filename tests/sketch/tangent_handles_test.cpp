// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of picks, and the handles of those with a direction.
#include "sketch/tangent_handles.h"

#include "session_fixture.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kPixels = 40.0;

double angleOf(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

class TangentHandles : public testing::TestWithParam<bool> {
protected:
    TangentHandles()
        : s_(jitteredPlate(20, 20, 0.2, 3), Vec3(0.2, 0.1, 1.0), {.handlePixels = kPixels}) {
        s_.camera = Camera(*s_.workpiece, Vec3(0.2, 0.1, 1.0), GetParam());
        s_.click({{0.2, 0.3, 0.0}, {0.5, 0.6, 0.0}, {0.8, 0.4, 0.0}});
        s_.session.settle();
        s_.session.select(0, 1);
    }

    [[nodiscard]] const SketchCurve& curve() const { return *s_.session.sketch().curves.at(0); }

    [[nodiscard]] const SketchPick& pick() const { return curve().picks[1]; }

    /// The pointer over a handle of the middle pick.
    [[nodiscard]] Pointer overHandle(int side) const {
        return s_.camera.over(
            tangentHandle(pick(), side, s_.camera.over(pick().position), kPixels).value()
        );
    }

    SessionFixture s_;
};

INSTANTIATE_TEST_SUITE_P(Cameras, TangentHandles, testing::Bool());

TEST_P(TangentHandles, GoThroughAllKindsByAKey) {
    EXPECT_EQ(kindOf(pick()), PickKind::Automatic);
    const Vec3 before = curve().settled->polyline.points[10];
    EXPECT_TRUE(s_.session.key(SketchKey::Kind, s_.camera.off()));
    EXPECT_EQ(kindOf(pick()), PickKind::Aligned);
    // In the direction that the curve had: it stays what it was.
    s_.session.settle();
    EXPECT_LT((curve().settled->polyline.points[10] - before).norm(), 1e-3);
    EXPECT_EQ(curve().settled->report.tangents.size(), 1U);
    EXPECT_TRUE(s_.session.key(SketchKey::Kind, s_.camera.off()));
    EXPECT_EQ(kindOf(pick()), PickKind::Corner);
    s_.session.settle();
    const Vec3 cornered = curve().settled->polyline.points[10];
    EXPECT_TRUE(s_.session.key(SketchKey::Kind, s_.camera.off()));
    EXPECT_EQ(kindOf(pick()), PickKind::Free);
    s_.session.settle();
    EXPECT_LT((curve().settled->polyline.points[10] - cornered).norm(), 1e-3);
    EXPECT_TRUE(s_.session.key(SketchKey::Kind, s_.camera.off()));
    EXPECT_EQ(kindOf(pick()), PickKind::Automatic);
    EXPECT_TRUE(pick().tangent.isAny());
    s_.session.undo();
    EXPECT_EQ(kindOf(pick()), PickKind::Free);
    s_.session.undo();
    EXPECT_EQ(kindOf(pick()), PickKind::Corner);
    s_.session.undo();
    EXPECT_EQ(kindOf(pick()), PickKind::Aligned);
    s_.session.select(0);
    EXPECT_FALSE(s_.session.key(SketchKey::Kind, s_.camera.off()));
}

TEST_P(TangentHandles, TurnTheDirectionOfTheirPick) {
    s_.session.setTangent(1, PickTangent::along(Vec3::UnitX()));
    s_.session.settle();
    for (const int side : {1, -1}) {
        s_.session.move(overHandle(side));
        EXPECT_EQ(s_.session.hovered(), (SketchHit{0, 1, -1, side}));
        const Vec3 wanted = Vec3(0.4, 0.3 * side, 0.0).normalized();
        EXPECT_TRUE(s_.session.press(overHandle(side)));
        const Pointer to = s_.camera.over(pick().position + 0.15 * side * wanted);
        s_.session.move(to);
        EXPECT_TRUE(s_.session.isDragging());
        s_.session.release(to);
        EXPECT_LT(angleOf(pick().tangent.after, wanted), 1e-9) << side;
        s_.session.settle();
        ASSERT_EQ(curve().settled->report.tangents.size(), 1U);
        EXPECT_LE(curve().settled->report.tangents.front().ofSpline, 1e-6);
    }
    EXPECT_EQ(curve().picks.size(), 3U);
    // Each drag is one entry.
    s_.session.undo();
    EXPECT_LT(angleOf(pick().tangent.after, {0.4, 0.3, 0.0}), 1e-9);
    s_.session.undo();
    EXPECT_EQ(pick().tangent, PickTangent::along(Vec3::UnitX()));
}

TEST_P(TangentHandles, OfACornerTurnTheirOwnSide) {
    s_.session.setTangent(1, {Vec3::UnitX(), Vec3::UnitY()});
    s_.session.settle();
    for (const int side : {1, -1}) {
        const PickTangent before = pick().tangent;
        const Vec3 wanted = Vec3(0.4, 0.3 * side, 0.0).normalized();
        s_.session.move(overHandle(side));
        EXPECT_EQ(s_.session.hovered(), (SketchHit{0, 1, -1, side}));
        s_.session.press(overHandle(side));
        const Pointer to = s_.camera.over(pick().position + 0.15 * side * wanted);
        s_.session.move(to);
        s_.session.release(to);
        EXPECT_EQ(kindOf(pick()), PickKind::Free);
        const auto& [behind, ahead] = pick().tangent;
        EXPECT_LT(angleOf(side > 0 ? ahead : behind, wanted), 1e-9) << side;
        EXPECT_EQ(side > 0 ? behind : ahead, side > 0 ? before.before : before.after);
        s_.session.settle();
        ASSERT_EQ(curve().settled->report.tangents.size(), 1U);
        EXPECT_LE(curve().settled->report.tangents.front().ofSpline, 1e-6);
    }
    s_.session.setTangent(1, {Vec3::Zero(), Vec3::UnitY()});
    EXPECT_FALSE(tangentHandle(pick(), -1, s_.camera.over(pick().position), kPixels).has_value());
    s_.session.setKind(1, PickKind::Aligned);
    EXPECT_TRUE(pick().tangent.isOne());
    EXPECT_FALSE(pick().isCorner);
}

TEST_P(TangentHandles, StayWhereADragIsGivenUpOrDoesNotMove) {
    s_.session.setTangent(1, PickTangent::along(Vec3::UnitX()));
    s_.session.settle();
    s_.session.press(overHandle(1));
    s_.session.move(s_.camera.over(pick().position + Vec3(0.0, 0.1, 0.0)));
    EXPECT_GT(angleOf(pick().tangent.after, {1.0, 0.0, 0.0}), 1.0);
    s_.session.key(SketchKey::Cancel, s_.camera.off());
    EXPECT_EQ(pick().tangent, PickTangent::along(Vec3::UnitX()));
    s_.session.select(0, 1);
    s_.click(overHandle(1));
    EXPECT_EQ(pick().tangent, PickTangent::along(Vec3::UnitX()));
    EXPECT_EQ(curve().picks.size(), 3U);
}

TEST_P(TangentHandles, AreThoseOfTheSelectedPickOfAHostThatDrawsThem) {
    s_.session.setTangent(1, PickTangent::along(Vec3::UnitX()));
    const Pointer over = overHandle(1);
    s_.session.select(0, 0);
    s_.session.move(over);
    EXPECT_EQ(s_.session.hovered().handle, 0);
    SessionFixture other(jitteredPlate(20, 20, 0.2, 3), Vec3::UnitZ());
    other.click({{0.2, 0.3, 0.0}, {0.5, 0.6, 0.0}, {0.8, 0.4, 0.0}});
    other.session.setTangent(1, PickTangent::along(Vec3::UnitX()));
    const auto handle = tangentHandle(
        other.session.sketch().curves[0]->picks[1], 1, other.camera.over({0.5, 0.6, 0.0}), kPixels
    );
    other.session.move(other.camera.over(handle.value()));
    EXPECT_EQ(other.session.hovered().handle, 0);
}

TEST_P(TangentHandles, AreHiddenByTheSurface) {
    const Pointer pointer = s_.camera.over(pick().position);
    s_.session.setTangent(1, PickTangent::along(Vec3::UnitX()));
    const double depth = (pick().position - pointer.start).dot(pointer.direction);
    EXPECT_EQ(tangentHandleUnder(overHandle(1), depth, pick(), kPixels, 9.0), 1);
    EXPECT_EQ(tangentHandleUnder(overHandle(1), 0.5 * depth, pick(), kPixels, 9.0), 0);
    EXPECT_EQ(tangentHandleUnder(s_.camera.off(), depth, pick(), kPixels, 9.0), 0);
}

TEST(DirectionTowards, IsNoneWhereThePointerLooksAlongThePlane) {
    const SketchPick pick;
    Pointer along;
    along.start = {-1.0, 0.1, 0.0};
    along.direction = Vec3::UnitX();
    EXPECT_FALSE(directionTowards(along, pick, Vec3::UnitZ()).has_value());
    Pointer above;
    above.start = {0.1, 0.0, 1.0};
    above.isOrthographic = true;
    const auto found = directionTowards(above, pick, Vec3::UnitZ());
    ASSERT_TRUE(found);
    EXPECT_LT((*found - Vec3::UnitX()).norm(), 1e-12);
    above.start = {1e-4, 0.0, 1.0};  // within two pixels of the pick
    EXPECT_FALSE(directionTowards(above, pick, Vec3::UnitZ()).has_value());
}

}  // namespace
}  // namespace bspline_curve
