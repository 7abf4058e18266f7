// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_fixture.h"

#include <gtest/gtest.h>

#include <utility>

namespace bspline_curve::test_support {

Camera::Camera(const Workpiece& workpiece, const Vec3& from, bool isOrthographic)
    : diagonal_(workpiece.diagonal()), isOrthographic_(isOrthographic) {
    Vec3 low = workpiece.mesh().vertices.front();
    Vec3 high = low;
    for (const Vec3& vertex : workpiece.mesh().vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    centre_ = 0.5 * (low + high);
    eye_ = centre_ + 3.0 * diagonal_ * from.normalized();
    right_ = from.cross(Vec3::UnitY()).norm() > 0.1 ? from.cross(Vec3::UnitY()).normalized()
                                                    : Vec3(Vec3::UnitX());
}

Pointer Camera::over(const Vec3& point) const {
    Pointer pointer;
    pointer.isOrthographic = isOrthographic_;
    if (isOrthographic_) {
        pointer.direction = (centre_ - eye_).normalized();
        pointer.start = point - (point - eye_).dot(pointer.direction) * pointer.direction;
        pointer.pixel = 1e-3 * diagonal_;
    } else {
        pointer.direction = (point - eye_).normalized();
        pointer.start = eye_;
        pointer.pixel = 1e-3 / 3.0;
    }
    return pointer;
}

Pointer Camera::beside(const Vec3& point, double pixels) const {
    return over(point + 1e-3 * pixels * diagonal_ * right_);
}

Pointer Camera::off() const {
    return over(centre_ + 2.0 * diagonal_ * right_);
}

SessionFixture::SessionFixture(TriangleMesh mesh, const Vec3& from, SessionSettings settings)
    : workpiece(std::make_shared<const Workpiece>(std::move(mesh))),
      camera(*workpiece, from),
      session(workpiece, std::move(settings)) {}

void SessionFixture::click(const Pointer& pointer) {
    session.press(pointer);
    session.release(pointer);
}

void SessionFixture::drag(const Pointer& from, const Pointer& to) {
    session.press(from);
    session.move(to);
    session.release(to);
}

void SessionFixture::click(const std::vector<Vec3>& points) {
    for (const Vec3& point : points) {
        click(camera.over(point));
    }
}

Curve SessionFixture::drawn(const SketchCurve& curve) const {
    CurveInputs inputs;
    const std::vector<int> corners = curve.corners();
    const std::vector<PickTangent> tangents = curve.tangents();
    inputs.corners = corners;
    inputs.tangents = tangents;
    if (curve.options.guides) {
        inputs.field = curve.options.guides->values().field;
        inputs.avoid = curve.options.guides->values().avoid;
    }
    return workpiece->draw(curve.positions(), curve.options.solver, {}, inputs).curve;
}

void SessionFixture::expectAsDrawn() const {
    for (const std::shared_ptr<SketchCurve>& curve : session.sketch().curves) {
        if (curve->settled) {
            EXPECT_EQ(curve->settled->polyline.points, drawn(*curve).polyline.points);
        }
    }
}

}  // namespace bspline_curve::test_support
