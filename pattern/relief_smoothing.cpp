// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/relief_smoothing.h"

#include <Eigen/Geometry>

#include <vector>

namespace bspline_curve {

namespace {

// Steps towards the mean of the neighbours and away from it: bumps wider than about seven edges
// stay.
constexpr double kTowards = 0.5;
constexpr double kAway = -0.53;

/// Not of unit length: sums of the faces' normals times their areas.
std::vector<Vec3> normalsOf(const Surface& surface, const std::vector<Vec3>& vertices) {
    std::vector<Vec3> normals(vertices.size(), Vec3::Zero());
    for (const auto& [a, b, c] : surface.faces()) {
        const Vec3 normal = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
        for (const int v : {a, b, c}) {
            normals[v] += normal;
        }
    }
    return normals;
}

void step(const Surface& surface, double share, std::vector<Vec3>& vertices) {
    const std::vector<Vec3> normals = normalsOf(surface, vertices);
    // Each neighbour of an inner vertex lies on two of its faces.
    std::vector<Vec3> sums(vertices.size(), Vec3::Zero());
    std::vector<int> counts(vertices.size(), 0);
    for (const Triangle& face : surface.faces()) {
        for (int k = 0; k < 3; ++k) {
            sums[face[k]] += vertices[face[(k + 1) % 3]] + vertices[face[(k + 2) % 3]];
            counts[face[k]] += 2;
        }
    }
    for (int v = 0; v < surface.vertexCount(); ++v) {
        const double squared = normals[v].squaredNorm();
        if (counts[v] > 0 && !surface.isBoundaryVertex(v) && squared > 0.0) {
            const Vec3 towards = sums[v] / counts[v] - vertices[v];
            vertices[v] += share * towards.dot(normals[v]) / squared * normals[v];
        }
    }
}

}  // namespace

TriangleMesh smoothedRelief(const Surface& surface, int passes) {
    TriangleMesh mesh = surface.mesh();
    for (int pass = 0; pass < passes; ++pass) {
        step(surface, kTowards, mesh.vertices);
        step(surface, kAway, mesh.vertices);
    }
    return mesh;
}

}  // namespace bspline_curve
