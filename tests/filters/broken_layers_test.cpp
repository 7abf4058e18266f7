// SPDX-License-Identifier: GPL-3.0-or-later
// The filters on layers whose meshes are mended in memory.
#include "filters/broken_plates.h"
#include "filters/run_filters.h"
#include "filters/runs_on_plates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(RunCurveFilter, DrawsOnBrokenMeshesAndNamesTheFacesOfTheLayer) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        CurveRequest request;
        request.field = FieldRequest{.options = {.kind = FieldKind::Quality}};
        request.solver.fieldWeight = 1.0;
        const CurveResult result = draw(broken.layer, request);
        EXPECT_TRUE(figure<bool>(result.figures, "usable"));
        ASSERT_EQ(result.log.warnings.size(), 1u);
        expectPart(result.log.warnings[0], "The mesh was mended: ");
        expectPart(result.log.warnings[0], broken.said);
        const SurfacePolyline& line = result.curve.polyline;
        const TriangleMesh& mesh = broken.layer.mesh;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const SurfacePoint& point = line.surfacePoints[i];
            Vec3 position = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                position += point.barycentric[k] * mesh.vertices[mesh.faces[point.face][k]];
            }
            EXPECT_LT((position - line.points[i]).norm(), 1e-12);
            EXPECT_NEAR(result.quality[i], 2.0 * position.x() + position.y(), 1e-12);
        }
    }
}

TEST(RunCurveFilter, RefusesBrokenMeshesWhereItIsStrictEvenAfterOneWasDrawn) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        WorkpieceCache designers;
        CurveRequest strict;
        strict.mending.strict = true;
        const auto refused = [&] { return draw(broken.layer, strict, designers); };
        expectPart(refusal(refused), broken.refused);
        static_cast<void>(draw(broken.layer, {}, designers));
        EXPECT_TRUE(figure<bool>(draw(broken.layer, {}, designers).figures, "surface_kept"));
        expectPart(refusal(refused), broken.refused);
    }
}

TEST(RunCurveFilter, AvoidsTheFacesThatAreSelectedOnABrokenLayer) {
    for (BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        const TriangleMesh& mesh = broken.layer.mesh;
        std::vector<char>& selected = broken.layer.selectedFaces;
        for (const Triangle& face : mesh.faces) {
            const auto isInWall = [&](int v) {
                const Vec3& p = mesh.vertices[v];
                return p.x() > 0.2 && p.x() < 0.8 && p.y() > 0.3;
            };
            selected.push_back(std::ranges::all_of(face, isInWall) ? 1 : 0);
        }
        CurveRequest request;
        request.avoid.by = FaceChoice::By::SelectedFaces;
        WorkpieceCache designers;
        const std::vector<Vec3> picks = {{0.1, 0.9, 0.0}, {0.9, 0.9, 0.0}};
        const CurveResult result =
            runCurveFilter(broken.layer, {.tool = picks, .layer = {}}, request, designers);
        EXPECT_EQ(
            figure<int>(result.figures, "avoided_faces"), std::ranges::count(selected, char{1})
        );
        for (const SurfacePoint& point : result.curve.polyline.surfacePoints) {
            EXPECT_EQ(selected[point.face], 0);
        }
    }
}

TEST(RunFieldFilter, HasAValueForEachVertexOfABrokenLayer) {
    for (const BrokenPlate& broken : brokenPlates()) {
        SCOPED_TRACE(broken.name);
        FieldLayerRequest request;
        request.options.kind = FieldKind::Quality;
        const FieldResult result = runFieldFilter(broken.layer, request);
        EXPECT_EQ(result.values, broken.layer.quality);
        ASSERT_EQ(result.log.warnings.size(), 1u);
        expectPart(result.log.warnings[0], broken.said);
        request.mending.strict = true;
        expectPart(refusal([&] { return runFieldFilter(broken.layer, request); }), broken.refused);
    }
}

}  // namespace
}  // namespace bspline_curve
