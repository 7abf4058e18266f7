// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// clang-format off
#include <GL/glew.h>  // before gl.h, which Qt includes
// clang-format on

#include "bspline_curve/drawing_session.h"

#include <Eigen/Geometry>

#include <QGLWidget>
#include <QPointF>

namespace bspline_curve {

/// The view whose context is current, which MeshLab makes it before it calls a tool. Throws
/// std::runtime_error where there is none.
[[nodiscard]] QGLWidget& currentView();

/// How a view of MeshLab shows the world: the matrices of OpenGL, as they are while it draws.
class View {
public:
    /// From the current context, within the host's drawing.
    explicit View(const QGLWidget& widget);
    /// Likewise, of what is no widget. `ratio`: see below; `height`: in device pixels.
    View(double ratio, double height);

    /// The ray through a position in the widget, in logical pixels from its top left corner.
    [[nodiscard]] Pointer pointerAt(const QPointF& position) const;
    /// Where a point of the world is in the widget, likewise.
    [[nodiscard]] QPointF positionOf(const Vec3& point) const;

    /// Device pixels per logical pixel.
    [[nodiscard]] double ratio() const { return ratio_; }

    [[nodiscard]] const Eigen::Matrix4d& modelView() const { return modelView_; }

    [[nodiscard]] const Eigen::Matrix4d& projection() const { return projection_; }

    /// Width and height in device pixels.
    [[nodiscard]] Eigen::Vector2d size() const { return viewport_.tail<2>(); }

private:
    Eigen::Matrix4d modelView_, projection_;
    Eigen::Matrix4d toWorld_;   ///< from what OpenGL calls clip coordinates
    Eigen::Vector4d viewport_;  ///< device pixels: x, y, width, height
    double ratio_;
    double height_;  ///< of the widget, device pixels
};

}  // namespace bspline_curve
