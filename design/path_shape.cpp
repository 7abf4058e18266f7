// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/path_shape.h"

namespace bspline_curve {
namespace {

struct ShapeConstants {
    /// Of the points that hold a spline, per squared length of the polygon of picks. More takes
    /// more knots for the same bending; with a hundredth curves bend more between knots.
    double stiffness = 1e6;
    /// Share of E_int of the path, with all its bending, that changes are measured against: less
    /// makes more knots.
    double measuredShare = 0.3;
};

constexpr ShapeConstants kShape;

// The second derivative by differences at a point of a path that has others on both sides; `share`:
// of the parameters that is nearest to it.
Vec3 secondAt(
    const InitialPath& path, std::size_t before, std::size_t i, std::size_t after, double& share
) {
    const auto gap = [&](std::size_t from, std::size_t to) {
        const double difference = path.points[to].parameter - path.points[from].parameter;
        return difference < 0.0 ? difference + 1.0 : difference;  // of a closed one
    };
    const Vec3& here = path.points[i].position;
    const double in = gap(before, i);
    const double out = gap(i, after);
    share = 0.5 * (in + out);
    return ((path.points[after].position - here) / out -
            (here - path.points[before].position) / in) /
           share;
}

}  // namespace

FairedShape fairedShapeOf(
    const PickPath& faired, const SolverOptions& options, double chordLength
) {
    const InitialPath& path = faired.path;
    const std::size_t last = path.points.size() - 1;
    const double scale = 1.0 / (chordLength * chordLength);
    FairedShape shape;
    shape.stiffness = kShape.stiffness * scale;
    double bending = 0.0;
    std::size_t nextPick = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const InitialPath::Point& here = path.points[i];
        FairedShape::Point point{here.parameter, 0.0, here.position, Vec3::Zero()};
        double share = 0.0;
        if (i > 0 && i < last) {
            point.second = secondAt(path, i - 1, i, i + 1, share);
        } else if (options.closed) {
            point.second = secondAt(path, last - 1, i == 0 ? last : i, 1, share);
        }
        bending += share * point.second.squaredNorm();
        const bool isPick = i == last || (nextPick < faired.picks.size() &&
                                          faired.picks[nextPick].parameter == here.parameter);
        if (isPick) {
            ++nextPick;
        } else {
            point.share = share;
        }
        shape.points.push_back(point);
    }
    if (!options.closed) {
        shape.points.front().second = shape.points[1].second;
        shape.points.back().second = shape.points[last - 1].second;
    }
    const double length = path.length();
    shape.energy = kShape.measuredShare * scale *
                   ((1.0 - options.tension) * bending + options.tension * length * length);
    return shape;
}

}  // namespace bspline_curve
