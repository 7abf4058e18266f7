// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/screen_line.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

// Clip coordinates: what is nearer is cut, just behind OpenGL's own near plane.
constexpr double kNearest = 1e-5;
// Steeper faces (83 degrees) are taken as if they were no steeper.
constexpr double kSteepest = 8.0;
// On steep faces normals that differ a little differ much in slope.
constexpr double kLiftPerSlope = 0.25;
// In pixels: see ScreenProjection.
constexpr double kLiftFromBehind = 1.0;
// Points of a line that are nearer to the one before are left out; logical pixels.
constexpr double kLeastStep = 1.5;

ScreenNode between(const ScreenNode& a, const ScreenNode& b, double s) {
    ScreenNode node;
    node.at = (1.0 - s) * a.at + s * b.at;
    node.depth = (1.0 - s) * a.depth + s * b.depth;
    node.slope = (1.0 - s) * a.slope + s * b.slope;
    return node;
}

}  // namespace

ScreenProjection::ScreenProjection(const View& view, double lift)
    : modelView_(view.modelView()),
      projection_(view.projection()),
      normals_(view.modelView().topLeftCorner<3, 3>().inverse().transpose()),
      size_(view.size()),
      ratio_(view.ratio()),
      lift_(lift) {}

// Positive before the near plane.
double ScreenProjection::nearness(const Vec3& point) const {
    const Eigen::Vector4d clip = projection_ * (modelView_ * point.homogeneous());
    return clip[2] + (1.0 - kNearest) * clip[3];
}

ScreenNode ScreenProjection::seen(const Eigen::Vector4d& eyePoint, const Vec3& normal) const {
    const Eigen::Vector4d clip = projection_ * eyePoint;
    ScreenNode node;
    node.at = (clip.head<2>() / clip[3] + Eigen::Vector2d::Ones()).cwiseProduct(size_) / 2.0;
    // The eye's unit per device pixel, and the depth per eye's unit towards the viewer, there.
    const double pixel = 2.0 * clip[3] / (projection_(1, 1) * size_[1]);
    const double nearer =
        (projection_(2, 2) * clip[3] - clip[2] * projection_(3, 2)) / (clip[3] * clip[3]);
    const bool isOrthographic = projection_(3, 2) == 0.0;
    const Vec3 ray =
        isOrthographic ? Vec3(-Vec3::UnitZ()) : Vec3(eyePoint.head<3>() / -eyePoint[2]);
    const Vec3 n = normals_ * normal;
    const double facing = n.dot(ray);
    const bool isFromOutside = facing < 0.0;
    Eigen::Vector2d slope = n.head<2>() / facing;
    if (!(slope.norm() <= kSteepest)) {
        slope = n.head<2>().normalized() * (isFromOutside ? -kSteepest : kSteepest);
    }
    const double pixels =
        isFromOutside ? lift_ * (1.0 + kLiftPerSlope * slope.norm()) : kLiftFromBehind;
    const double lift = ratio_ * pixels;
    node.slope = slope * pixel * nearer;
    node.depth = std::max(clip[2] / clip[3] + lift * pixel * nearer, kNearest - 1.0);
    return node;
}

std::optional<ScreenNode> ScreenProjection::node(const Vec3& point, const Vec3& normal) const {
    if (nearness(point) <= 0.0) {
        return std::nullopt;
    }
    return seen(modelView_ * point.homogeneous(), normal);
}

std::vector<ScreenLine> ScreenProjection::lines(
    const std::vector<Vec3>& points, const std::function<Vec3(std::size_t)>& normalOf, bool closed
) const {
    std::vector<ScreenLine> pieces;
    ScreenLine piece;
    const auto add = [&](const Vec3& point, std::size_t index, bool isEnd) {
        const Eigen::Vector4d eyePoint = modelView_ * point.homogeneous();
        const Eigen::Vector4d clip = projection_ * eyePoint;
        const Eigen::Vector2d at =
            (clip.head<2>() / clip[3] + Eigen::Vector2d::Ones()).cwiseProduct(size_) / 2.0;
        if (isEnd || piece.nodes.empty() ||
            (at - piece.nodes.back().at).norm() >= kLeastStep * ratio_) {
            piece.nodes.push_back(seen(eyePoint, normalOf(index)));
        }
    };
    const auto end = [&] {
        if (piece.nodes.size() > 1) {
            pieces.push_back(std::move(piece));
        }
        piece = {};
    };
    const std::size_t count = points.size();
    double before = 0.0;
    for (std::size_t i = 0; i < count + (closed ? 1U : 0U); ++i) {
        const std::size_t index = i % count;
        const double here = nearness(points[index]);
        if (i > 0 && (here > 0.0) != (before > 0.0)) {
            const Vec3& last = points[i - 1];
            const Vec3 cut = last + before / (before - here) * (points[index] - last);
            add(cut, here > 0.0 ? index : i - 1, true);
        }
        if (here > 0.0) {
            add(points[index], index, i + 1 == count + (closed ? 1U : 0U));
        } else {
            end();
        }
        before = here;
    }
    const bool isWhole = closed && pieces.empty() && piece.nodes.size() > 3;
    if (isWhole) {
        piece.nodes.pop_back();  // the first again
        piece.closed = true;
    }
    end();
    return pieces;
}

std::vector<ScreenLine> dashes(const ScreenLine& line, double on, double off) {
    std::vector<ScreenLine> pieces;
    double left = on;  // until the dash or the gap ends
    bool isOn = true;
    const std::size_t count = line.nodes.size();
    if (count > 0) {
        pieces.push_back({{line.nodes.front()}, false});
    }
    for (std::size_t i = 0; i + (line.closed ? 0U : 1U) < count; ++i) {
        const ScreenNode& a = line.nodes[i];
        const ScreenNode& b = line.nodes[(i + 1) % count];
        const double length = (b.at - a.at).norm();
        double done = 0.0;
        while (length - done > left) {
            done += left;
            const ScreenNode node = between(a, b, done / length);
            if (isOn) {
                pieces.back().nodes.push_back(node);
            } else {
                pieces.push_back({{node}, false});
            }
            isOn = !isOn;
            left = isOn ? on : off;
        }
        left -= length - done;
        if (isOn) {
            pieces.back().nodes.push_back(b);
        }
    }
    return pieces;
}

}  // namespace bspline_curve
