// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/space_paths.h"

#include <Eigen/Geometry>

#include <utility>

namespace bspline_curve {

namespace {

/// Ends that are this near, in the size of their path, meet.
constexpr double kEndsMeetRelative = 1e-9;
/// Chords are this near to arcs, in the size of their path.
constexpr double kChordRelative = 1e-5;

double sizeOf(const SpacePath& path) {
    Eigen::AlignedBox3d box;
    for (const SpaceArc& arc : path.arcs) {
        for (const Vec3& point : arc.points) {
            box.extend(point);
        }
    }
    return box.diagonal().norm();
}

}  // namespace

void closeWhereEndsMeet(SpacePath& path) {
    Vec3& end = path.arcs.back().points.back();
    const Vec3& start = path.arcs.front().points.front();
    if ((end - start).norm() <= kEndsMeetRelative * sizeOf(path)) {
        end = start;
        path.closed = true;
    }
}

void PathLines::add(const SpacePath& path) {
    const double size = path.arcs.empty() ? 0.0 : sizeOf(path);
    if (!(size > 0.0)) {
        return;
    }
    const std::vector<Vec3> points = flattened(path.arcs, kChordRelative * size);
    for (std::size_t i = 1; i < points.size(); ++i) {
        addEdge(points[i - 1], points[i]);
    }
}

PolylineGraph PathLines::take() {
    indices_.clear();
    return std::exchange(graph_, {});
}

void PathLines::addEdge(const Vec3& from, const Vec3& to) {
    const int a = indexOf(from);
    const int b = indexOf(to);
    if (a != b) {
        graph_.edges.push_back({a, b});
    }
}

int PathLines::indexOf(const Vec3& point) {
    const auto [entry, isNew] = indices_.try_emplace(
        {point.x(), point.y(), point.z()}, static_cast<int>(graph_.points.size())
    );
    if (isNew) {
        graph_.points.push_back(point);
    }
    return entry->second;
}

}  // namespace bspline_curve
