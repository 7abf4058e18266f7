// SPDX-License-Identifier: GPL-3.0-or-later
// Curves near, along and on the boundary of an open surface.
#include "curve_checks.h"
#include "either_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

class Boundary : public EitherShell {
protected:
    CurveDesigner designer_ = designerOn(plate(12, 12));
};

TEST_P(Boundary, PicksNearItAreFine) {
    static_cast<void>(goodCurve(designer_, {{0.1, 0.01, 0}, {0.4, 0.02, 0}, {0.9, 0.005, 0}}));
}

TEST_P(Boundary, CurvesMayStartAndEndOnIt) {
    static_cast<void>(goodCurve(designer_, {{0, 0.3, 0}, {0.4, 0.6, 0}, {1, 0.41, 0}}));
    static_cast<void>(goodCurve(designer_, {{0, 0, 0}, {0.4, 0.6, 0}, {1, 1, 0}}));
    static_cast<void>(goodCurve(designer_, {{0, 0.5, 0}, {1, 0.5, 0}}));
}

TEST_P(Boundary, CurvesMayTouchItInTheMiddle) {
    static_cast<void>(goodCurve(designer_, {{0.2, 0.5, 0}, {0.51, 0, 0}, {0.8, 0.5, 0}}));
}

TEST_P(Boundary, CurvesMayRunAlongIt) {
    static_cast<void>(goodCurve(designer_, {{0.1, 0, 0}, {0.47, 0, 0}, {0.93, 0, 0}}));
}

TEST_P(Boundary, AllPicksMayLieOnIt) {
    static_cast<void>(goodCurve(designer_, {{0.3, 0, 0}, {1, 0.4, 0}, {0.6, 1, 0}, {0, 0.6, 0}}));
    static_cast<void>(
        goodCurve(designer_, {{0.3, 0, 0}, {1, 0.4, 0}, {0.6, 1, 0}, {0, 0.6, 0}}, closedOptions())
    );
}

// The spline through these picks would swing out of the plate: it must come back.
TEST_P(Boundary, CurvesThatWouldSwingOutStayOnTheSurface) {
    static_cast<void>(goodCurve(
        designer_, {{0.05, 0.6, 0}, {0.2, 0.02, 0}, {0.5, 0.02, 0}, {0.8, 0.02, 0}, {0.95, 0.6, 0}}
    ));
}

TEST_P(Boundary, CurvesFollowTheRimOfACylinder) {
    const TriangleMesh mesh = openCylinder(24, 8);
    const CurveDesigner cylinder = designerOn(mesh);
    std::vector<Vec3> picks;
    for (const std::size_t i : {0U, 6U, 12U, 18U}) {
        picks.push_back(mesh.vertices[i]);
    }
    const Curve curve = goodCurve(cylinder, picks, closedOptions());
    EXPECT_NEAR(turnsAboutZ(curve.polyline), 1.0, 1e-9);
}

// A plate with a slot from below: the way between the two sides leads round its end.
TEST_P(Boundary, CurvesGoRoundNotches) {
    TriangleMesh mesh = plate(12, 12);
    std::erase_if(mesh.faces, [&](const Triangle& face) {
        Vec3 centre = Vec3::Zero();
        for (const int v : face) {
            centre += mesh.vertices[v] / 3.0;
        }
        return centre.y() < 0.6 && std::abs(centre.x() - 0.5) < 0.09;
    });
    const CurveDesigner notched = designerOn(mesh);
    static_cast<void>(goodCurve(notched, {{0.2, 0.1, 0}, {0.8, 0.1, 0}}));
    static_cast<void>(goodCurve(notched, {{0.2, 0.1, 0}, {0.52, 0.8, 0}, {0.8, 0.1, 0}}));
}

INSTANTIATE_TEST_SUITE_P(Shells, Boundary, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
