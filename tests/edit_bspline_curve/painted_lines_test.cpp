// SPDX-License-Identifier: GPL-3.0-or-later
#include "painted_sketch.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

class PaintedLines : public APaintedSketch {
protected:
    // Around a sphere, on its front where z > 0.
    static void drawRing(PaintedScene& scene) {
        std::vector<Vec3> ring;
        for (int i = 0; i < 8; ++i) {
            const double angle = std::numbers::pi * i / 4.0;
            ring.emplace_back(std::cos(angle), 0.3 * std::sin(angle), std::sin(angle));
        }
        scene.addPicks(ring);
        scene.session().setClosed(true);
        scene.session().settle();
    }

    // Of the curve's points between two heights.
    static Contrasts between(PaintedScene& scene, double low, double high) {
        std::vector<Vec3> points;
        for (const Vec3& p : curve(scene).shownPoints()) {
            if (p.z() >= low && p.z() <= high) {
                points.push_back(p);
            }
        }
        EXPECT_FALSE(points.empty());
        return along(scene, points);
    }
};

TEST_F(PaintedLines, AreSeenOnAnyMesh) {
    PaintedScene scene(plate(10, 10));
    scene.addPicks(arcOnPlate());
    for (const NamedLook& named : allLooks()) {
        scene.look = named.look;
        EXPECT_GE(along(scene, curve(scene).shownPoints()).least, kClear) << named.name;
        EXPECT_GE(leastOfHandles(scene), kClear) << named.name;
        scene.withSketch().save("line-" + named.name);
    }
}

TEST_F(PaintedLines, AreSeenInAnyColour) {
    PaintedScene scene(plate(10, 10));
    scene.addPicks(arcOnPlate());
    for (const SketchColour& colour : std::vector<SketchColour>{
             {0, 0, 0},
             {255, 255, 255},
             {119, 119, 119},
             {255, 220, 0},
             {0, 90, 255},
             {0, 160, 80},
             {190, 60, 200}
         }) {
        const std::string name = std::to_string(colour.red) + " " + std::to_string(colour.green);
        scene.session().sketch().curves[0]->look.colour = colour;
        for (const NamedLook& named : allLooks()) {
            scene.look = named.look;
            EXPECT_GE(along(scene, curve(scene).shownPoints()).least, kClear)
                << named.name << " under " << name;
        }
        scene.look = {};
        const Pixels pixels = scene.withSketch();
        EXPECT_GT(pixels.count(colour), 300) << name;
        pixels.save("colour-" + name);
    }
}

TEST_F(PaintedLines, OfThePreviewAreSeenOnAnyMesh) {
    PaintedScene scene(plate(10, 10));
    const std::vector<Vec3>& arc = arcOnPlate();
    scene.addPicks({arc[0], arc[1], arc[2]});
    static_cast<void>(scene.withoutSketch());
    scene.preview(scene.over({0.85, 0.3, 0}));
    const std::vector<Vec3> points = scene.session().preview()->polyline.points;
    for (const NamedLook& named : allLooks()) {
        scene.look = named.look;
        EXPECT_GE(along(scene, points).least, kClear) << named.name;
        scene.withSketch().save("preview-" + named.name);
    }
}

TEST_F(PaintedLines, OfAStrokeAreSeenOnAnyMeshWhileItIsDrawn) {
    PaintedScene scene(plate(10, 10));
    static_cast<void>(scene.withoutSketch());
    std::vector<Vec3> points;
    for (int i = 0; i <= 40; ++i) {
        points.emplace_back(0.15 + 0.7 * i / 40.0, 0.5 + 0.2 * std::sin(0.2 * i), 0.0);
        Pointer pointer = scene.over(points.back());
        pointer.strokes = true;
        i == 0 ? scene.session().press(pointer) : scene.session().move(pointer);
    }
    for (const NamedLook& named : allLooks()) {
        scene.look = named.look;
        EXPECT_GE(along(scene, points).least, kClear) << named.name;
        scene.withSketch().save("stroke-" + named.name);
    }
}

TEST_F(PaintedLines, OfOtherCurvesAreSeenUnlessTheyAreHidden) {
    PaintedScene scene(plate(10, 10));
    scene.addPicks(arcOnPlate());
    scene.session().newCurve();
    scene.addPicks({{0.2, 0.2, 0}, {0.8, 0.25, 0}});
    ASSERT_EQ(scene.session().sketch().active, 1);
    for (const NamedLook& named : allLooks()) {
        scene.look = named.look;
        EXPECT_GE(along(scene, curve(scene, 0).shownPoints()).least, kClear) << named.name;
        scene.withSketch().save("others-" + named.name);
    }
    scene.session().sketch().curves[0]->look.isHidden = true;
    EXPECT_EQ(along(scene, curve(scene, 0).shownPoints()).most, 1.0);
    EXPECT_GE(along(scene, curve(scene, 1).shownPoints()).least, kClear);
    scene.session().sketch().curves[1]->look.isHidden = true;
    EXPECT_EQ(leastOfHandles(scene), 1.0);
}

TEST_F(PaintedLines, AreDimmedWhereTheSurfaceHidesThem) {
    for (const bool isOrthographic : {false, true}) {
        PaintedScene scene(withNoise(icosphere(4), 0.003, 7));
        scene.isOrthographic = isOrthographic;
        drawRing(scene);
        for (const NamedLook& named : allLooks()) {
            scene.look = named.look;
            const Contrasts seen = between(scene, 0.2, 2.0);
            const Contrasts hidden = between(scene, -2.0, -0.2);
            EXPECT_GE(seen.least, kClear) << named.name;
            EXPECT_GE(hidden.least, 1.25) << named.name;
            EXPECT_LT(hidden.most, 0.8 * seen.least) << named.name;
            scene.withSketch().save((isOrthographic ? "sphere-ortho-" : "sphere-") + named.name);
        }
    }
}

// Also of a plate so thin that it is a pixel or two across.
TEST_F(PaintedLines, DoNotShineThroughThinPlates) {
    PaintedScene scene(box(10, {1.0, 1.0, 0.004}));
    std::vector<Vec3> below = arcOnPlate();
    scene.addPicks(below);
    for (const double tilt : {0.0, -40.0, 40.0, 70.0, 80.0}) {
        scene.tilt = tilt;
        const Contrasts hidden = along(scene, curve(scene).shownPoints());
        EXPECT_LT(hidden.most, kClear) << tilt;
        EXPECT_GE(hidden.least, 1.2) << tilt;
        scene.withSketch().save("thin-" + std::to_string(static_cast<int>(tilt)));
        scene.tilt = 180.0 + tilt;
        EXPECT_GE(along(scene, curve(scene).shownPoints()).least, kClear) << scene.tilt;
    }
}

TEST_F(PaintedLines, AreSeenOnSteepFacesAndFromBehindOnes) {
    for (const bool isOrthographic : {false, true}) {
        PaintedScene scene(plate(10, 10));
        scene.isOrthographic = isOrthographic;
        scene.addPicks(arcOnPlate());
        for (const double tilt : {0.0, 60.0, 75.0, 80.0, 84.0}) {
            for (const double angle : {tilt, -tilt, 180.0 + tilt, 180.0 - tilt}) {
                scene.tilt = angle;
                EXPECT_GE(along(scene, curve(scene).shownPoints()).least, kClear) << angle;
                scene.withSketch().save("steep-" + std::to_string(static_cast<int>(angle)));
            }
        }
    }
}

// Across edges, and along them: in a valley the surface is before the line on both sides.
TEST_F(PaintedLines, AreSeenOnRidgesAndInValleys) {
    for (const double depth : {0.3, -0.3}) {
        TriangleMesh fold = plate(2, 10);
        for (Vec3& vertex : fold.vertices) {
            vertex.z() = vertex.x() == 0.5 ? depth : 0.0;
        }
        PaintedScene scene(fold);
        for (const double tilt : {0.0, 45.0, 65.0}) {
            scene.tilt = tilt;
            scene.session().newCurve();
            scene.addPicks({{0.5, 0.2, depth}, {0.5, 0.5, depth}, {0.5, 0.8, depth}});
            scene.session().newCurve();
            scene.addPicks({{0.3, 0.3, 0.6 * depth}, {0.7, 0.6, 0.6 * depth}});
            scene.withSketch().save("fold-" + std::to_string(depth) + std::to_string(tilt));
            EXPECT_GE(along(scene, curve(scene, 0).shownPoints()).least, kClear) << depth << tilt;
            EXPECT_GE(along(scene, curve(scene, 1).shownPoints()).least, kClear) << depth << tilt;
            scene.session().removeCurve(1);
            scene.session().removeCurve(0);
        }
    }
}

// The near plane opens the sphere: what was on its front is gone, and its inside is seen.
TEST_F(PaintedLines, EndAtTheNearPlane) {
    for (const bool isOrthographic : {false, true}) {
        PaintedScene scene(icosphere(4));
        scene.isOrthographic = isOrthographic;
        scene.cut = 1.0;
        drawRing(scene);
        EXPECT_GE(between(scene, -2.0, -0.1).least, kClear);
        EXPECT_EQ(between(scene, 0.3, 2.0).most, 1.0);
        scene.withSketch().save("near-plane");
    }
}

TEST_F(PaintedLines, AreTwiceAsWideWhereAPixelIsFour) {
    PaintedScene scene(plate(10, 10));
    scene.look = {};
    scene.addPicks(arcOnPlate());
    const int once = scene.withSketch().count(SketchColour{225, 60, 30});
    scene.ratio = 2.0;
    const Pixels pixels = scene.withSketch();
    pixels.save("ratio-2");
    EXPECT_GT(pixels.count(SketchColour{225, 60, 30}), 1.7 * once);
}

}  // namespace
}  // namespace bspline_curve
