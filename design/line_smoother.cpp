// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/line_smoother.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace bspline_curve {
namespace {

struct SmoothingConstants {
    /// Nodes of the shortest wave that may be flattened.
    double nodesOfShortest = 4.0;
    double leastNodes = 24.0;  // of the whole line
    /// Of an end, when that of all points is 1: it is off by less than a path's own roundings, and
    /// then put where it is to be.
    double heldWeight = 1e6;
    /// In wavelengths: corners are at least so far apart, and from ends.
    double leastSection = 0.5;
    /// In wavelengths: farther away a node's term is not felt. It decays by half within a tenth.
    double reach = 1.5;
    /// A corner turns by so many times the standard deviation of what noise alone would turn it by.
    double leastErrors = 4.0;
};

constexpr SmoothingConstants kSmoothing;

constexpr std::array<double, 3> kSecondDifference = {1.0, -2.0, 1.0};

}  // namespace

LineSmoother::LineSmoother(
    const ExtendedSurface& extended,
    const MeasuredLine& line,
    double shortest,
    const Stiffness& stiffness
)
    : line_(line),
      stiffness_(stiffness),
      length_(line.path.length()),
      count_(
          static_cast<int>(
              std::max(kSmoothing.leastNodes, kSmoothing.nodesOfShortest * length_ / shortest)
          )
      ),
      step_(length_ / segments()),
      factor_(count_, 2, line.closed ? 2 : 0),
      isCorner_(static_cast<std::size_t>(count_), 0) {
    for (const MeasuredLine::Point& point : line.points) {
        weight_ += point.weight;
    }
    for (int i = 0; i < size(); ++i) {
        const double parameter = static_cast<double>(i) / segments();
        const SurfacePoint& point = line.path.points[line.path.indexAt(parameter)].point;
        normals_.push_back(extended.normalAt(point.face, point.barycentric).normalized());
    }
}

double LineSmoother::smooth(double wavelength) {
    wavelength_ = wavelength;
    factor_.clear();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * size());
    addPoints(right);
    addDifferences();
    if (!line_.closed) {
        hold(0, line_.path.points.front().position, right);
        hold(size() - 1, line_.path.points.back().position, right);
    }
    if (!factor_.factorise()) {
        return spread_;  // waves too short for the nodes: it stays as it was
    }
    const Eigen::VectorXd solved = factor_.solve(std::move(right));
    nodes_.resize(static_cast<std::size_t>(size()));
    for (int i = 0; i < size(); ++i) {
        nodes_[static_cast<std::size_t>(i)] = solved.segment<3>(3 * i);
    }
    spread_ = spreadNow();
    return spread_;
}

void LineSmoother::add(int i, int j, const Eigen::Matrix3d& values) {
    const auto [low, high] = std::minmax(i, j);
    factor_.add(high, low, values.data(), 3);
}

void LineSmoother::addPoints(Eigen::VectorXd& right) {
    for (const MeasuredLine::Point& point : line_.points) {
        const auto [i, j, share] = placeOf(point.parameter);
        const Eigen::Matrix3d weight = point.weight / weight_ * Eigen::Matrix3d::Identity();
        add(i, i, (1.0 - share) * (1.0 - share) * weight);
        add(i, j, (1.0 - share) * share * weight);
        add(j, j, share * share * weight);
        right.segment<3>(3 * i) += (1.0 - share) * weight * point.position;
        right.segment<3>(3 * j) += share * weight * point.position;
    }
}

void LineSmoother::addDifferences() {
    const double wave = wavelength_ / (2.0 * std::numbers::pi);
    const Eigen::Matrix3d pull =
        stiffness_.tension * wave * wave / (length_ * step_) * Eigen::Matrix3d::Identity();
    for (int i = 0; i < segments(); ++i) {
        add(i, i, pull);
        add(i, at(i + 1), -pull);
        add(at(i + 1), at(i + 1), pull);
    }
    for (int i = line_.closed ? 0 : 1; i < (line_.closed ? size() : size() - 1); ++i) {
        if (isCorner_[static_cast<std::size_t>(i)] != 0) {
            continue;
        }
        const Eigen::Matrix3d stiffness = stiffnessAt(i);
        const std::array<int, 3> nodes = {at(i - 1), i, at(i + 1)};
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = a; b < 3; ++b) {
                add(nodes[a], nodes[b], kSecondDifference[a] * kSecondDifference[b] * stiffness);
            }
        }
    }
}

// Of second differences at a node.
Eigen::Matrix3d LineSmoother::stiffnessAt(int i) const {
    const double wave = wavelength_ / (2.0 * std::numbers::pi);
    const double stiffness =
        (1.0 - stiffness_.tension) * wave * wave * wave * wave / (length_ * step_ * step_ * step_);
    const Vec3& normal = normals_[static_cast<std::size_t>(i)];
    return stiffness * (Eigen::Matrix3d::Identity() -
                        (1.0 - stiffness_.normalShare) * normal * normal.transpose());
}

// A node stays, as nearly as numbers tell, at an end.
void LineSmoother::hold(int i, const Vec3& end, Eigen::VectorXd& right) {
    add(i, i, kSmoothing.heldWeight * Eigen::Matrix3d::Identity());
    right.segment<3>(3 * i) += kSmoothing.heldWeight * end;
}

Vec3 LineSmoother::positionAt(double parameter) const {
    const auto [i, j, share] = placeOf(parameter);
    return (1.0 - share) * node(i) + share * node(j);
}

LineSmoother::Place LineSmoother::placeOf(double parameter) const {
    const double place = parameter * segments();
    const int i = std::min(static_cast<int>(place), segments() - 1);
    return {i, at(i + 1), place - i};
}

double LineSmoother::spreadNow() const {
    double sum = 0.0;
    for (const MeasuredLine::Point& point : line_.points) {
        sum += point.weight * (positionAt(point.parameter) - point.position).squaredNorm();
    }
    return std::sqrt(sum / weight_);
}

// Seen along the normal.
double LineSmoother::angleBetween(int i, const Vec3& before, const Vec3& after) const {
    const Vec3& normal = normals_[static_cast<std::size_t>(i)];
    const Vec3 from = before - normal.dot(before) * normal;
    const Vec3 to = after - normal.dot(after) * normal;
    return std::atan2(from.cross(to).norm(), from.dot(to));
}

double LineSmoother::angleAt(int i) const {
    return angleBetween(i, node(i) - node(i - 1), node(i + 1) - node(i));
}

// Second differences along the surface; 0 at ends and corners.
std::vector<double> LineSmoother::bends() const {
    std::vector<double> bends(static_cast<std::size_t>(size()), 0.0);
    for (int i = 0; i < size(); ++i) {
        if (isInner(i, 1)) {
            const Vec3 bend = node(i - 1) - 2.0 * node(i) + node(i + 1);
            const Vec3& normal = normals_[static_cast<std::size_t>(i)];
            bends[static_cast<std::size_t>(i)] = (bend - normal.dot(bend) * normal).norm();
        }
    }
    return bends;
}

// Whether ends and corners are at least so many nodes away.
bool LineSmoother::isInner(int i, int away) const {
    if (!line_.closed && (i < away || i + away >= size())) {
        return false;
    }
    for (int k = i - away + 1; k < i + away; ++k) {
        if (isCorner_[static_cast<std::size_t>(at(k))] != 0) {
            return false;
        }
    }
    return true;
}

// By a change of the matrix of rank three.
LineSmoother::Turn LineSmoother::turnWithout(int i) const {
    const int reach = static_cast<int>(std::ceil(kSmoothing.reach * wavelength_ / step_));
    const int border = line_.closed ? 2 : 0;
    const bool isAcross = line_.closed && (i - reach < 0 || i + reach >= size() - border);
    const int first = isAcross ? 0 : std::max(0, i - reach);
    const int last = isAcross ? size() - 1 : std::min(size() - 1, i + reach);
    std::array<Eigen::VectorXd, 3> answers;  // of each axis of the second difference
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::VectorXd& answer = answers[static_cast<std::size_t>(axis)];
        answer = Eigen::VectorXd::Zero(3 * size());
        for (int k = 0; k < 3; ++k) {
            answer[3 * at(i - 1 + k) + axis] = kSecondDifference[static_cast<std::size_t>(k)];
        }
        if (isAcross) {
            answer = factor_.solve(std::move(answer));
        } else {
            factor_.solveBetween(first, last, answer);
        }
    }
    // Of a node: what it answers to the second difference, axis by axis.
    const auto answerAt = [&](int k) {
        Eigen::Matrix3d block;
        for (int axis = 0; axis < 3; ++axis) {
            block.col(axis) = answers[static_cast<std::size_t>(axis)].segment<3>(3 * at(k));
        }
        return block;
    };
    const Eigen::Matrix3d stiffness = stiffnessAt(i);
    const Eigen::Matrix3d left = answerAt(i - 1) - 2.0 * answerAt(i) + answerAt(i + 1);
    const Eigen::Matrix3d without =
        (Eigen::Matrix3d::Identity() - left * stiffness).partialPivLu().inverse();
    const Vec3 bend = without * (node(i - 1) - 2.0 * node(i) + node(i + 1));
    const auto moved = [&](int k) -> Vec3 { return node(k) + answerAt(k) * stiffness * bend; };
    const double angle = angleBetween(i, moved(i) - moved(i - 1), moved(i + 1) - moved(i));
    // Of independent points, whose variances are to each other as the inverses of their weights:
    // the variance of what they add to the bend's own direction.
    const Vec3 direction = without.transpose() * bend.normalized();
    double squares = 0.0;
    const auto count = static_cast<double>(line_.points.size());
    const double from = static_cast<double>(first) / segments();
    const double to = static_cast<double>(last) / segments();
    const auto begin =
        std::ranges::lower_bound(line_.points, from, {}, &MeasuredLine::Point::parameter);
    for (auto point = begin; point != line_.points.end() && point->parameter <= to; ++point) {
        const auto [a, b, share] = placeOf(point->parameter);
        const Vec3 own = ((1.0 - share) * answerAt(a) + share * answerAt(b)) * direction;
        squares += point->weight / (weight_ * count) * own.squaredNorm();
    }
    return {angle, spread_ * std::sqrt(squares) / step_};
}

bool LineSmoother::addCorners(double angle) {
    const int away = std::clamp(
        static_cast<int>(std::ceil(kSmoothing.leastSection * wavelength_ / step_)), 2, size() / 2
    );
    const std::vector<double> bent = bends();
    std::vector<int> found;
    for (int i = 0; i < size(); ++i) {
        const double own = bent[static_cast<std::size_t>(i)];
        bool isLargest = own > 0.0 && isInner(i, away);
        for (int k = i - away; isLargest && k <= i + away; ++k) {
            const bool isThere = line_.closed || (k >= 0 && k < size());
            isLargest = !isThere || k == i || bent[static_cast<std::size_t>(at(k))] < own;
        }
        if (isLargest) {
            const Turn turn = turnWithout(i);
            if (turn.angle >= angle && turn.angle >= kSmoothing.leastErrors * turn.error) {
                found.push_back(i);
            }
        }
    }
    for (const int i : found) {
        isCorner_[static_cast<std::size_t>(i)] = 1;
    }
    return !found.empty();
}

bool LineSmoother::removeCorners(double angle) {
    bool isAny = false;
    for (int i = 0; i < size(); ++i) {
        char& isCorner = isCorner_[static_cast<std::size_t>(i)];
        if (isCorner != 0 && angleAt(i) < angle) {
            isCorner = 0;
            isAny = true;
        }
    }
    return isAny;
}

std::vector<double> LineSmoother::corners() const {
    std::vector<double> parameters;
    for (int i = 0; i < size(); ++i) {
        if (isCorner_[static_cast<std::size_t>(i)] != 0) {
            parameters.push_back(static_cast<double>(i) / segments());
        }
    }
    return parameters;
}

std::vector<double> LineSmoother::turns() const {
    std::vector<double> angles;
    for (int i = 0; i < size(); ++i) {
        if (isCorner_[static_cast<std::size_t>(i)] != 0) {
            angles.push_back(angleAt(i));
        }
    }
    return angles;
}

}  // namespace bspline_curve
