// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/snapping.h"

#include "support/meshes.h"
#include "support/places.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

using namespace test_support;

Vec3 snappedTo(
    const TestSurface& on,
    const Vec3& p,
    double reach,
    SnapKind kind,
    const Sketch& s = {},
    const SnapOptions& options = {},
    int own = -1
) {
    const Snap found = snap(on.surface, s, own, on.nearest(p), reach, options);
    EXPECT_EQ(found.kind, kind);
    return on.surface.position(found.point);
}

TEST(PicksSnap, ToBoundariesAndCreasesAtTheNearestPoint) {
    const TestSurface sheet(plate(10, 10));
    EXPECT_LT(
        (snappedTo(sheet, {0.53, 0.02, 0}, 0.05, SnapKind::Boundary) - Vec3(0.53, 0, 0)).norm(),
        1e-15
    );
    const TestSurface cube(box(10));
    EXPECT_LT(
        (snappedTo(cube, {0.53, 0.02, 1}, 0.05, SnapKind::Crease) - Vec3(0.53, 0, 1)).norm(), 1e-15
    );
}

TEST(PicksSnap, ToTheNearestVertexWhereThereIsNothingElse) {
    const TestSurface sheet(plate(10, 10));
    EXPECT_LT(
        (snappedTo(sheet, {0.52, 0.41, 0}, 0.05, SnapKind::Vertex) - Vec3(0.5, 0.4, 0)).norm(),
        1e-15
    );
    const Vec3 alone(0.55, 0.43, 0);
    EXPECT_LT((snappedTo(sheet, alone, 0.01, SnapKind::None) - alone).norm(), 1e-15);
}

TEST(PicksSnap, ToRidgesAndValleysWhereTheseAreHigh) {
    const TestSurface sheet(plate(10, 10));
    std::vector<double> values(sheet.surface.vertices().size(), 0.0);
    values[(5 * 11) + 5] = 0.9;  // at (0.5, 0.5)
    values[(5 * 11) + 6] = 0.6;
    SnapOptions options;
    options.valley = ScalarField(values);
    EXPECT_LT(
        (snappedTo(sheet, {0.57, 0.5, 0}, 0.12, SnapKind::Valley, {}, options) - Vec3(0.5, 0.5, 0))
            .norm(),
        1e-15
    );
    static_cast<void>(snappedTo(sheet, {0.81, 0.5, 0}, 0.12, SnapKind::Vertex, {}, options));
    options.ridge = options.valley;
    static_cast<void>(snappedTo(sheet, {0.57, 0.5, 0}, 0.12, SnapKind::Ridge, {}, options));
}

TEST(PicksSnap, ToPicksOfOtherCurvesFirst) {
    const TestSurface sheet(plate(10, 10));
    Sketch sketch;
    for (const double x : {0.5, 0.54}) {
        sketch.curves.push_back(std::make_shared<SketchCurve>());
        const SurfacePoint point = sheet.nearest(Vec3(x, 0.03, 0));
        sketch.curves.back()->picks.push_back({point, sheet.surface.position(point)});
    }
    EXPECT_LT(
        (snappedTo(sheet, {0.53, 0.02, 0}, 0.05, SnapKind::Pick, sketch) - Vec3(0.54, 0.03, 0))
            .norm(),
        1e-15
    );
    EXPECT_LT(
        (snappedTo(sheet, {0.53, 0.02, 0}, 0.05, SnapKind::Pick, sketch, {}, 1) -
         Vec3(0.5, 0.03, 0))
            .norm(),
        1e-15
    );
    sketch.curves[1]->look.isHidden = true;
    EXPECT_LT(
        (snappedTo(sheet, {0.53, 0.02, 0}, 0.05, SnapKind::Pick, sketch) - Vec3(0.5, 0.03, 0))
            .norm(),
        1e-15
    );
}

// On the far side of a thin sheet a pick is near, but not on faces that are.
TEST(PicksSnap, NotThroughTheSurface) {
    const TestSurface thin(box(10, {1.0, 1.0, 0.01}));
    Sketch sketch;
    sketch.curves.push_back(std::make_shared<SketchCurve>());
    const SurfacePoint below = thin.nearest(Vec3(0.51, 0.52, 0.0));
    sketch.curves.back()->picks.push_back({below, thin.surface.position(below)});
    static_cast<void>(snappedTo(thin, {0.52, 0.51, 0.01}, 0.05, SnapKind::Vertex, sketch));
}

}  // namespace
}  // namespace bspline_curve
