// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/view.h"

#include <Eigen/LU>

#include <array>
#include <stdexcept>

namespace bspline_curve {

QGLWidget& currentView() {
    const QGLContext* const context = QGLContext::currentContext();
    auto* const view = context == nullptr ? nullptr : dynamic_cast<QGLWidget*>(context->device());
    if (view == nullptr) {
        throw std::runtime_error("there is no view to draw in");
    }
    return *view;
}

View::View(const QGLWidget& widget)
    : View(widget.devicePixelRatioF(), widget.height() * widget.devicePixelRatioF()) {}

View::View(double ratio, double height) : ratio_(ratio), height_(height) {
    glGetDoublev(GL_MODELVIEW_MATRIX, modelView_.data());
    glGetDoublev(GL_PROJECTION_MATRIX, projection_.data());
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    viewport_ << viewport[0], viewport[1], viewport[2], viewport[3];
    toWorld_ = (projection_ * modelView_).inverse();
}

Pointer View::pointerAt(const QPointF& position) const {
    const double x = 2.0 * (position.x() * ratio_ - viewport_[0]) / viewport_[2] - 1.0;
    const double y = 2.0 * (height_ - position.y() * ratio_ - viewport_[1]) / viewport_[3] - 1.0;
    const auto at = [&](double depth) -> Vec3 {
        const Eigen::Vector4d p = toWorld_ * Eigen::Vector4d(x, y, depth, 1.0);
        return p.head<3>() / p[3];
    };
    Pointer pointer;
    pointer.start = at(-1.0);
    pointer.direction = (at(1.0) - pointer.start).normalized();
    pointer.isOrthographic = projection_(3, 3) == 1.0;
    const double scale = modelView_.col(0).head<3>().norm();
    const double pixel = 2.0 * ratio_ / (projection_(1, 1) * viewport_[3]);
    if (pointer.isOrthographic) {
        pointer.pixel = pixel / scale;
    } else {
        pointer.pixel = pixel;
        const Eigen::Vector4d eye = modelView_.inverse() * Eigen::Vector4d(0.0, 0.0, 0.0, 1.0);
        pointer.start = eye.head<3>() / eye[3];
    }
    return pointer;
}

QPointF View::positionOf(const Vec3& point) const {
    const Eigen::Vector4d p = projection_ * modelView_ * point.homogeneous();
    const double x = viewport_[0] + (p[0] / p[3] + 1.0) / 2.0 * viewport_[2];
    const double y = viewport_[1] + (p[1] / p[3] + 1.0) / 2.0 * viewport_[3];
    return {x / ratio_, (height_ - y) / ratio_};
}

}  // namespace bspline_curve
