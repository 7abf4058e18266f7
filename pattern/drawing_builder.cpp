// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_builder.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

namespace {

bool hasLength(const DrawingArc& arc) {
    return !arc.startDirection().isZero();
}

/// Whether the last point of a path is its first, but for rounding.
bool endsAtStart(const DrawingPath& path) {
    Eigen::AlignedBox2d box;
    for (const DrawingArc& arc : path.arcs) {
        for (const auto& point : arc.points) {
            box.extend(point);
        }
    }
    return (path.arcs.back().points.back() - path.arcs.front().points.front()).norm() <=
           DrawingBuilder::kClosedRelative * box.diagonal().norm();
}

}  // namespace

void DrawingBuilder::moveTo(const Vec2& point) {
    finish();
    pen_ = start_ = point;
}

void DrawingBuilder::lineTo(const Vec2& point) {
    curveTo({point});
}

void DrawingBuilder::curveTo(const std::vector<Vec2>& points, std::vector<double> weights) {
    DrawingArc arc{.points = {pen_}, .weights = std::move(weights)};
    arc.points.insert(arc.points.end(), points.begin(), points.end());
    pen_ = points.back();
    if (!hasLength(arc)) {
        return;
    }
    if (!path_) {
        path_.emplace();
        start_ = arc.points.front();
    }
    path_->arcs.push_back(std::move(arc));
}

void DrawingBuilder::follow(const std::vector<DrawingArc>& arcs) {
    for (const DrawingArc& arc : arcs) {
        curveTo({arc.points.begin() + 1, arc.points.end()}, arc.weights);
    }
}

void DrawingBuilder::close() {
    if (path_ && !endsAtStart(*path_)) {
        lineTo(start_);
    }
    if (path_) {
        path_->arcs.back().points.back() = start_;
        path_->closed = true;
    }
    finish();
    pen_ = start_;
}

void DrawingBuilder::finish() {
    if (path_) {
        if (!path_->closed && path_->arcs.size() > 1 && endsAtStart(*path_)) {
            path_->arcs.back().points.back() = path_->arcs.front().points.front();
            path_->closed = true;
        }
        path_->number = static_cast<int>(drawing_.paths.size());
        drawing_.paths.push_back(std::move(*path_));
    }
    path_.reset();
}

Drawing DrawingBuilder::take() {
    finish();
    return std::exchange(drawing_, {});
}

}  // namespace bspline_curve
