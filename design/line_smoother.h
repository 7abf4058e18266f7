// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "design/initial_path.h"
#include "shell/extended_surface.h"
#include "spline/band_cholesky.h"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A line on the surface that is to become smooth, and the points that it is known by.
struct MeasuredLine {
    InitialPath path;  ///< closed: ends where it starts
    bool closed = false;

    struct Point {
        double parameter;  ///< of the path, ascending
        Vec3 position;
        double weight;  ///< > 0
    };

    std::vector<Point> points;
};

/// The curve x over the length s of a line with the least
///   sum_k weight_k |x(s_k) - y_k|^2 / sum_k weight_k
///   + (1 - tension) w^4 / L integral |x''|^2 + tension w^2 / L integral |x'|^2
/// with w = wavelength / 2 pi (a smoothing spline, Reinsch 1967, under tension), at nodes so many
/// that waves of the shortest length have four. Of the part of x'' along the surface's normal only
/// a share counts: the surface forces it. An open one ends where the line does. At corners |x''|^2
/// does not count. O(n) for n points and nodes.
class LineSmoother {
public:
    struct Stiffness {
        double tension;      ///< in [0, 1]
        double normalShare;  ///< of bending along the normal, in (0, 1]
    };

    /// All must outlive this. `shortest`: of the wavelengths, in the shell's frame.
    LineSmoother(
        const ExtendedSurface& extended,
        const MeasuredLine& line,
        double shortest,
        const Stiffness& stiffness
    );

    /// Smooth so that waves of that length are half flattened; returns the spread: the root of the
    /// mean square distance of the points.
    double smooth(double wavelength);

    [[nodiscard]] double wavelength() const { return wavelength_; }

    [[nodiscard]] double spread() const { return spread_; }

    /// Makes those nodes corners at which the curve would turn by `angle` (radians, along the
    /// surface) and more if it could, and by so much that the points' distances do not explain it.
    /// Two are at least half a wavelength apart. The curve stays as it is until it is made smooth
    /// again. Returns whether there are new ones.
    [[nodiscard]] bool addCorners(double angle);

    /// Makes corners at which the curve turns by less than `angle` none. Returns whether there were
    /// any.
    [[nodiscard]] bool removeCorners(double angle);

    /// Parameters of the line at which there are corners, ascending in [0, 1).
    [[nodiscard]] std::vector<double> corners() const;

    /// By how much the curve turns at each of them, in radians.
    [[nodiscard]] std::vector<double> turns() const;

    /// A share of the line's length, and where it goes.
    [[nodiscard]] Vec3 positionAt(double parameter) const;

private:
    struct Place {
        int i, j;
        double share;
    };

    // What the curve would turn by at a node without its term of |x''|^2.
    struct Turn {
        double angle;
        double error;  // standard deviation of it, for points that are off by the spread
    };

    void add(int i, int j, const Eigen::Matrix3d& values);
    void addPoints(Eigen::VectorXd& right);
    void addDifferences();
    void hold(int i, const Vec3& end, Eigen::VectorXd& right);
    [[nodiscard]] Eigen::Matrix3d stiffnessAt(int i) const;

    [[nodiscard]] int size() const { return count_; }

    [[nodiscard]] int segments() const { return count_ - (line_.closed ? 0 : 1); }

    [[nodiscard]] int at(int i) const { return (i + count_) % count_; }

    [[nodiscard]] const Vec3& node(int i) const { return nodes_[static_cast<std::size_t>(at(i))]; }

    [[nodiscard]] Place placeOf(double parameter) const;
    [[nodiscard]] double spreadNow() const;
    [[nodiscard]] double angleBetween(int i, const Vec3& before, const Vec3& after) const;
    [[nodiscard]] double angleAt(int i) const;
    [[nodiscard]] std::vector<double> bends() const;
    [[nodiscard]] bool isInner(int i, int away) const;
    [[nodiscard]] Turn turnWithout(int i) const;

    const MeasuredLine& line_;
    Stiffness stiffness_;
    double length_;
    int count_;
    double step_;
    double weight_ = 0.0;
    double wavelength_ = 0.0, spread_ = 0.0;
    BandCholesky<3> factor_;
    std::vector<Vec3> nodes_;
    std::vector<Vec3> normals_;  // of the surface beneath the line, at nodes
    std::vector<char> isCorner_;
};

}  // namespace bspline_curve
