// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetgen_proof.h"

#include "tetrahedra/facet_complex.h"

#include <Eigen/Geometry>

#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace bspline_curve::test_support {
namespace {

// Signed volume of a tetrahedron, positive where d sees a, b, c run clockwise.
double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (a - d).dot((b - d).cross(c - d)) / 6.0;
}

// The boundary of a shell: its triangles, each with the volume that it spans with the origin,
// positive where the origin lies on the side of the shell.
struct Boundary {
    std::vector<Triangle> triangles;
    std::vector<double> volumes;

    // The volume that the outer parts of the boundary enclose, cavities included, which TetGen
    // fills as well.
    [[nodiscard]] double enclosedVolume(std::size_t pointCount) const {
        std::vector<int> parents(pointCount);
        std::iota(parents.begin(), parents.end(), 0);
        const auto find = [&](int i) {
            while (parents[i] != i) {
                i = parents[i];
            }
            return i;
        };
        for (const auto& [a, b, c] : triangles) {
            parents[find(b)] = find(a);
            parents[find(c)] = find(a);
        }
        std::map<int, double> volumeOfPart;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            volumeOfPart[find(triangles[i][0])] += volumes[i];
        }
        double sum = 0.0;
        for (const auto& [part, volume] : volumeOfPart) {
            sum += std::max(volume, 0.0);
        }
        return sum;
    }
};

Boundary addBoundary(const Shell& shell, FacetComplex& complex) {
    addShellBoundary(shell, complex);
    Boundary boundary{.triangles = complex.triangles(), .volumes = {}};
    const std::vector<Vec3>& points = complex.points();
    for (const auto& [a, b, c] : boundary.triangles) {
        boundary.volumes.push_back(volumeOf(points[a], points[b], points[c], Vec3::Zero()));
    }
    return boundary;
}

double volumeOf(const tetgenio& output) {
    double volume = 0.0;
    for (int i = 0; i < output.numberoftetrahedra; ++i) {
        const auto corner = [&](int k) -> Vec3 {
            return Eigen::Map<const Vec3>(
                output.pointlist + 3 * output.tetrahedronlist[i * output.numberofcorners + k]
            );
        };
        volume += std::abs(volumeOf(corner(0), corner(1), corner(2), corner(3)));
    }
    return volume;
}

}  // namespace

bool TetgenProof::holds() const {
    return intersectingFaces == 0 && error == 0 && tetrahedra > 0 &&
           std::abs(volumeRatio - 1.0) < 1e-9;
}

std::ostream& operator<<(std::ostream& stream, const TetgenProof& proof) {
    return stream << proof.intersectingFaces << " intersecting faces, error " << proof.error << ", "
                  << proof.tetrahedra << " tetrahedra, volume ratio " << proof.volumeRatio;
}

double shortestTetgenEdge(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
) {
    FacetComplex complex;
    addShellBoundary(shell, complex);
    addSurfaceFaces(extended, blockedFaces, complex);
    return complex.shortestEdge();
}

TetgenProof proveWithTetgen(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
) {
    // -X1: no static filter, whose bound would hold for one box only; -Q: quiet.
    FacetComplex complex;
    const Boundary boundary = addBoundary(shell, complex);
    addSurfaceFaces(extended, blockedFaces, complex);
    TetgenProof proof;
    tetgenio intersections;
    proof.error = complex.runTetgen("pdQX1", intersections);
    proof.intersectingFaces = intersections.numberoftrifaces;
    if (proof.error != 0 || proof.intersectingFaces > 0) {
        return proof;
    }
    tetgenio output;
    proof.error = complex.runTetgen("pQX1", output);
    proof.tetrahedra = output.numberoftetrahedra;
    proof.volumeRatio = volumeOf(output) / boundary.enclosedVolume(complex.points().size());
    return proof;
}

}  // namespace bspline_curve::test_support
