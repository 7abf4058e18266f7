// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/screen_line.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
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
// Others are left out where a straight piece differs by no more: logical pixels to the side and in
// depth, and slopes; and no more than so many at once.
constexpr double kBendUnseen = 0.1, kDepthUnseen = 0.75, kSlopeUnseen = 0.2;
constexpr std::size_t kLongestRun = 32;

ScreenNode between(const ScreenNode& a, const ScreenNode& b, double s) {
    ScreenNode node;
    node.at = (1.0 - s) * a.at + s * b.at;
    node.depth = (1.0 - s) * a.depth + s * b.depth;
    node.slope = (1.0 - s) * a.slope + s * b.slope;
    node.depthPerPixel = (1.0 - s) * a.depthPerPixel + s * b.depthPerPixel;
    return node;
}

// Whether a node between two others looks like what a straight piece has there.
bool isLikeBetween(const ScreenNode& node, const ScreenNode& a, const ScreenNode& b, double ratio) {
    const Eigen::Vector2d way = b.at - a.at;
    const double squared = way.squaredNorm();
    const double s =
        squared > 0.0 ? std::clamp((node.at - a.at).dot(way) / squared, 0.0, 1.0) : 0.0;
    const ScreenNode straight = between(a, b, s);
    const double depthUnit = std::abs(node.depthPerPixel);
    return (node.at - straight.at).norm() <= kBendUnseen * ratio &&
           std::abs(node.depth - straight.depth) <= kDepthUnseen * ratio * depthUnit &&
           (node.slope - straight.slope).norm() <= kSlopeUnseen * depthUnit;
}

// Marks which nodes of [first, last] are needed, besides these two.
void markNeeded(
    const std::vector<ScreenNode>& nodes,
    std::size_t first,
    std::size_t last,
    double ratio,
    std::vector<char>& isNeeded
) {
    const bool isShort = last - first <= kLongestRun;
    bool isStraight = isShort;
    for (std::size_t i = first + 1; isStraight && i < last; ++i) {
        isStraight = isLikeBetween(nodes[i], nodes[first], nodes[last], ratio);
    }
    if (!isStraight && last - first > 1) {
        const std::size_t middle = first + (last - first) / 2;
        isNeeded[middle] = 1;
        markNeeded(nodes, first, middle, ratio, isNeeded);
        markNeeded(nodes, middle, last, ratio, isNeeded);
    }
}

std::vector<ScreenNode> needed(const std::vector<ScreenNode>& nodes, double ratio) {
    std::vector<char> isNeeded(nodes.size(), 0);
    isNeeded.front() = isNeeded.back() = 1;
    markNeeded(nodes, 0, nodes.size() - 1, ratio, isNeeded);
    std::vector<ScreenNode> kept;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (isNeeded[i] != 0) {
            kept.push_back(nodes[i]);
        }
    }
    return kept;
}

}  // namespace

ScreenProjection::ScreenProjection(const View& view, double lift)
    : modelView_(view.modelView()),
      projection_(view.projection()),
      toClip_(projection_ * modelView_),
      normals_(view.modelView().topLeftCorner<3, 3>().inverse().transpose()),
      size_(view.size()),
      ratio_(view.ratio()),
      lift_(lift) {}

// Positive before the near plane.
double ScreenProjection::nearness(const Eigen::Vector4d& clip) const {
    return clip[2] + (1.0 - kNearest) * clip[3];
}

Eigen::Vector2d ScreenProjection::pixelOf(const Eigen::Vector4d& clip) const {
    return (clip.head<2>() / clip[3] + Eigen::Vector2d::Ones()).cwiseProduct(size_) / 2.0;
}

ScreenNode ScreenProjection::seen(const Eigen::Vector4d& eyePoint, const Vec3& normal) const {
    const Eigen::Vector4d clip = projection_ * eyePoint;
    ScreenNode node;
    node.at = pixelOf(clip);
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
    node.depthPerPixel = pixel * nearer;
    node.slope = slope * node.depthPerPixel;
    node.depth = std::max(clip[2] / clip[3] + ratio_ * pixels * node.depthPerPixel, kNearest - 1.0);
    return node;
}

std::optional<ScreenNode> ScreenProjection::node(const Vec3& point, const Vec3& normal) const {
    if (nearness(toClip_ * point.homogeneous()) <= 0.0) {
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
        if (isEnd || piece.nodes.empty() ||
            (pixelOf(toClip_ * point.homogeneous()) - piece.nodes.back().at).norm() >=
                kLeastStep * ratio_) {
            piece.nodes.push_back(seen(modelView_ * point.homogeneous(), normalOf(index)));
        }
    };
    const auto end = [&] {
        if (piece.nodes.size() > 1) {
            piece.nodes = needed(piece.nodes, ratio_);
            pieces.push_back(std::move(piece));
        }
        piece = {};
    };
    const std::size_t count = points.size();
    double before = 0.0;
    for (std::size_t i = 0; i < count + (closed ? 1U : 0U); ++i) {
        const std::size_t index = i % count;
        const double here = nearness(toClip_ * points[index].homogeneous());
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
    const bool isWhole = closed && pieces.empty();
    end();
    if (isWhole && !pieces.empty() && pieces.front().nodes.size() > 3) {
        pieces.front().nodes.pop_back();  // the first again
        pieces.front().closed = true;
    }
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
