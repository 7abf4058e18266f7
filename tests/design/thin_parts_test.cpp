// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over the rim of a lens thinner than its faces: what slips through it does not find back.
#include "bspline_curve/designer.h"
#include "curve_checks.h"
#include "either_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TriangleMesh lens(double thickness) {
    TriangleMesh mesh = icosphere(4);
    for (Vec3& vertex : mesh.vertices) {
        vertex.z() *= thickness;
    }
    return mesh;
}

/// The vertex of the lens next to (x, y), above (z > 0) or below.
Vec3 vertexNear(const TriangleMesh& mesh, const Vec3& place) {
    Vec3 nearest = Vec3::Constant(10.0);
    for (const Vec3& vertex : mesh.vertices) {
        const bool isNearer =
            (vertex - place).head<2>().norm() < (nearest - place).head<2>().norm();
        if (vertex.z() * place.z() > 0.0 && isNearer) {
            nearest = vertex;
        }
    }
    return nearest;
}

std::vector<Vec3> picksOn(const TriangleMesh& mesh, const std::vector<Vec3>& places) {
    std::vector<Vec3> picks;
    for (const Vec3& place : places) {
        picks.push_back(vertexNear(mesh, place));
    }
    return picks;
}

class Lens : public testing::TestWithParam<double> {
protected:
    void expectCurveOverTheRim(const std::vector<Vec3>& places) const {
        // A curve that asks for knots without end has passed through the lens.
        constexpr std::size_t kManyControlPoints = 200;
        const TriangleMesh mesh = lens(GetParam());
        const CurveDesigner designer = designerIn(ShellKind::Local, mesh);
        const Curve curve = goodCurve(designer, picksOn(mesh, places));
        EXPECT_LT(curve.spline.controlPoints.size(), kManyControlPoints);
    }
};

TEST_P(Lens, IsCrossedOnceAndBack) {
    expectCurveOverTheRim({{0.5, 0.0, 1.0}, {0.6, 0.1, -1.0}, {-0.5, 0.3, 1.0}});
}

TEST_P(Lens, IsCrossedFromNearItsMiddle) {
    expectCurveOverTheRim({{0.1, 0.0, 1.0}, {0.1, 0.2, -1.0}});
}

TEST_P(Lens, IsCrossedAgainAndAgain) {
    expectCurveOverTheRim(
        {{0.7, 0.0, 1.0}, {0.7, 0.2, -1.0}, {0.6, 0.5, 1.0}, {0.3, 0.7, -1.0}, {0.0, 0.6, 1.0}}
    );
}

INSTANTIATE_TEST_SUITE_P(Thicknesses, Lens, testing::Values(0.05, 0.03, 0.025, 0.02));

TEST(LensProgress, OnlyRisesOverSeveralAttempts) {
    const TriangleMesh mesh = lens(0.025);
    const std::vector<Vec3> picks =
        picksOn(mesh, {{0.7, 0.0, 1.0}, {0.7, 0.2, -1.0}, {0.6, 0.5, 1.0}});
    double last = 0.0;
    const auto follow = [&](double fraction, const char*) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    };
    static_cast<void>(designerIn(ShellKind::Local, mesh).design(picks, {}, {}, {}, follow));
    EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace bspline_curve
