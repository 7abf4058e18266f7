// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_session.h"

#include "bspline_curve/spline.h"
#include "session_fixture.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <stdexcept>

namespace bspline_curve {
namespace {

using namespace test_support;

class ASession : public testing::TestWithParam<bool> {
protected:
    ASession() : s_(withNoise(icosphere(4), 0.003, 7), Vec3::UnitZ()) {
        s_.camera = Camera(*s_.workpiece, Vec3::UnitZ(), GetParam());
    }

    [[nodiscard]] const SketchCurve& curve(int i = 0) const {
        return *s_.session.sketch().curves.at(i);
    }

    [[nodiscard]] std::size_t count() const { return s_.session.sketch().curves.size(); }

    static std::shared_ptr<const SketchGuides> guides(SketchGuides::Values values) {
        return std::make_shared<const SketchGuides>(std::move(values));
    }

    // Three picks on the front side.
    void drawArc() {
        s_.click(points_);
        s_.session.settle();
    }

    std::vector<Vec3> points_ = {{-0.5, 0.1, 0.86}, {0.0, 0.4, 0.9}, {0.5, -0.1, 0.86}};
    SessionFixture s_;
};

INSTANTIATE_TEST_SUITE_P(Views, ASession, testing::Bool(), [](const auto& view) {
    return view.param ? "Orthographic" : "Perspective";
});

TEST_P(ASession, DrawsTheCurveOfAFilterThroughClicksWhereTheyWere) {
    drawArc();
    ASSERT_EQ(count(), 1U);
    ASSERT_EQ(curve().picks.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Pointer pointer = s_.camera.over(points_[i]);
        const Vec3 way = curve().picks[i].position - pointer.start;
        EXPECT_LT(way.cross(pointer.direction).norm(), 1e-12 * way.norm());
    }
    ASSERT_TRUE(curve().settled);
    s_.expectAsDrawn();
    EXPECT_EQ(curve().shownPoints(), curve().settled->polyline.points);
}

TEST_P(ASession, LeavesTheCameraWhatIsBesideTheMesh) {
    EXPECT_FALSE(s_.session.press(s_.camera.off()));
    EXPECT_FALSE(s_.session.move(s_.camera.off()));
    EXPECT_FALSE(s_.session.release(s_.camera.off()));
    EXPECT_EQ(count(), 0U);
}

TEST_P(ASession, HidesWhatLiesBehindTheSurface) {
    const auto hides = [&](const Vec3& point) {
        return s_.session.hides(s_.camera.over(point), point);
    };
    for (const Vec3& vertex : s_.workpiece->mesh().vertices) {
        if (std::abs(vertex.z()) > 0.25) {
            EXPECT_EQ(hides(vertex), vertex.z() < 0.0) << vertex.transpose();
        }
    }
    EXPECT_FALSE(hides({2.0, 0.0, 0.0})) << "beside it";
}

TEST_P(ASession, DragsPicksAndTheCurveFollows) {
    drawArc();
    const std::vector<Vec3> before = curve().shownPoints();
    s_.session.press(s_.camera.over(points_[1]));
    EXPECT_FALSE(s_.session.isDragging());
    EXPECT_TRUE(s_.session.move(s_.camera.beside(points_[1], 1.0)));
    EXPECT_FALSE(s_.session.isDragging()) << "one pixel is no drag";
    EXPECT_TRUE(s_.session.move(s_.camera.beside(points_[1], 20.0)));
    EXPECT_TRUE(s_.session.isDragging());
    // At once: the old curve, displaced, through the pick.
    EXPECT_FALSE(curve().settled);
    const std::vector<Vec3> displaced = curve().shownPoints();
    ASSERT_EQ(displaced.size(), before.size());
    const int middle = curve().last->polyline.picks[1];
    EXPECT_LT((displaced[middle] - curve().picks[1].position).norm(), 1e-12);
    EXPECT_EQ(displaced.front(), before.front());
    EXPECT_TRUE(s_.session.release(s_.camera.beside(points_[1], 20.0)));
    s_.session.settle();
    s_.expectAsDrawn();
    EXPECT_NE(curve().shownPoints(), before);
}

TEST_P(ASession, DrawsCornersThatStayWithTheirPicks) {
    drawArc();
    s_.session.setCorner(1, true);
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    EXPECT_EQ(curve().corners(), std::vector<int>{1});
    EXPECT_EQ(cornersOf(curve().settled->spline), std::vector<int>{1});
    s_.session.movePick(1, curve().picks[2].point);
    s_.session.insertPick(0, curve().picks[0].point);
    EXPECT_EQ(curve().corners(), std::vector<int>{2});
    s_.session.undo();
    s_.session.undo();
    EXPECT_EQ(curve().corners(), std::vector<int>{1});
    s_.session.undo();
    EXPECT_TRUE(curve().corners().empty());
    s_.session.settle();
    EXPECT_TRUE(cornersOf(curve().settled->spline).empty());
    s_.session.setCorner(1, true);
    s_.session.removePick(0);
    EXPECT_EQ(curve().corners(), std::vector<int>{0});
    EXPECT_THROW(s_.session.setCorner(2, true), std::out_of_range);
}

TEST_P(ASession, DrawsDirectionsThatStayWithTheirPicks) {
    drawArc();
    const auto along = PickTangent::along(curve().picks[2].position - curve().picks[0].position);
    s_.session.setTangent(1, along);
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    ASSERT_EQ(curve().settled->report.tangents.size(), 1U);
    EXPECT_EQ(curve().settled->report.tangents.front().pick, 1);
    EXPECT_LE(curve().settled->report.tangents.front().ofSpline, 1e-6);
    s_.session.insertPick(0, curve().picks[0].point);
    EXPECT_EQ(curve().picks[2].tangent, along);
    EXPECT_EQ(curve().picks[1].tangent, PickTangent());
    s_.session.setCorner(2, true);  // a corner has none at first
    EXPECT_TRUE(curve().tangents().empty());
    s_.session.setTangent(2, {along.before, Vec3::UnitX()});
    EXPECT_EQ(kindOf(curve().picks[2]), PickKind::Free);
    s_.session.setTangent(2, along);
    EXPECT_TRUE(curve().corners().empty());
    s_.session.undo();
    s_.session.undo();
    EXPECT_EQ(curve().corners(), std::vector<int>{2});
    EXPECT_THROW(s_.session.setTangent(9, along), std::out_of_range);
}

TEST_P(ASession, InsertsPicksWhereTheCurveIsClicked) {
    drawArc();
    const SurfacePolyline& line = curve().settled->polyline;
    const Vec3 between = line.points[(line.picks[1] + line.picks[2]) / 2];
    s_.session.move(s_.camera.over(between));
    EXPECT_EQ(s_.session.hovered(), (SketchHit{0, -1, 1}));
    s_.drag(s_.camera.over(between), s_.camera.beside(between, 30.0));
    ASSERT_EQ(curve().picks.size(), 4U);
    EXPECT_EQ(s_.session.sketch().selected, 2);
    EXPECT_LT((curve().picks[2].position - between).norm(), 0.15);
    s_.session.undo();
    EXPECT_EQ(curve().picks.size(), 3U) << "a drag is one entry";
}

TEST_P(ASession, ClosesByAClickOnTheFirstPickAndThenBeginsAnother) {
    drawArc();
    s_.click(s_.camera.over(points_[0]));
    s_.session.settle();
    EXPECT_TRUE(curve().options.solver.closed);
    ASSERT_TRUE(curve().settled);
    EXPECT_TRUE(curve().settled->polyline.closed);
    s_.expectAsDrawn();
    s_.click(s_.camera.over({0.0, -0.6, 0.8}));
    EXPECT_EQ(count(), 2U);
    EXPECT_EQ(s_.session.sketch().active, 1);
    s_.click(s_.camera.over(points_[2]));
    EXPECT_EQ(s_.session.sketch().active, 0) << "a click on a pick of another curve";
}

TEST_P(ASession, HighlightsWhatIsUnderThePointerButNotWhatIsHidden) {
    drawArc();
    s_.session.move(s_.camera.beside(points_[0], 5.0));
    EXPECT_EQ(s_.session.hovered(), (SketchHit{0, 0, -1}));
    s_.session.move(s_.camera.over({0.0, -0.6, 0.8}));
    EXPECT_EQ(s_.session.hovered(), SketchHit());
    s_.camera = Camera(*s_.workpiece, -Vec3::UnitZ(), GetParam());
    s_.session.move(s_.camera.over(points_[0]));
    EXPECT_EQ(s_.session.hovered(), SketchHit());
    s_.session.leave();
}

TEST_P(ASession, ShowsTheCurveWithThePointerAsOneMorePick) {
    drawArc();
    const Vec3 next(0.3, -0.6, 0.74);
    s_.session.move(s_.camera.over(next));
    while (!s_.session.preview()) {
        s_.session.update();
    }
    EXPECT_LT((s_.session.preview()->polyline.points.back() - next).norm(), 0.01);
    s_.session.leave();
    EXPECT_EQ(s_.session.preview(), nullptr);
}

TEST_P(ASession, RemovesPicksAndCurves) {
    drawArc();
    Pointer pointer = s_.camera.over(points_[1]);
    pointer.removes = true;
    s_.click(pointer);
    EXPECT_EQ(curve().picks.size(), 2U);
    s_.session.settle();
    s_.expectAsDrawn();
    s_.session.key(SketchKey::Remove, pointer);
    s_.session.key(SketchKey::Remove, pointer);
    EXPECT_EQ(count(), 0U) << "with its last pick the curve goes";
    for (int i = 0; i < 3; ++i) {
        s_.session.undo();
    }
    EXPECT_EQ(curve().picks.size(), 3U);
}

TEST_P(ASession, KeepsTheLastCurveAndSaysWhyThereIsNoOther) {
    drawArc();
    SketchCurveOptions options;
    options.guides = guides({.field = {}, .avoid = {curve().picks[1].point.face}});
    const std::vector<Vec3> before = curve().shownPoints();
    s_.session.setOptions(options);
    s_.session.settle();
    EXPECT_FALSE(curve().settled);
    EXPECT_FALSE(curve().problem.message.empty());
    EXPECT_EQ(curve().problem.picks, std::vector<int>{1});
    EXPECT_EQ(curve().shownPoints(), before);
    s_.session.undo();
    EXPECT_TRUE(curve().settled);
    EXPECT_TRUE(curve().problem.message.empty());
}

TEST_P(ASession, SnapsWhileTheKeyIsHeld) {
    SessionFixture cube(box(10), {0.2, 0.3, 1.0});
    Pointer pointer = cube.camera.over({0.53, 0.003, 1.0});
    pointer.snaps = true;
    cube.click(pointer);
    EXPECT_LT((cube.session.sketch().curves[0]->picks[0].position - Vec3(0.53, 0, 1)).norm(), 0.01);
    EXPECT_EQ(cube.session.sketch().curves[0]->picks[0].position.y(), 0.0);
    EXPECT_EQ(cube.session.snapped().kind, SnapKind::Crease);
    EXPECT_STREQ(nameOf(cube.session.snapped().kind), "a crease");
    // What a click would add there.
    static_cast<void>(cube.session.move(cube.camera.over({0.3, 0.003, 1.0})));
    EXPECT_EQ(cube.session.snapped().kind, SnapKind::None);
    pointer = cube.camera.over({0.3, 0.003, 1.0});
    pointer.snaps = true;
    static_cast<void>(cube.session.move(pointer));
    EXPECT_EQ(cube.session.snapped().kind, SnapKind::Crease);
    cube.session.leave();
    EXPECT_EQ(cube.session.snapped().kind, SnapKind::None);
}

TEST_P(ASession, SnapsToRidgesOnceTheyAreKnown) {
    SessionSettings settings;
    settings.snapPixels = 30.0;  // one and a half edges
    SessionFixture s(s_.workpiece->mesh(), Vec3::UnitZ(), settings);
    s.camera = s_.camera;
    const std::vector<Vec3>& vertices = s.workpiece->mesh().vertices;
    const auto nearestTo = [&](const Vec3& place, const Vec3& other) {
        return *std::ranges::min_element(vertices, {}, [&](const Vec3& vertex) {
            return vertex == other ? 10.0 : (vertex - place).norm();
        });
    };
    const Vec3 top = nearestTo(Vec3::UnitZ(), Vec3::Zero());
    const Vec3 beside = nearestTo(top, top);
    Pointer pointer = s.camera.over(top);
    pointer.snaps = true;
    s.click(pointer);
    EXPECT_EQ(s.session.sketch().curves[0]->positions(), std::vector<Vec3>{top});
    s.session.undo();

    std::vector<double> ridge(vertices.size(), 0.0);
    ridge[std::ranges::find(vertices, beside) - vertices.begin()] = 1.0;
    SnapOptions snapping;
    snapping.ridge = std::move(ridge);
    s.session.setSnapping(snapping);
    s.click(pointer);
    EXPECT_EQ(s.session.sketch().curves[0]->positions(), std::vector<Vec3>{beside});
}

TEST_P(ASession, TakesFieldsAndOtherOptionsPerCurve) {
    drawArc();
    std::vector<double> field;
    for (const Vec3& v : s_.workpiece->mesh().vertices) {
        field.push_back(0.5 + 0.5 * std::sin(4.0 * v.x()) * v.y());
    }
    SketchCurveOptions options;
    options.guides = guides({.field = std::move(field), .avoid = {}});
    options.solver.degree = 4;
    const Curve without = *curve().settled;
    s_.session.setOptions(options);
    s_.session.settle();
    ASSERT_TRUE(curve().settled);
    EXPECT_EQ(curve().settled->spline.degree, 4);
    s_.expectAsDrawn();
    EXPECT_NE(curve().settled->polyline.points, without.polyline.points);
    options.solver.degree = 7;
    EXPECT_THROW(s_.session.setOptions(options), std::runtime_error);
}

TEST_P(ASession, MakesAFieldOnceAndSaysWhyItCannot) {
    drawArc();
    int made = 0;
    SketchCurveOptions options;
    options.guides = std::make_shared<const SketchGuides>([&](const Progress&) {
        ++made;
        return SketchGuides::Values{
            std::vector<double>(s_.workpiece->mesh().vertices.size(), 0.5), {}
        };
    });
    s_.session.setOptions(options);
    s_.session.settle();
    s_.drag(s_.camera.over(points_[1]), s_.camera.beside(points_[1], 20.0));
    s_.session.settle();
    EXPECT_EQ(made, 1);
    s_.expectAsDrawn();

    int refused = 0;
    options.guides =
        std::make_shared<const SketchGuides>([&](const Progress&) -> SketchGuides::Values {
            ++refused;
            throw InputError(InputErrorCode::BadField, "no field here");
        });
    s_.session.setOptions(options);
    s_.session.settle();
    EXPECT_FALSE(curve().settled);
    EXPECT_EQ(curve().problem.message, "no field here");
    EXPECT_FALSE(curve().shownPoints().empty());
    s_.drag(s_.camera.over(points_[0]), s_.camera.beside(points_[0], 20.0));
    s_.session.settle();
    EXPECT_EQ(refused, 1);
}

TEST_P(ASession, DoesByKeysAndCallsWhatTheMouseDoes) {
    drawArc();
    s_.click(s_.camera.over(points_[0]));  // close
    const Vec3 to(0.1, 0.2, 0.97);
    s_.drag(s_.camera.over(points_[1]), s_.camera.over(to));

    SessionFixture keys(s_.workpiece->mesh(), Vec3::UnitZ());
    keys.camera = s_.camera;
    for (const Vec3& p : points_) {
        EXPECT_TRUE(keys.session.key(SketchKey::Add, keys.camera.over(p)));
    }
    keys.session.key(SketchKey::Close, {});
    keys.session.key(SketchKey::Previous, {});
    EXPECT_TRUE(keys.session.key(SketchKey::Move, keys.camera.over(to)));

    SessionFixture calls(s_.workpiece->mesh(), Vec3::UnitZ());
    for (const SketchPick& pick : curve().picks) {
        calls.session.addPick(pick.point);
    }
    calls.session.setClosed(true);
    for (SessionFixture* other : {&keys, &calls}) {
        other->session.settle();
        s_.session.settle();
        ASSERT_TRUE(other->session.sketch().curves[0]->settled);
        EXPECT_EQ(
            other->session.sketch().curves[0]->settled->polyline.points,
            curve().settled->polyline.points
        );
    }
    EXPECT_THROW(calls.session.movePick(9, {}), std::out_of_range);
    EXPECT_THROW(calls.session.select(4), std::out_of_range);
}

TEST_P(ASession, CancelsADrag) {
    drawArc();
    const std::vector<Vec3> before = curve().positions();
    s_.session.press(s_.camera.over(points_[1]));
    s_.session.move(s_.camera.beside(points_[1], 40.0));
    EXPECT_NE(curve().positions(), before);
    s_.session.key(SketchKey::Cancel, {});
    EXPECT_EQ(curve().positions(), before);
    EXPECT_FALSE(s_.session.release(s_.camera.beside(points_[1], 40.0)));
}

TEST_P(ASession, BeginsWithCurvesThatUndoDoesNotRemove) {
    drawArc();
    const SketchCurve first = curve();
    DrawingSession later(s_.workpiece);
    later.begin({first, first}, 1);
    later.settle();
    ASSERT_EQ(later.sketch().curves.size(), 2U);
    EXPECT_EQ(later.sketch().active, 1);
    EXPECT_FALSE(later.canUndo());
    for (const auto& drawn : later.sketch().curves) {
        ASSERT_TRUE(drawn->settled);
        EXPECT_EQ(drawn->settled->polyline.points, first.settled->polyline.points);
    }
    later.add({first});
    ASSERT_EQ(later.sketch().curves.size(), 3U);
    later.undo();
    EXPECT_EQ(later.sketch().curves.size(), 2U);
}

TEST_P(ASession, GivesEachCurveAnIdThatItKeeps) {
    drawArc();
    const std::uint64_t id = curve().id;
    EXPECT_NE(id, 0U);
    s_.session.newCurve();
    s_.click(s_.camera.over({0.0, -0.6, 0.8}));
    EXPECT_NE(curve(1).id, id);
    s_.session.select(0);
    s_.session.removePick(1);
    EXPECT_EQ(curve().id, id);
    s_.session.undo();
    EXPECT_EQ(curve().id, id);
}

TEST_P(ASession, ChangesALookWithoutMovingTheCurve) {
    drawArc();
    const auto settled = curve().settled;
    const SketchCurve before = curve();
    s_.session.setLook(0, {.name = "margin", .colour = {10, 200, 30}, .isHidden = false});
    EXPECT_EQ(curve().settled, settled);
    EXPECT_EQ(curve().look.name, "margin");
    EXPECT_TRUE(curve().asksForTheSame(before));
    s_.session.undo();
    EXPECT_EQ(curve().look, before.look);
    s_.session.movePick(1, curve().picks[0].point);
    EXPECT_FALSE(curve().asksForTheSame(before));
}

TEST_P(ASession, EntersASlidersMovesAsOneChange) {
    drawArc();
    SketchCurveOptions options;
    for (const double tension : {0.1, 0.2, 0.3}) {
        options.solver.tension = tension;
        s_.session.setOptions(options, true);
    }
    options.solver.tension = 0.4;
    s_.session.setOptions(options);
    EXPECT_EQ(curve().options.solver.tension, 0.4);
    s_.session.undo();
    EXPECT_EQ(curve().options.solver.tension, 0.0);
    s_.session.redo();
    EXPECT_EQ(curve().options.solver.tension, 0.4);
    options.solver.tension = 0.5;
    s_.session.setOptions(options);  // another change
    s_.session.undo();
    EXPECT_EQ(curve().options.solver.tension, 0.4);
}

TEST_P(ASession, NeitherHitsNorSelectsWhatIsHidden) {
    drawArc();
    SketchLook look = curve().look;
    look.isHidden = true;
    s_.session.setLook(0, look);
    EXPECT_EQ(s_.session.sketch().active, -1);
    s_.session.move(s_.camera.over(points_[1]));
    EXPECT_EQ(s_.session.hovered(), SketchHit());
    EXPECT_FALSE(s_.session.key(SketchKey::NextCurve, {}));
    EXPECT_THROW(s_.session.setLook(1, look), std::out_of_range);
}

TEST_P(ASession, TellsWhatAPickSnapsTo) {
    drawArc();
    Pointer pointer = s_.camera.beside(points_[1], 40.0);
    s_.session.press(pointer);
    EXPECT_EQ(s_.session.snapped().kind, SnapKind::None);
    pointer.snaps = true;
    s_.session.move(pointer);
    EXPECT_EQ(s_.session.snapped().kind, SnapKind::Vertex);
    s_.session.release(pointer);
    EXPECT_EQ(s_.session.snapped().kind, SnapKind::Vertex);  // that of the pick
    s_.session.leave();
    EXPECT_EQ(s_.session.snapped().kind, SnapKind::None);
}

TEST_P(ASession, WaitsForCurvesNoLongerThanAsked) {
    std::promise<void> goOn;
    const std::shared_future<void> gate = goOn.get_future();
    SketchCurveOptions options;
    options.guides =
        std::make_shared<const SketchGuides>([gate](const Progress&) -> SketchGuides::Values {
            gate.wait();
            return {};
        });
    s_.session.setOptions(options);
    s_.click(points_);
    EXPECT_FALSE(s_.session.settleWithin(std::chrono::milliseconds(1)));
    goOn.set_value();
    EXPECT_TRUE(s_.session.settleWithin(std::chrono::minutes(1)));
    EXPECT_TRUE(curve().settled);
}

TEST_P(ASession, WaitsForNoCurveWhosePickIsDragged) {
    drawArc();
    s_.session.press(s_.camera.over(curve().picks[1].position));
    s_.session.move(s_.camera.beside(curve().picks[1].position, 30.0));
    s_.session.settle();
    EXPECT_FALSE(s_.session.settleWithin(std::chrono::minutes(1)));
    EXPECT_TRUE(s_.session.isDragging());
    s_.session.release(s_.camera.over(curve().picks[1].position));
    s_.session.settle();
    EXPECT_TRUE(curve().settled);
}

TEST_P(ASession, ChangesNoCurveThatEndsWithItsDrag) {
    drawArc();
    s_.session.newCurve();
    s_.session.press(s_.camera.over({0.0, -0.4, 0.9}));
    ASSERT_TRUE(s_.session.isDragging());
    ASSERT_EQ(count(), 2U);
    s_.session.setClosed(true);
    EXPECT_EQ(count(), 1U);
    s_.session.newCurve();
    s_.session.press(s_.camera.over({0.0, -0.4, 0.9}));
    s_.session.setCorner(0, true);
    EXPECT_EQ(count(), 1U);
    EXPECT_FALSE(curve().options.solver.closed);
    EXPECT_TRUE(curve().corners().empty());
}

}  // namespace
}  // namespace bspline_curve
