// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of the paper give a curve that can be used.
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(PaperPreset, GivesAUsableCurveOnASphere) {
    const TriangleMesh mesh = icosphere(3);
    const CurveDesigner designer(mesh);
    const std::vector<Vec3> picks = {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400]};
    for (const bool closed : {false, true}) {
        SolverOptions options = paperPreset();
        options.closed = closed;
        const Curve curve = designer.design(picks, options);
        EXPECT_TRUE(curve.report.usable)
            << name(curve.report.status) << ", " << curve.report.maxDistance;
        expectStrict(surfaceOf(designer), curve.polyline);
    }
}

}  // namespace
}  // namespace bspline_curve
