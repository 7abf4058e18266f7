// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace bspline_curve::test_support {

/// A camera that sees a mesh from along a direction, from three diagonals away: pixels are a
/// thousandth of the diagonal on its near side, about.
class Camera {
public:
    Camera(const Workpiece& workpiece, const Vec3& from, bool isOrthographic = false);

    /// Over a point of space.
    [[nodiscard]] Pointer over(const Vec3& point) const;
    /// Some pixels beside that.
    [[nodiscard]] Pointer beside(const Vec3& point, double pixels) const;
    /// Beside the mesh.
    [[nodiscard]] Pointer off() const;

private:
    Vec3 centre_, eye_, right_;
    double diagonal_;
    bool isOrthographic_;
};

/// A session on a mesh and a camera before it.
struct SessionFixture {
    SessionFixture(TriangleMesh mesh, const Vec3& from, SessionSettings settings = {});

    void click(const Pointer& pointer);
    void drag(const Pointer& from, const Pointer& to);
    /// Clicks where the surface is seen over some points.
    void click(const std::vector<Vec3>& points);
    /// The curve that is drawn for the picks of a curve, with nothing to start from.
    [[nodiscard]] Curve drawn(const SketchCurve& curve) const;
    void expectAsDrawn() const;  ///< every settled curve, to the last bit

    std::shared_ptr<const Workpiece> workpiece;
    Camera camera;
    DrawingSession session;
};

}  // namespace bspline_curve::test_support
