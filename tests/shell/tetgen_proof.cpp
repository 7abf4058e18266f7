// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetgen_proof.h"

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

// Points by their coordinates, so that vertices of the surface which are middles of pillars are one
// point, and triangles between them.
class Complex {
public:
    Triangle add(const std::array<Vec3, 3>& corners) {
        Triangle triangle{};
        std::transform(corners.begin(), corners.end(), triangle.begin(), [this](const Vec3& p) {
            const auto [entry, isNew] =
                numbers_.try_emplace({p[0], p[1], p[2]}, static_cast<int>(numbers_.size()));
            if (isNew) {
                coordinates_.insert(coordinates_.end(), {p[0], p[1], p[2]});
            }
            return entry->second;
        });
        triangles_.push_back(triangle);
        return triangle;
    }

    [[nodiscard]] double shortestEdge() const {
        double shortest = std::numeric_limits<double>::infinity();
        for (const Triangle& triangle : triangles_) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 edge = point(triangle[k]) - point(triangle[(k + 1) % 3]);
                shortest = std::min(shortest, edge.norm());
            }
        }
        return shortest;
    }

    [[nodiscard]] std::size_t pointCount() const { return numbers_.size(); }

    // TetGen deletes the arrays of its input; these are its own kind.
    void fill(tetgenio& input) const {
        input.numberofpoints = static_cast<int>(numbers_.size());
        input.pointlist = new REAL[coordinates_.size()];
        std::copy(coordinates_.begin(), coordinates_.end(), input.pointlist);
        input.numberoffacets = static_cast<int>(triangles_.size());
        input.facetlist = new tetgenio::facet[triangles_.size()];
        input.facetmarkerlist = new int[triangles_.size()];
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            tetgenio::facet& facet = input.facetlist[i];
            tetgenio::init(&facet);
            facet.numberofpolygons = 1;
            facet.polygonlist = new tetgenio::polygon[1];
            tetgenio::init(facet.polygonlist);
            facet.polygonlist[0].numberofvertices = 3;
            facet.polygonlist[0].vertexlist = new int[3];
            std::copy(triangles_[i].begin(), triangles_[i].end(), facet.polygonlist[0].vertexlist);
            input.facetmarkerlist[i] = static_cast<int>(i) + 1;
        }
    }

private:
    [[nodiscard]] Vec3 point(int i) const {
        return Eigen::Map<const Vec3>(coordinates_.data() + 3 * static_cast<std::ptrdiff_t>(i));
    }

    std::map<std::array<double, 3>, int> numbers_;
    std::vector<double> coordinates_;
    std::vector<Triangle> triangles_;
};

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

Boundary addBoundary(const Shell& shell, Complex& complex) {
    Boundary boundary;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation == 0) {
            continue;
        }
        for (int k = 0; k < 4; ++k) {
            if (shell.neighbour(tet, k) >= 0) {
                continue;
            }
            const Vec3 a = shell.position(tet, (k + 1) % 4);
            const Vec3 b = shell.position(tet, (k + 2) % 4);
            const Vec3 c = shell.position(tet, (k + 3) % 4);
            const bool isOutward = volumeOf(a, b, c, shell.position(tet, k)) > 0.0;
            boundary.triangles.push_back(complex.add({a, b, c}));
            boundary.volumes.push_back((isOutward ? 1 : -1) * volumeOf(a, b, c, Vec3::Zero()));
        }
    }
    return boundary;
}

void addSurface(
    const ExtendedSurface& extended, std::span<const int> blockedFaces, Complex& complex
) {
    for (int f = 0; f < extended.surfaceFaceCount; ++f) {
        if (!std::binary_search(blockedFaces.begin(), blockedFaces.end(), f)) {
            const Triangle& face = extended.faces[f];
            complex.add(
                {extended.vertices[face[0]], extended.vertices[face[1]], extended.vertices[face[2]]}
            );
        }
    }
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

// Returns the error that it stopped with, 0 for none.
int run(const Complex& complex, std::string switches, tetgenio& output) {
    tetgenio input;
    complex.fill(input);
    tetgenbehavior behaviour;
    behaviour.parse_commandline(switches.data());
    try {
        tetrahedralize(&behaviour, &input, &output);
    } catch (int error) {  // how TetGen as a library ends
        return error == 0 ? -1 : error;
    }
    return 0;
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
    Complex complex;
    addBoundary(shell, complex);
    addSurface(extended, blockedFaces, complex);
    return complex.shortestEdge();
}

TetgenProof proveWithTetgen(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
) {
    // -X1: no static filter, whose bound would hold for one box only; -Q: quiet.
    Complex complex;
    const Boundary boundary = addBoundary(shell, complex);
    addSurface(extended, blockedFaces, complex);
    TetgenProof proof;
    tetgenio intersections;
    proof.error = run(complex, "pdQX1", intersections);
    proof.intersectingFaces = intersections.numberoftrifaces;
    if (proof.error != 0 || proof.intersectingFaces > 0) {
        return proof;
    }
    tetgenio output;
    proof.error = run(complex, "pQX1", output);
    proof.tetrahedra = output.numberoftetrahedra;
    proof.volumeRatio = volumeOf(output) / boundary.enclosedVolume(complex.pointCount());
    return proof;
}

}  // namespace bspline_curve::test_support
