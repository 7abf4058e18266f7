// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_field.h"

#include "bspline_curve/progress.h"
#include "field/curvature_tensors.h"
#include "field/surface_diffusion.h"
#include "surface/vertex_normals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bspline_curve {

namespace {

/// Columns 0 to 5: the upper triangle of the tensor; 6 to 8: the normal.
VertexValues<9> tensorsAndNormals(
    const std::vector<Eigen::Matrix3d>& tensors, const std::vector<Vec3>& normals
) {
    VertexValues<9> values(static_cast<Eigen::Index>(tensors.size()), 9);
    for (std::size_t v = 0; v < tensors.size(); ++v) {
        const Eigen::Matrix3d& t = tensors[v];
        const Vec3& n = normals[v];
        values.row(static_cast<Eigen::Index>(v)) << t(0, 0), t(0, 1), t(0, 2), t(1, 1), t(1, 2),
            t(2, 2), n[0], n[1], n[2];
    }
    return values;
}

/// Eigenvalues of a tensor within the plane across a normal.
PrincipalCurvatures curvaturesAcross(const Eigen::Matrix<double, 1, 9>& row) {
    Eigen::Matrix3d tensor;
    tensor << row[0], row[1], row[2], row[1], row[3], row[4], row[2], row[4], row[5];
    const Vec3 normal = row.tail<3>().transpose();
    if (normal.squaredNorm() == 0.0) {
        return {};
    }
    const Vec3 u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u).normalized();
    const double uu = u.dot(tensor * u);
    const double uv = u.dot(tensor * v);
    const double vv = v.dot(tensor * v);
    const double mean = 0.5 * (uu + vv);
    const double apart = std::hypot(0.5 * (uu - vv), uv);
    return {.largest = mean + apart, .smallest = mean - apart};
}

}  // namespace

std::vector<PrincipalCurvatures> principalCurvatures(
    const Surface& surface, double scale, const Progress& progress
) {
    constexpr double kFitShare = 0.25, kPreparedShare = 0.5;  // of the time
    const double radius = scale * surface.diagonal();
    const std::vector<Vec3> normals = vertexNormals(surface.mesh());
    // Two rings see through three times the noise. Where they are wider than four radii, they would
    // lose creases.
    const int rings = surface.averageEdgeLength() > 2.0 * radius ? 1 : 2;
    const std::vector<Eigen::Matrix3d> tensors =
        curvatureTensors(surface, normals, rings, partOf(progress, 0.0, kFitShare));
    const SurfaceDiffusion diffusion(surface, partOf(progress, kFitShare, kPreparedShare));
    const VertexValues<9> smooth = diffusion.smoothed<9>(
        tensorsAndNormals(tensors, normals), radius, partOf(progress, kPreparedShare, 1.0)
    );

    const double length = kCurvatureLength * surface.diagonal();
    std::vector<PrincipalCurvatures> curvatures;
    curvatures.reserve(tensors.size());
    for (Eigen::Index v = 0; v < smooth.rows(); ++v) {
        const auto [largest, smallest] = curvaturesAcross(smooth.row(v));
        curvatures.push_back({.largest = length * largest, .smallest = length * smallest});
    }
    return curvatures;
}

double maximalCurvature(const PrincipalCurvatures& curvatures) {
    return std::clamp(curvatures.largest, kLeastCurvature, kMostCurvature);
}

double ridgeStrength(const PrincipalCurvatures& curvatures) {
    const double back = std::max(0.0, -curvatures.smallest);
    return std::clamp(curvatures.largest - back, 0.0, kMostCurvature);
}

double valleyStrength(const PrincipalCurvatures& curvatures) {
    return ridgeStrength({.largest = -curvatures.smallest, .smallest = -curvatures.largest});
}

}  // namespace bspline_curve
