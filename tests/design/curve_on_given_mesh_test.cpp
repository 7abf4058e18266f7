// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_on_given_mesh.h"

#include "bspline_curve/designer.h"
#include "support/meshes.h"
#include "surface/mending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// A noisy sphere whose first face is there three times, so that all others have other numbers once
// it is mended; and a curve that is far from it, with few long spans.
TEST(BringBack, NamesFacesOfTheGivenMesh) {
    TriangleMesh mesh = withNoise(icosphere(3), 0.12, 7);
    mesh.faces.insert(mesh.faces.begin(), 2, mesh.faces.front());
    const Mended<CurveDesigner> mended =
        makeMended(mesh, {}, [](TriangleMesh made) { return CurveDesigner(std::move(made)); });
    ASSERT_NE(mended.repair(), nullptr);
    const TriangleMesh& made = mended.made.mesh();
    ASSERT_EQ(made.faces.size() + 2, mesh.faces.size());
    const Curve curve = mended.made.design(
        {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400]},
        {.maxRounds = 1, .minimumSpan = 0.1}
    );
    ASSERT_TRUE(curve.report.farPart.has_value());

    Curve given = curve;
    bringBack(given, mended.repair());
    const std::vector<int>& before = curve.report.farPart->faces;
    const std::vector<int>& after = given.report.farPart->faces;
    ASSERT_EQ(after.size(), before.size());
    EXPECT_TRUE(std::ranges::is_sorted(after));
    EXPECT_NE(after, before);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(mesh.faces[after[i]], made.faces[before[i]]);
    }
    for (std::size_t i = 0; i < curve.polyline.points.size(); ++i) {
        const SurfacePoint& point = given.polyline.surfacePoints[i];
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            position += point.barycentric[k] * mesh.vertices[mesh.faces[point.face][k]];
        }
        EXPECT_LT((position - given.polyline.points[i]).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace bspline_curve
