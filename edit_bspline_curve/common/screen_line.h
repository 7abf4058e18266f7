// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/view.h"

#include <functional>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A point of a surface on the screen.
struct ScreenNode {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< device pixels from the lower left corner
    double depth = 0.0;                            ///< as OpenGL has it: -1 is near, 1 is far
    /// How the depth of the surface changes per device pixel to the right and upwards.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    double depthPerPixel = 0.0;  ///< of a device pixel towards the viewer; negative

    [[nodiscard]] double depthAt(const Eigen::Vector2d& p) const {
        return depth + slope.dot(p - at);
    }
};

struct ScreenLine {
    std::vector<ScreenNode> nodes;
    bool closed = false;
};

/// Brings points and lines of a surface to the screen. They are brought a little nearer to the
/// viewer than the surface: by `lift` logical pixels on faces that are seen from outside, more on
/// steep ones, so that bumps do not cover what is drawn with some width; by a pixel on others, so
/// that nothing shines through thin plates. What is drawn with the slope of its nodes lies in the
/// plane of its face, however steep that is.
class ScreenProjection {
public:
    ScreenProjection(const View& view, double lift);

    /// Nothing where the point does not lie before the eye. `normal`: of the face, any length.
    [[nodiscard]] std::optional<ScreenNode> node(const Vec3& point, const Vec3& normal) const;

    /// A polyline, without points whose absence nobody sees; cut where it passes behind the eye.
    /// `normalOf`: by index of the point.
    [[nodiscard]] std::vector<ScreenLine> lines(
        const std::vector<Vec3>& points,
        const std::function<Vec3(std::size_t)>& normalOf,
        bool closed
    ) const;

private:
    [[nodiscard]] ScreenNode seen(const Eigen::Vector4d& eyePoint, const Vec3& normal) const;
    [[nodiscard]] double nearness(const Eigen::Vector4d& clip) const;
    [[nodiscard]] Eigen::Vector2d pixelOf(const Eigen::Vector4d& clip) const;

    Eigen::Matrix4d modelView_, projection_;
    Eigen::Matrix4d toClip_;   ///< their product
    Eigen::Matrix3d normals_;  ///< from the world's to the eye's
    Eigen::Vector2d size_;
    double ratio_, lift_;
};

/// Pieces of a line, `on` device pixels long, with gaps of `off` between them.
[[nodiscard]] std::vector<ScreenLine> dashes(const ScreenLine& line, double on, double off);

}  // namespace bspline_curve
