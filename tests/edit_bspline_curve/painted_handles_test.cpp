// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/snap_glyph.h"
#include "painted_sketch.h"
#include "sketch/tangent_handles.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr SketchColour kHandleCentre{255, 255, 255}, kSelectedCentre{255, 191, 26};
constexpr SketchColour kHoveredCentre{255, 255, 102}, kBadCentre{230, 0, 0};
constexpr SketchColour kLeeway{255, 245, 215};
constexpr SketchColour kSnapMark{0, 225, 255};
constexpr SketchColour kDigit{20, 20, 20};

class PaintedHandles : public APaintedSketch {
protected:
    PaintedHandles() : scene_(plate(10, 10)) {
        scene_.look = {{120, 140, 160}, {}};
        static_cast<void>(scene_.withoutSketch());
    }

    [[nodiscard]] Eigen::Vector2d place(int pick) const {
        return scene_.pixelOf(curve(scene_).picks.at(pick).position);
    }

    // All pixels within 3 of the middle have one colour.
    [[nodiscard]] bool isFlat(const Pixels& pixels, int pick, const SketchColour& colour) const {
        const Eigen::Vector2d p = place(pick);
        for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                if (!(pixels.at(static_cast<int>(p.x()) + dx, static_cast<int>(p.y()) + dy) ==
                      colour)) {
                    return false;
                }
            }
        }
        return true;
    }

    // The colour of a pixel beside a pick.
    [[nodiscard]] SketchColour beside(const Pixels& pixels, int pick, double x, double y) const {
        const Eigen::Vector2d p = place(pick);
        return pixels.at(static_cast<int>(p.x() + x), static_cast<int>(p.y() + y));
    }

    // Digits lie farther out than rims.
    [[nodiscard]] bool hasNumber(const Pixels& pixels, int pick) const {
        const Eigen::Vector2d p = place(pick);
        return pixels.countNear(p, 26.0, kDigit) > pixels.countNear(p, 12.5, kDigit) + 3;
    }

    [[nodiscard]] bool hasNumberAbove(const Pixels& pixels, int pick) const {
        return pixels.countNear(place(pick) + Eigen::Vector2d(0.0, 19.0), 6.0, kDigit) > 3;
    }

    SketchCurve& drawn() { return *scene_.session().sketch().curves.at(0); }

    mutable PaintedScene scene_;
};

TEST_F(PaintedHandles, DifferByColourAndByShape) {
    scene_.addPicks(arcOnPlate());
    drawn().problem = {"something is wrong", {1}};
    static_cast<void>(scene_.session().move(scene_.over(arcOnPlate()[3])));
    ASSERT_EQ(scene_.session().hovered(), (SketchHit{0, 3, -1}));
    ASSERT_EQ(scene_.session().sketch().selected, 4);
    const Pixels pixels = scene_.withSketch();
    pixels.save("handles");
    EXPECT_TRUE(isFlat(pixels, 0, kHandleCentre));
    EXPECT_TRUE(isFlat(pixels, 1, kBadCentre));
    EXPECT_TRUE(isFlat(pixels, 3, kHoveredCentre));
    EXPECT_TRUE(isFlat(pixels, 4, kSelectedCentre));
    // The cross, the ring, the larger disc.
    EXPECT_EQ(beside(pixels, 1, 7.5, 7.5), kBadCentre);
    EXPECT_EQ(beside(pixels, 1, -7.5, 7.5), kBadCentre);
    EXPECT_EQ(beside(pixels, 4, 10.0, 0.0), kSelectedCentre);
    EXPECT_EQ(beside(pixels, 4, 0.0, 10.0), kSelectedCentre);
    EXPECT_GT(
        pixels.countNear(place(3), 5.5, kHoveredCentre),
        1.3 * pixels.countNear(place(0), 4.5, kHandleCentre)
    );
    // Each on any mesh.
    for (const NamedLook& named : allLooks()) {
        scene_.look = named.look;
        EXPECT_GE(leastOfHandles(scene_), kClear) << named.name;
        scene_.withSketch().save("handles-" + named.name);
    }
}

TEST_F(PaintedHandles, AreNumberedFromOneWhereThereIsRoom) {
    scene_.addPicks(arcOnPlate());
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(hasNumber(scene_.withSketch(), i)) << i;
    }
    scene_.session().removeCurve(0);
    std::vector<Vec3> crowd;
    for (int i = 0; i < 20; ++i) {
        crowd.emplace_back(0.3 + 0.02 * i, 0.5, 0.0);
    }
    scene_.addPicks(crowd);
    ASSERT_LT((place(1) - place(0)).norm(), 18.0);
    drawn().problem = {"something is wrong", {4}};
    const Pixels pixels = scene_.withSketch();
    pixels.save("crowd");
    EXPECT_FALSE(hasNumberAbove(pixels, 0));
    EXPECT_FALSE(hasNumberAbove(pixels, 10));
    EXPECT_TRUE(hasNumberAbove(pixels, 4));   // it is bad
    EXPECT_TRUE(hasNumberAbove(pixels, 19));  // it is selected
}

TEST_F(PaintedHandles, OfOtherCurvesAreDotsUntilThePointerIsThere) {
    scene_.addPicks(arcOnPlate());
    scene_.session().newCurve();
    scene_.addPicks({{0.2, 0.2, 0}, {0.8, 0.25, 0}});
    EXPECT_FALSE(isFlat(scene_.withSketch(), 2, kHandleCentre));
    static_cast<void>(scene_.session().move(scene_.over(arcOnPlate()[1])));
    EXPECT_TRUE(isFlat(scene_.withSketch(), 2, kHandleCentre));
    EXPECT_TRUE(isFlat(scene_.withSketch(), 1, kHoveredCentre));
}

TEST_F(PaintedHandles, OfTheSelectedPicksDirectionLieOnEitherSide) {
    scene_.addPicks(arcOnPlate());
    scene_.session().setTangent(2, PickTangent::along({1.0, 0.5, 0.0}));
    scene_.session().settle();
    const Vec3 place = curve(scene_).picks[2].position;
    const auto handle = [&](int side) {
        const SketchPick& pick = curve(scene_).picks[2];
        return tangentHandle(pick, side, scene_.over(place), kTangentPixels).value();
    };
    const Pixels pixels = scene_.withSketch();
    pixels.save("direction");
    for (const int side : {1, -1}) {
        EXPECT_GT(pixels.countNear(scene_.pixelOf(handle(side)), 3.5, kSelectedCentre), 20) << side;
        const Vec3 between = 0.5 * (place + handle(side));
        EXPECT_GT(pixels.countNear(scene_.pixelOf(between), 2.0, kSelectedCentre), 0) << side;
    }
    static_cast<void>(scene_.session().move(scene_.over(handle(-1))));
    const Pixels hovered = scene_.withSketch();
    EXPECT_GT(hovered.countNear(scene_.pixelOf(handle(-1)), 4.0, kHoveredCentre), 20);
    EXPECT_EQ(hovered.countNear(scene_.pixelOf(handle(1)), 4.0, kHoveredCentre), 0);
    // At a corner each side has its own.
    scene_.session().setTangent(2, {Vec3(1.0, 0.5, 0.0), Vec3(1.0, -2.0, 0.0)});
    scene_.session().leave();
    const Pixels own = scene_.withSketch();
    own.save("corner_with_directions");
    for (const int side : {1, -1}) {
        EXPECT_GT(own.countNear(scene_.pixelOf(handle(side)), 3.5, kSelectedCentre), 20) << side;
    }
    // Only of the selected pick.
    scene_.session().select(0, 0);
    EXPECT_EQ(scene_.withSketch().countNear(scene_.pixelOf(handle(1)), 3.5, kSelectedCentre), 0);
}

TEST_F(PaintedHandles, OfCornersLieInASquare) {
    scene_.addPicks(arcOnPlate());
    scene_.session().setCorner(1, true);
    scene_.session().settle();
    scene_.session().select(0, 4);
    const Pixels pixels = scene_.withSketch();
    pixels.save("corner");
    for (const double side : {7.5, -7.5}) {
        EXPECT_EQ(beside(pixels, 1, side, 7.0), kHandleCentre);
        EXPECT_FALSE(beside(pixels, 2, side, 7.0) == kHandleCentre);
    }
}

TEST_F(PaintedHandles, LieInDiscsWhereTheCurveNeedNotPassThem) {
    scene_.addPicks(arcOnPlate());
    SketchCurveOptions options = curve(scene_).options;
    const auto dotsRound = [&](int pick) {
        const Pixels pixels = scene_.withSketch();
        pixels.save("leeway");
        int found = 0;
        for (int i = 0; i < 36; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 36;
            const Vec3 offset = 0.06 * Vec3(std::cos(angle), std::sin(angle), 0.0);
            const Vec3 place = curve(scene_).picks[pick].position + offset;
            found += pixels.countNear(scene_.pixelOf(place), 2.0, kLeeway) > 0 ? 1 : 0;
        }
        return found;
    };
    EXPECT_LE(dotsRound(1), 2);
    options.solver.pickTolerance = {.value = 0.06};
    scene_.session().setOptions(options);
    scene_.session().settle();
    EXPECT_GE(dotsRound(1), 28);  // but where the curve crosses it
    scene_.session().setCorner(1, true);
    EXPECT_LE(dotsRound(1), 4);
}

TEST_F(PaintedHandles, AreMarkedWhereTheySnap) {
    const auto snapAt = [&](const Vec3& point) {
        Pointer pointer = scene_.over(point);
        pointer.snaps = true;
        static_cast<void>(scene_.session().move(pointer));
        const Snap& snapped = scene_.session().snapped();
        const Pixels pixels = scene_.withSketch();
        pixels.save(std::string("snap-") + nameOf(snapped.kind));
        const SurfacePoint at = snapped.point;
        EXPECT_EQ(pixels.count(kSnapMark) > 0, snapped.kind != SnapKind::None);
        if (snapped.kind != SnapKind::None) {
            const Vec3 place = scene_.positionOf(at);
            EXPECT_EQ(
                pixels.countNear(scene_.pixelOf(place), 26.0, kSnapMark), pixels.count(kSnapMark)
            );
        }
        return snapped.kind;
    };
    scene_.addPicks({{0.2, 0.8, 0}, {0.31, 0.33, 0}});
    scene_.session().newCurve();
    scene_.addPicks({{0.5, 0.6, 0}});
    EXPECT_EQ(snapAt({0.55, 0.45, 0}), SnapKind::None);
    EXPECT_EQ(snapAt({0.702, 0.297, 0}), SnapKind::Vertex);
    EXPECT_EQ(snapAt({0.001, 0.55, 0}), SnapKind::Boundary);
}

TEST_F(PaintedHandles, HaveAMarkOfItsOwnForEachKindOfSnapping) {
    std::set<std::string> seen;
    const std::array kKinds = {
        SnapKind::Pick,
        SnapKind::Boundary,
        SnapKind::Crease,
        SnapKind::Ridge,
        SnapKind::Valley,
        SnapKind::Vertex
    };
    for (const NamedLook& named : allLooks()) {
        scene_.look = named.look;
        const Pixels without = scene_.withoutSketch();
        for (std::size_t i = 0; i < kKinds.size(); ++i) {
            ScreenNode place;
            place.at = {100.0 + 80.0 * static_cast<double>(i), 240.0};
            ScreenBatch batch;
            addSnapGlyph(batch, place, kKinds.at(i), 1.0);
            const ScreenFrame frame(scene_.view());
            batch.draw();
        }
        const Pixels with;
        with.save("glyphs-" + named.name);
        for (std::size_t i = 0; i < kKinds.size(); ++i) {
            const double x = 100.0 + 80.0 * static_cast<double>(i);
            EXPECT_GE(contrastNear(with, without, {x, 240.0}, 26.0), kClear) << named.name;
            std::string shape;
            for (int dy = -26; dy < 26; ++dy) {
                for (int dx = -26; dx < 26; ++dx) {
                    shape += with.at(static_cast<int>(x) + dx, 240 + dy) == kSnapMark ? '#' : ' ';
                }
            }
            if (named.name == "white") {
                EXPECT_TRUE(seen.insert(shape).second) << nameOf(kKinds.at(i));
            }
        }
    }
}

// What a host has set is as before, down to the depth of its stacks, and nothing went wrong.
TEST_F(PaintedHandles, LeaveOpenGLAsItWas) {
    scene_.addPicks(arcOnPlate());
    static_cast<void>(scene_.withoutSketch());
    glLineWidth(3.0F);
    glPointSize(5.0F);
    glEnable(GL_LIGHTING);
    glEnable(GL_CLIP_PLANE0);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glMatrixMode(GL_TEXTURE);
    glColor4ub(10, 20, 30, 40);
    const auto state = [] {
        std::vector<double> all;
        for (const GLenum name : std::array<GLenum, 27>{
                 GL_LIGHTING,
                 GL_TEXTURE_1D,
                 GL_TEXTURE_2D,
                 GL_FOG,
                 GL_CULL_FACE,
                 GL_ALPHA_TEST,
                 GL_STENCIL_TEST,
                 GL_BLEND,
                 GL_DEPTH_TEST,
                 GL_DEPTH_FUNC,
                 GL_DEPTH_WRITEMASK,
                 GL_BLEND_SRC,
                 GL_BLEND_DST,
                 GL_CLIP_PLANE0,
                 GL_CULL_FACE_MODE,
                 GL_POLYGON_MODE,
                 GL_SHADE_MODEL,
                 GL_MATRIX_MODE,
                 GL_LINE_WIDTH,
                 GL_POINT_SIZE,
                 GL_CURRENT_COLOR,
                 GL_MODELVIEW_MATRIX,
                 GL_PROJECTION_MATRIX,
                 GL_MODELVIEW_STACK_DEPTH,
                 GL_ATTRIB_STACK_DEPTH,
                 GL_PROJECTION_STACK_DEPTH,
                 GL_VIEWPORT
             }) {
            std::array<GLdouble, 16> values{};
            glGetDoublev(name, values.data());
            all.insert(all.end(), values.begin(), values.end());
        }
        return all;
    };
    const std::vector<double> before = state();
    paintSketch(scene_.session(), scene_.view());
    EXPECT_EQ(state(), before);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace bspline_curve
