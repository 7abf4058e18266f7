// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/fitted_path.h"

#include "design/surface_walk.h"
#include "spline/band_cholesky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace bspline_curve {
namespace {

struct SmoothingConstants {
    /// Nodes of the shortest wave that may be flattened, while the wavelength is looked for; and of
    /// the one that is, for the path.
    double nodesOfShortest = 4.0, nodesOfWave = 8.0;
    double leastNodes = 24.0;  // of the whole line
    /// Of an end, when that of all points is 1: it is off by less than a path's own roundings, and
    /// then put where it is to be.
    double heldWeight = 1e6;
    /// The spread is reached where it differs by no more than this factor, or after so many tries.
    double nearFactor = 1.01;
    int mostTries = 20;
};

constexpr SmoothingConstants kSmoothing;

class LineSmoother {
public:
    LineSmoother(const MeasuredLine& line, double shortest)
        : line_(line),
          length_(line.path.length()),
          count_(
              static_cast<int>(
                  std::max(kSmoothing.leastNodes, kSmoothing.nodesOfShortest * length_ / shortest)
              )
          ),
          step_(length_ / static_cast<double>(segments())) {
        for (const MeasuredLine::Point& point : line.points) {
            weight_ += point.weight;
        }
    }

    /// Smooth so that waves of that length are half flattened; returns the spread.
    double smooth(double wavelength) {
        BandCholesky<1> factor(size(), 2, line_.closed ? 2 : 0);
        factor.clear();
        const auto add = [&](int i, int j, double value) {
            const auto [low, high] = std::minmax(i, j);
            factor.add(high, low, &value, 1);
        };
        std::array<Eigen::VectorXd, 3> right;
        right.fill(Eigen::VectorXd::Zero(size()));
        for (const MeasuredLine::Point& point : line_.points) {
            const auto [i, j, share] = placeOf(point.parameter);
            const double weight = point.weight / weight_;
            add(i, i, weight * (1.0 - share) * (1.0 - share));
            add(i, j, weight * (1.0 - share) * share);
            add(j, j, weight * share * share);
            for (int axis = 0; axis < 3; ++axis) {
                right[static_cast<std::size_t>(axis)][i] +=
                    weight * (1.0 - share) * point.position[axis];
                right[static_cast<std::size_t>(axis)][j] += weight * share * point.position[axis];
            }
        }
        if (!line_.closed) {
            hold(0, line_.path.points.front().position, add, right);
            hold(size() - 1, line_.path.points.back().position, add, right);
        }
        const double wave = wavelength / (2.0 * std::numbers::pi);
        const double stiffness = wave * wave * wave * wave / (length_ * step_ * step_ * step_);
        for (int i = line_.closed ? 0 : 1; i < (line_.closed ? size() : size() - 1); ++i) {
            const std::array<int, 3> nodes = {at(i - 1), i, at(i + 1)};
            constexpr std::array<double, 3> kDifference = {1.0, -2.0, 1.0};
            for (std::size_t a = 0; a < 3; ++a) {
                for (std::size_t b = a; b < 3; ++b) {
                    add(nodes[a], nodes[b], stiffness * kDifference[a] * kDifference[b]);
                }
            }
        }
        if (!factor.factorise()) {
            return spread();  // waves too short for the nodes: it stays as it was
        }
        nodes_.resize(static_cast<std::size_t>(size()));
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::VectorXd solved =
                factor.solve(std::move(right[static_cast<std::size_t>(axis)]));
            for (int i = 0; i < size(); ++i) {
                nodes_[static_cast<std::size_t>(i)][axis] = solved[i];
            }
        }
        return spread();
    }

    /// A share of the line's length, and where it goes.
    [[nodiscard]] Vec3 positionAt(double parameter) const {
        const auto [i, j, share] = placeOf(parameter);
        return (1.0 - share) * node(i) + share * node(j);
    }

private:
    struct Place {
        int i, j;
        double share;
    };

    // A node stays, as nearly as numbers tell, at an end.
    template <class Add>
    static void hold(
        int i, const Vec3& end, const Add& add, std::array<Eigen::VectorXd, 3>& right
    ) {
        add(i, i, kSmoothing.heldWeight);
        for (int axis = 0; axis < 3; ++axis) {
            right[static_cast<std::size_t>(axis)][i] += kSmoothing.heldWeight * end[axis];
        }
    }

    [[nodiscard]] int size() const { return count_; }

    [[nodiscard]] int segments() const { return count_ - (line_.closed ? 0 : 1); }

    [[nodiscard]] int at(int i) const { return (i + count_) % count_; }

    [[nodiscard]] const Vec3& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

    [[nodiscard]] Place placeOf(double parameter) const {
        const double place = parameter * segments();
        const int i = std::min(static_cast<int>(place), segments() - 1);
        return {i, at(i + 1), place - i};
    }

    [[nodiscard]] double spread() const {
        double sum = 0.0;
        for (const MeasuredLine::Point& point : line_.points) {
            sum += point.weight * (positionAt(point.parameter) - point.position).squaredNorm();
        }
        return std::sqrt(sum / weight_);
    }

    const MeasuredLine& line_;
    double length_;
    int count_;
    double step_;
    double weight_ = 0.0;
    std::vector<Vec3> nodes_;
};

// The wavelength at which the spread is as wished; the spread grows with it.
FittedPath smoothTo(LineSmoother& smoother, const FitTarget& target) {
    double low = target.shortest;
    double high = target.longest;
    FittedPath fitted;
    double wavelength = std::clamp(target.wavelength, low, high);
    for (int i = 0; i < kSmoothing.mostTries; ++i) {
        fitted.wavelength = wavelength;
        fitted.spread = smoother.smooth(wavelength);
        const double ratio = target.spread / fitted.spread;
        if (ratio <= kSmoothing.nearFactor && ratio * kSmoothing.nearFactor >= 1.0) {
            break;
        }
        const bool isAtBound = wavelength == (ratio > 1.0 ? target.longest : target.shortest);
        (ratio > 1.0 ? low : high) = wavelength;
        if (low >= high || isAtBound) {
            break;
        }
        // About as the wavelength does, or by halves.
        const double next = wavelength * std::clamp(ratio, 0.25, 4.0);
        const bool isInside = next > low && next < high;
        const bool isAbove = high == target.longest && next >= high;
        const bool isBelow = low == target.shortest && next <= low;
        wavelength = isInside ? next : (isAbove ? high : (isBelow ? low : std::sqrt(low * high)));
    }
    return fitted;
}

void putAt(const InitialPath::Point& end, SurfaceNode& node) {
    node.foot = FootPoint::at(end.point);
    node.position = end.position;
}

}  // namespace

std::optional<FittedPath> fittedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const MeasuredLine& line,
    const FitTarget& target
) {
    const double length = line.path.length();
    LineSmoother smoother(line, target.shortest);
    FittedPath fitted = smoothTo(smoother, target);
    const FibreProjector finder(extended, patches);
    const int segments = std::max(
        static_cast<int>(kSmoothing.leastNodes),
        static_cast<int>(std::lround(kSmoothing.nodesOfWave * length / fitted.wavelength))
    );
    std::vector<SurfaceNode> nodes;
    for (int i = 0; i < segments + (line.closed ? 0 : 1); ++i) {
        const double parameter = static_cast<double>(i) / segments;
        SurfaceNode node;
        node.foot = FootPoint::at(line.path.points[line.path.indexAt(parameter)].point);
        finder.move(smoother.positionAt(parameter), node.foot, node.frame);
        node.foot.height = 0.0;
        node.position = extended.position({node.foot.face, node.foot.barycentric()});
        nodes.push_back(node);
    }
    if (!line.closed) {
        putAt(line.path.points.front(), nodes.front());
        putAt(line.path.points.back(), nodes.back());
    }
    double way = 0.0;
    std::vector<InitialPath::Point>& points = fitted.path.points;
    for (int i = 0; i <= segments; ++i) {
        const SurfaceNode& node = nodes[static_cast<std::size_t>(i) % nodes.size()];
        if (node.foot.face >= extended.surfaceFaceCount) {
            return std::nullopt;
        }
        if (i > 0) {
            const SurfaceNode& last = nodes[static_cast<std::size_t>(i) - 1];
            if (!areJoined(extended, finder, last, node)) {
                return std::nullopt;
            }
            way += (node.position - last.position).norm();
        }
        points.push_back({way, node.foot.surfacePoint(), node.position});
    }
    if (!(way > 0.0)) {
        return std::nullopt;
    }
    for (InitialPath::Point& point : points) {
        point.parameter /= way;
    }
    points.back().parameter = 1.0;
    return fitted;
}

}  // namespace bspline_curve
