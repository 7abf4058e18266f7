// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/points_on_mended.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <optional>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A plate whose face 3 is turned over, and is there once more as the last face.
TriangleMesh plateWithTwin() {
    TriangleMesh mesh = withFaceReversed(plate(3, 3), 3);
    mesh.faces.push_back(mesh.faces[3]);
    return mesh;
}

// Splits are in repair_test.cpp.
TEST(PointsOnMended, LeadsBackExactly) {
    const MeshRepair repair = repairMesh(plateWithTwin());
    const PointsOnMended there(repair);
    ASSERT_EQ(repair.changedCorners.size(), 1U);
    for (const int face : {2, 3, 4}) {
        for (const Vec3& weights : {Vec3(0.1, 0.2, 0.7), Vec3(1e-13, 0.3, 0.7), Vec3(0, 1, 0)}) {
            const SurfacePoint point{.face = face, .barycentric = weights};
            const std::optional<SurfacePoint> back = there.pointAt(repair.toOrigin(point));
            ASSERT_TRUE(back.has_value());
            EXPECT_EQ(back->face, face);
            EXPECT_EQ(back->barycentric, weights);
        }
    }
}

// Of two parts of face 0 the first has its corners in a line.
TEST(PointsOnMended, LeavesPartsWithoutWidthAlone) {
    MeshRepair repair;
    repair.faceOrigins = {0, 0};
    const Vec3 middle(0.5, 0.5, 0.0);
    repair.changedCorners[0] << Vec3::UnitX(), middle, Vec3::UnitY();
    repair.changedCorners[1] << Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ();
    const std::optional<SurfacePoint> point =
        PointsOnMended(repair).pointAt({.face = 0, .barycentric = {0.2, 0.3, 0.5}});
    ASSERT_TRUE(point.has_value());
    EXPECT_EQ(point->face, 1);
    EXPECT_EQ(point->barycentric, Vec3(0.2, 0.3, 0.5));
}

TEST(PointsOnMended, HasNothingInFacesThatWereRemoved) {
    const TriangleMesh mesh = plateWithTwin();
    const MeshRepair repair = repairMesh(mesh);
    const PointsOnMended there(repair);
    const int twin = static_cast<int>(mesh.faces.size()) - 1;
    const SurfacePoint point{.face = twin, .barycentric = {0.2, 0.3, 0.5}};
    EXPECT_FALSE(there.pointAt(point).has_value());
    SurfacePolyline line;
    line.surfacePoints = {{.face = 3, .barycentric = {0.2, 0.3, 0.5}}, point};
    line.points.resize(2);
    line.parameters = {0.0, 1.0};
    expectRefused(
        [&] { return there.lineAt(line); },
        InputErrorCode::NoPath,
        "left out of the mended",
        {{twin}}
    );
}

}  // namespace
}  // namespace bspline_curve
