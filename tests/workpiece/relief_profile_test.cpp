// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/imprint.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/workpiece.h"
#include "imprint/projected_polyline.h"
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/refusal.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"
#include "workpiece/workpiece_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

// Strokes, slots and profiles of reliefs, against closed forms.
namespace bspline_curve {

namespace {

using namespace test_support;
using std::numbers::pi;

SurfacePolyline lineOn(const Workpiece& workpiece, const std::vector<Vec3>& points, bool isClosed) {
    const Surface& surface = surfaceOf(workpiece);
    const TriangleTree tree(surface.vertices(), surface.faces());
    return projectedPolyline(surface, tree, {.points = points, .closed = isClosed}, 0.1);
}

std::vector<Vec3> circleOf(double radius, double height) {
    std::vector<Vec3> points;
    for (int i = 0; i < 120; ++i) {
        const double turn = 2.0 * pi * i / 120;
        points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), height);
    }
    return points;
}

/// What a relief of the parts inside adds to the volume above z = 0 or of a closed mesh.
double addedBy(const Imprint& imprint, const CutChoice& choice) {
    const CutMeshes made = cutOn(imprint, choice);
    EXPECT_EQ(made.pieces.size(), 1U);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    const TriangleMesh& mesh = made.pieces.front().mesh.mesh();
    EXPECT_NO_THROW(Surface{mesh});
    EXPECT_TRUE(made.pieces.front().mesh.parts().crossing.empty());
    return volumeOf(mesh) - volumeOf(imprint.mesh->mesh);
}

CutChoice slot(double depth, ReliefProfile profile, double width = 0.0) {
    return {
        .keep = PartChoice{.which = PartChoice::Which::Inside},
        .relief = -depth,
        .profile = profile,
        .profileWidth = width
    };
}

class Slots : public testing::Test {
protected:
    // The volume under a plate in the plane z = 0 is none.
    Workpiece plane{plate(20, 20)};
    double length = 0.5;
    double width = 0.1;
    double depth = 0.04;
    Imprint straight = strokesOn(
        plane, std::vector{lineOn(plane, {{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}}, false)}, width
    );
};

TEST_F(Slots, AlongALineAreBoundedByStadiums) {
    EXPECT_EQ(straight.parts.strokes, std::vector{1});
    const double area = length * width + pi * width * width / 4.0;
    EXPECT_NEAR(straight.parts.parts[1].area, area, 1e-3 * area);
    const double volume = -addedBy(straight, slot(depth, ReliefProfile::Step));
    EXPECT_NEAR(volume, area * depth, 0.01 * area * depth);
}

TEST_F(Slots, WithARampAreGroovesOfThatSection) {
    // Half of the width down to the line: a V with half of a cone at either end.
    const double radius = width / 2.0;
    const double vee = length * radius * depth + pi * radius * radius * depth / 3.0;
    EXPECT_NEAR(-addedBy(straight, slot(depth, ReliefProfile::Ramp)), vee, 0.01 * vee);
    // A quarter of the width: a trapezium, and frustums.
    const double top = radius;
    const double bottom = radius / 2.0;
    const double flat = length * (top + bottom) * depth +
                        pi * depth * (top * top + top * bottom + bottom * bottom) / 3.0;
    EXPECT_NEAR(-addedBy(straight, slot(depth, ReliefProfile::Ramp, bottom)), flat, 0.01 * flat);
}

TEST_F(Slots, ThatAreRoundAreHalfEllipses) {
    const double radius = width / 2.0;
    const double volume =
        length * pi * radius * depth / 2.0 + 2.0 * pi * radius * radius * depth / 3.0;
    EXPECT_NEAR(-addedBy(straight, slot(depth, ReliefProfile::Round)), volume, 0.01 * volume);
}

TEST_F(Slots, ThatCrossAreOneStroke) {
    const Imprint crossed = strokesOn(
        plane,
        std::vector{
            lineOn(plane, {{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}}, false),
            lineOn(plane, {{0.5, 0.25, 0.0}, {0.5, 0.75, 0.0}}, false)
        },
        width
    );
    const double area = 2.0 * (length * width + pi * width * width / 4.0) - width * width;
    ASSERT_EQ(crossed.parts.strokes, std::vector{1});
    EXPECT_NEAR(crossed.parts.parts[1].area, area, 1e-3 * area);
    EXPECT_NEAR(
        addedBy(crossed, slot(-depth, ReliefProfile::Step)), area * depth, 0.01 * area * depth
    );
    EXPECT_GT(addedBy(crossed, slot(-depth, ReliefProfile::Round)), 0.0);
}

TEST_F(Slots, OfNoWidthOrOneThatNothingIsBesideAreRefused) {
    const std::vector lines{lineOn(plane, {{0.25, 0.5, 0.0}, {0.75, 0.5, 0.0}}, false)};
    for (const double bad : {0.0, -1.0, std::nan("")}) {
        expectRefused(
            [&] { return strokesOn(plane, lines, bad); },
            InputErrorCode::BadOption,
            "the width of strokes must be a number above 0"
        );
    }
    expectRefused(
        [&] { return strokesOn(plane, lines, 5.0); }, InputErrorCode::NoPath, "at this distance"
    );
}

TEST(Slot, RoundASphereTakesTheBandBetweenTwoCones) {
    const Workpiece sphere(icosphere(5));
    const double width = 0.3;
    const Imprint ring =
        strokesOn(sphere, std::vector{lineOn(sphere, circleOf(1.0, 0.0), true)}, width);
    const double depth = 0.2;
    // Between latitudes of half the width; radii from 1 - depth to 1.
    const double band = 4.0 * pi * std::sin(width / 2.0);
    const double volume = band * (1.0 - std::pow(1.0 - depth, 3)) / 3.0;
    EXPECT_NEAR(-addedBy(ring, slot(depth, ReliefProfile::Step)), volume, 0.01 * volume);
}

TEST(Slot, RoundATorusIsTheIntegralOverItsTube) {
    const double tube = 0.3;
    const Workpiece ring(torus(160, 60, 1.0, tube));
    const double width = 0.1;
    const double depth = 0.03;
    const Imprint around =
        strokesOn(ring, std::vector{lineOn(ring, circleOf(1.3, 0.0), true)}, width);
    // Over the angle a of the tube, 2 pi (1 + r cos a) r from the ground of the slot to the tube.
    double volume = 0.0;
    const int steps = 10000;
    for (int i = 0; i < steps; ++i) {
        const double share = 2.0 * (i + 0.5) / steps - 1.0;
        const double ground = tube - depth * std::sqrt(1.0 - share * share);
        const double angle = share * width / 2.0 / tube;
        volume += 2.0 * pi * width / tube / steps *
                  ((tube * tube - ground * ground) / 2.0 +
                   std::cos(angle) * (std::pow(tube, 3) - std::pow(ground, 3)) / 3.0);
    }
    EXPECT_NEAR(-addedBy(around, slot(depth, ReliefProfile::Round)), volume, 0.01 * volume);
}

TEST(Relief, WithAProfileRisesFromItsRim) {
    const Workpiece plane(plate(20, 20, 2.0, 2.0));
    std::vector<Vec3> points = circleOf(0.5, 0.0);
    for (Vec3& point : points) {
        point += Vec3(1.0, 1.0, 0.0);
    }
    const Imprint disc = imprintOn(plane, std::vector{lineOn(plane, points, true)});
    const double radius = 0.5;
    const double height = 0.1;
    // Without a width it is the height.
    const double inner = radius - height;
    const double frustum = pi * height * (radius * radius + radius * inner + inner * inner) / 3.0;
    EXPECT_NEAR(addedBy(disc, slot(-height, ReliefProfile::Ramp)), frustum, 0.01 * frustum);
    EXPECT_NEAR(addedBy(disc, slot(height, ReliefProfile::Ramp)), -frustum, 0.01 * frustum);
    // A disc with a quarter of an ellipse around.
    const double width = 0.2;
    const double core = radius - width;
    const double rounded = pi * core * core * height +
                           2.0 * pi * height * (core * width * pi / 4.0 + width * width / 3.0);
    EXPECT_NEAR(addedBy(disc, slot(-height, ReliefProfile::Round, width)), rounded, 0.01 * rounded);
}

TEST(Relief, WithAProfileKeepsPartsAndMovesNoRim) {
    const Workpiece plane(plate(20, 20));
    std::vector<Vec3> points = circleOf(0.3, 0.0);
    for (Vec3& point : points) {
        point += Vec3(0.5, 0.5, 0.0);
    }
    const Imprint disc = imprintOn(plane, std::vector{lineOn(plane, points, true)});
    const CutMeshes made = cutOn(disc, slot(-0.1, ReliefProfile::Round));
    const MadeMesh& mesh = made.pieces.front().mesh;
    double area = 0.0;
    for (std::size_t f = 0; f < mesh.mesh().faces.size(); ++f) {
        const auto& [a, b, c] = mesh.mesh().faces[f];
        Vec3 from = mesh.mesh().vertices[b] - mesh.mesh().vertices[a];
        Vec3 to = mesh.mesh().vertices[c] - mesh.mesh().vertices[a];
        from.z() = to.z() = 0.0;
        area += mesh.labels()[f] == 1 ? from.cross(to).norm() / 2.0 : 0.0;
        ASSERT_GE(mesh.faceOf(static_cast<int>(f)), 0);
    }
    EXPECT_NEAR(area, disc.parts.parts[1].area, 1e-12);
}

}  // namespace

}  // namespace bspline_curve
