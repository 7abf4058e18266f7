// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/obstacle_field.h"

#include "bspline_curve/error.h"
#include "text/error_messages.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>

namespace bspline_curve {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

/// The vertices of a region, numbered: those inside first, then those on its boundary.
struct RegionVertices {
    std::vector<int> ids;        ///< in the surface
    std::vector<int> numberOf;   ///< #V; -1 outside
    std::vector<char> isBorder;  ///< #V; 1 on an edge between the region and other faces
    int insideCount = 0;
};

void refuse(const std::string& reason, const std::vector<std::int64_t>& elements = {}) {
    throw InputError(InputErrorCode::BadField, "obstacles: " + reason, elements);
}

std::vector<char> flagsOf(const Surface& surface, std::span<const int> region) {
    if (region.empty()) {
        refuse("the region has no faces; select some");
    }
    std::vector<char> isInRegion(surface.faces().size(), 0);
    for (const int face : region) {
        isInRegion[face] = 1;
    }
    return isInRegion;
}

bool isBorderEdge(const std::vector<char>& isInRegion, int neighbour) {
    return neighbour >= 0 && isInRegion[neighbour] == 0;
}

/// Pieces that share edges must each have a border, or their values would hang on nothing.
void refuseWholeComponents(
    const Surface& surface, std::span<const int> region, const std::vector<char>& isInRegion
) {
    const auto count = surface.componentCount();
    std::vector<int> firstFace(count, -1);
    std::vector<char> hasBorder(count, 0);
    for (const int face : region) {
        const std::size_t component = (surface.faceComponents()[face]);
        firstFace[component] = firstFace[component] < 0 ? face : firstFace[component];
        const Triangle& neighbours = surface.faceNeighbours()[face];
        if (std::ranges::any_of(neighbours, [&](int n) { return isBorderEdge(isInRegion, n); })) {
            hasBorder[component] = 1;
        }
    }
    std::vector<std::int64_t> whole;
    for (int i = 0; i < count; ++i) {
        if (firstFace[i] >= 0 && hasBorder[i] == 0) {
            whole.push_back(firstFace[i]);
        }
    }
    if (!whole.empty()) {
        refuse(
            "the region covers all of " + describeCount(whole.size(), "component", "components") +
                " of the mesh (with faces " + describeElements(whole) +
                "), so no curve can go round it; leave some faces out",
            whole
        );
    }
}

RegionVertices numberVertices(
    const Surface& surface, std::span<const int> region, const std::vector<char>& isInRegion
) {
    RegionVertices vertices;
    vertices.numberOf.assign(surface.vertices().size(), -1);
    vertices.isBorder.assign(surface.vertices().size(), 0);
    for (const int face : region) {
        const Triangle& corners = surface.faces()[face];
        for (std::size_t k = 0; k < 3; ++k) {
            if (isBorderEdge(isInRegion, surface.faceNeighbours()[face][k])) {
                vertices.isBorder[corners[(k + 1) % 3]] = 1;
                vertices.isBorder[corners[(k + 2) % 3]] = 1;
            }
        }
    }
    for (const int border : {0, 1}) {
        for (const int face : region) {
            for (const int corner : surface.faces()[face]) {
                if (vertices.isBorder[corner] == border && vertices.numberOf[corner] < 0) {
                    vertices.numberOf[corner] = static_cast<int>(vertices.ids.size());
                    vertices.ids.push_back(corner);
                }
            }
        }
        vertices.insideCount =
            border == 0 ? static_cast<int>(vertices.ids.size()) : vertices.insideCount;
    }
    return vertices;
}

/// The linear elements of a region, lengths in diagonals.
struct Elements {
    Matrix stiffness;         ///< #vertices by #vertices of the region
    Eigen::VectorXd masses;   ///< lumped
    Eigen::VectorXd outflow;  ///< integral over the border of (outward slope 1) times each hat
};

Elements assemble(
    const Surface& surface,
    std::span<const int> region,
    const std::vector<char>& isInRegion,
    const RegionVertices& vertices
) {
    const double largestCotangent = 1.0 / std::tan(std::numbers::pi / 180.0);
    const auto count = static_cast<Eigen::Index>(vertices.ids.size());
    Elements elements{
        .stiffness = Matrix(count, count),
        .masses = Eigen::VectorXd::Zero(count),
        .outflow = Eigen::VectorXd::Zero(count)
    };
    std::vector<Triplet> entries;
    entries.reserve(12 * region.size());
    for (const int face : region) {
        const Triangle& corners = surface.faces()[face];
        for (std::size_t k = 0; k < 3; ++k) {
            const int self = vertices.numberOf[corners[k]];
            const int next = vertices.numberOf[corners[(k + 1) % 3]];
            const int last = vertices.numberOf[corners[(k + 2) % 3]];
            const Vec3& corner = surface.vertices()[corners[k]];
            const Vec3 toNext = surface.vertices()[corners[(k + 1) % 3]] - corner;
            const Vec3 toLast = surface.vertices()[corners[(k + 2) % 3]] - corner;
            const double doubleArea = toNext.cross(toLast).norm();
            const double weight =
                0.5 *
                std::clamp(toNext.dot(toLast) / doubleArea, -largestCotangent, largestCotangent);
            entries.emplace_back(next, last, -weight);
            entries.emplace_back(last, next, -weight);
            entries.emplace_back(next, next, weight);
            entries.emplace_back(last, last, weight);
            elements.masses[self] += doubleArea / 6.0;
            if (isBorderEdge(isInRegion, surface.faceNeighbours()[face][k])) {
                const double half = 0.5 * (toNext - toLast).norm();
                elements.outflow[next] += half;
                elements.outflow[last] += half;
            }
        }
    }
    elements.stiffness.setFromTriplets(entries.begin(), entries.end());
    const double diagonal = surface.diagonal();
    elements.masses /= diagonal * diagonal;
    elements.outflow /= diagonal;
    return elements;
}

/// Values inside for the value 0 on the border and the slope 1 towards the inside.
///
/// With J = -Laplace(I), weakly: K I = M J + (outward slope) outflow for every vertex of the
/// region, and K J = 0 for those inside. The outward slope is -1 and M is diagonal, so that J goes:
/// (K' M^-1 K) I = -K' M^-1 outflow, K being the columns of the vertices inside.
Eigen::VectorXd solveInside(const Elements& elements, int insideCount) {
    const Matrix inside = elements.stiffness.leftCols(insideCount);
    const Eigen::VectorXd inverseMasses = elements.masses.cwiseInverse();
    const Matrix scaled = inverseMasses.asDiagonal() * inside;
    const Matrix system = inside.transpose() * scaled;
    const Eigen::VectorXd right = -(scaled.transpose() * elements.outflow);
    const Eigen::SimplicialLDLT<Matrix> factors(system);
    Eigen::VectorXd values;
    if (factors.info() == Eigen::Success) {
        values = factors.solve(right);
    }
    if (values.size() == 0 || !values.allFinite()) {
        refuse("the field cannot be computed, since faces of the region are too thin; remesh it");
    }
    return values;
}

}  // namespace

std::vector<double> obstacleField(
    const Surface& surface, std::span<const int> region, double value, double slope
) {
    const std::vector<char> isInRegion = flagsOf(surface, region);
    refuseWholeComponents(surface, region, isInRegion);
    const RegionVertices vertices = numberVertices(surface, region, isInRegion);
    if (vertices.insideCount == 0 && value == 0.0) {
        refuse(
            "no vertex lies inside the region, so the field would be 0 everywhere; refine the mesh "
            "there, or give the boundary a value"
        );
    }
    std::vector<double> field(surface.vertices().size(), 0.0);
    for (const int vertex : vertices.ids) {
        field[vertex] = value;
    }
    if (vertices.insideCount > 0) {
        const Eigen::VectorXd inside =
            solveInside(assemble(surface, region, isInRegion, vertices), vertices.insideCount);
        for (int i = 0; i < vertices.insideCount; ++i) {
            field[vertices.ids[i]] += slope * inside[i];
        }
    }
    return field;
}

}  // namespace bspline_curve
