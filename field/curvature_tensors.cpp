// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_tensors.h"

#include "bspline_curve/progress.h"
#include "utility/worker_task.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace bspline_curve {

namespace {

constexpr int kFewestPoints = 5;  // as many as a quadric through the centre has coefficients

// ---- vertices around a vertex ----

/// Finds the rings of vertices around one vertex after the other, in an order that only depends on
/// the fans of faces.
class RingFinder {
public:
    explicit RingFinder(const Surface& surface)
        : surface_(surface), seenIn_(surface.vertices().size(), 0) {}

    /// The vertices of so many rings, without the centre; valid until the next call. Rings beyond
    /// the first do not go on from the hubs of large fans, whose vertices would all see each other,
    /// unless there are less than five vertices without.
    const std::vector<int>& around(int centre, int rings) {
        find(centre, rings, kMostFacesAround);
        if (found_.size() < kFewestPoints) {
            find(centre, rings, std::numeric_limits<int>::max());
        }
        return found_;
    }

private:
    static constexpr int kMostFacesAround = 100;  // of a vertex that a ring goes on from

    void find(int centre, int rings, int mostFacesAround) {
        found_.clear();
        ++call_;
        seenIn_[centre] = call_;
        addNeighbours(centre);
        for (int ring = 1; ring < rings; ++ring) {
            const std::size_t end = found_.size();
            for (std::size_t i = 0; i < end; ++i) {
                if (surface_.facesAround(found_[i]).size() <= mostFacesAround) {
                    addNeighbours(found_[i]);
                }
            }
        }
    }

    void addNeighbours(int vertex) {
        for (const int face : surface_.facesAround(vertex)) {
            for (const int corner : surface_.faces()[face]) {
                if (seenIn_[corner] != call_) {
                    seenIn_[corner] = call_;
                    found_.push_back(corner);
                }
            }
        }
    }

    const Surface& surface_;
    std::int64_t call_ = 0;
    std::vector<std::int64_t> seenIn_;  ///< the last call that met each vertex
    std::vector<int> found_;
};

// ---- one fit ----

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

/// Less than five points on one ring say too little, as at boundaries.
int ringsAt(const Surface& surface, int vertex, int rings) {
    return surface.facesAround(vertex).size() < kFewestPoints ? 2 : rings;
}

/// Least squares by normal equations. Where many fit equally well, as where points lie on a conic
/// through the centre, nearly the smallest: damping finds it.
Vec5 solved(const Mat5& matrix, const Vec5& right) {
    constexpr double kLeastPivot = 1e-12;  // of the largest; rounding leaves about 1e-15
    constexpr double kDamping = 1e-9;      // of the trace; adds as much to the relative error
    const Eigen::LDLT<Mat5> factors(matrix);
    const Vec5 pivots = factors.vectorD();
    if (pivots.minCoeff() > kLeastPivot * pivots.maxCoeff()) {
        return factors.solve(right);
    }
    const Mat5 damped = matrix + kDamping * matrix.trace() * Mat5::Identity();
    return Eigen::LDLT<Mat5>(damped).solve(right);
}

/// A height over the plane across `normal`, in its frame:
/// z = c0 x^2 + c1 x y + c2 y^2 + c3 x + c4 y.
struct Quadric {
    Eigen::Matrix3d frame;  ///< columns x, y and the normal
    Vec5 coefficients;      ///< the first three in 1 / unit of the surface
};

/// Through a vertex, and near to the points around it. In units of the largest distance, so that
/// all entries of the matrix are near 1.
Quadric fittedQuadric(
    const Surface& surface,
    const std::vector<Vec3>& normals,
    int centre,
    const std::vector<int>& points
) {
    Vec3 normal = normals[centre];
    for (const int point : points) {
        normal += normals[point];
    }
    normal.normalize();
    // What faces the other way is another sheet.
    const auto isFacing = [&](int point) { return normals[point].dot(normal) > 0.0; };
    const bool onlyFacing = std::ranges::count_if(points, isFacing) >= kFewestPoints;

    const Vec3 place = surface.vertices()[centre];
    double size = 0.0;
    for (const int point : points) {
        size = std::max(size, (surface.vertices()[point] - place).squaredNorm());
    }
    size = std::sqrt(size);
    Quadric quadric;
    quadric.frame.col(0) = normal.unitOrthogonal();
    quadric.frame.col(1) = normal.cross(quadric.frame.col(0));
    quadric.frame.col(2) = normal;
    Mat5 matrix = Mat5::Zero();
    Vec5 right = Vec5::Zero();
    for (const int point : points) {
        if (onlyFacing && !isFacing(point)) {
            continue;
        }
        const Vec3 p = quadric.frame.transpose() * (surface.vertices()[point] - place) / size;
        const Vec5 row(p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y());
        matrix += row * row.transpose();
        right += p.z() * row;
    }
    quadric.coefficients = solved(matrix, right);
    quadric.coefficients.head<3>() /= size;
    return quadric;
}

/// The shape operator at the origin of a quadric, S = -sum h_ij g^i (g^j)^T with the dual tangents
/// g^i and the second fundamental form h, as trace(S) P - S with P across the normal: so the
/// curvatures change places.
Eigen::Matrix3d tensorOf(const Quadric& quadric) {
    const Vec5& c = quadric.coefficients;
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << 1.0, 0.0, 0.0, 1.0, c[3], c[4];
    const Eigen::Matrix2d metric = tangents.transpose() * tangents;
    const Eigen::Matrix<double, 3, 2> dual = quadric.frame * tangents * metric.inverse();
    Eigen::Matrix2d second;
    second << 2.0 * c[0], c[1], c[1], 2.0 * c[2];
    second /= -std::sqrt(1.0 + c[3] * c[3] + c[4] * c[4]);
    const Eigen::Matrix3d shape = dual * second * dual.transpose();
    const Eigen::Matrix3d across = dual * metric * dual.transpose();
    const Eigen::Matrix3d tensor = shape.trace() * across - shape;
    return tensor.allFinite() ? tensor : Eigen::Matrix3d::Zero();
}

}  // namespace

std::vector<Eigen::Matrix3d> curvatureTensors(
    const Surface& surface, const std::vector<Vec3>& normals, int rings, const Progress& progress
) {
    constexpr int kReportEvery = 8192;
    std::vector<Eigen::Matrix3d> tensors(surface.vertices().size(), Eigen::Matrix3d::Zero());
    const auto fit = [&](RingFinder& finder, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const std::vector<int>& points = finder.around(v, ringsAt(surface, v, rings));
            if (points.size() >= kFewestPoints) {
                tensors[v] = tensorOf(fittedQuadric(surface, normals, v, points));
            }
        }
    };
    RingFinder finder(surface);
    RingFinder other(surface);
    const int count = surface.vertexCount();
    for (int begin = 0; begin < count; begin += kReportEvery) {
        report(progress, static_cast<double>(begin) / count, "curvature");
        const int end = std::min(begin + kReportEvery, count);
        const int middle = begin + (end - begin) / 2;
        auto rest = startBeside(surface.faces().size(), [&] { fit(other, middle, end); });
        fit(finder, begin, middle);
        rest.get();
    }
    return tensors;
}

}  // namespace bspline_curve
