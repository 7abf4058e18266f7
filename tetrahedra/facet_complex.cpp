// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetrahedra/facet_complex.h"

#include "surface/predicates.h"

#include <tetgen.h>

#include <algorithm>
#include <limits>

namespace bspline_curve {

int FacetComplex::pointAt(const Vec3& position) {
    const auto [entry, isNew] = numbers_.try_emplace(
        {position[0], position[1], position[2]}, static_cast<int>(points_.size())
    );
    if (isNew) {
        points_.push_back(position);
    }
    return entry->second;
}

void FacetComplex::reservePoint(const Vec3& position) {
    numbers_.try_emplace({position[0], position[1], position[2]}, static_cast<int>(points_.size()));
    points_.push_back(position);
}

Triangle FacetComplex::add(const std::array<Vec3, 3>& corners) {
    Triangle triangle{};
    std::ranges::transform(corners, triangle.begin(), [this](const Vec3& p) { return pointAt(p); });
    triangles_.push_back(triangle);
    return triangle;
}

double FacetComplex::shortestEdge() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : triangles_) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 edge = points_[triangle[k]] - points_[triangle[(k + 1) % 3]];
            shortest = std::min(shortest, edge.norm());
        }
    }
    return shortest;
}

int FacetComplex::runTetgen(std::string switches, tetgenio& output) const {
    // TetGen deletes the arrays of its input; these are its own kind.
    tetgenio input;
    input.numberofpoints = static_cast<int>(points_.size());
    input.pointlist = new REAL[3 * points_.size()];
    for (std::size_t i = 0; i < points_.size(); ++i) {
        std::copy_n(points_[i].data(), 3, input.pointlist + 3 * i);
    }
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
        std::ranges::copy(triangles_[i], facet.polygonlist[0].vertexlist);
        input.facetmarkerlist[i] = static_cast<int>(i) + 1;
    }
    tetgenbehavior behaviour;
    behaviour.parse_commandline(switches.data());
    try {
        tetrahedralize(&behaviour, &input, &output);
    } catch (int error) {  // how TetGen as a library ends
        return error == 0 ? -1 : error;
    }
    return 0;
}

namespace {

/// What the face of a tetrahedron opposite to corner k is part of, where the shell ends there.
BoundaryPart partOpposite(int tet, int k) {
    const auto& split = kSlabSplit[static_cast<std::size_t>(tet % 3)];
    for (int j = 0; j < 4; ++j) {
        if (j != k && !split[static_cast<std::size_t>(j)].outer) {
            return BoundaryPart::Wall;
        }
    }
    return tet % kTetrahedraPerPrism < 3 ? BoundaryPart::Top : BoundaryPart::Bottom;
}

}  // namespace

std::vector<BoundaryPart> addShellBoundary(const Shell& shell, FacetComplex& complex) {
    std::vector<BoundaryPart> parts;
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (shell.prisms()[tet / kTetrahedraPerPrism].orientation == 0) {
            continue;
        }
        for (int k = 0; k < 4; ++k) {
            if (shell.neighbour(tet, k) >= 0) {
                continue;
            }
            const Vec3 a = shell.position(tet, (k + 1) % 4);
            Vec3 b = shell.position(tet, (k + 2) % 4);
            Vec3 c = shell.position(tet, (k + 3) % 4);
            if (orientationSign(a, b, c, shell.position(tet, k)) > 0) {
                std::swap(b, c);
            }
            complex.add({a, b, c});
            parts.push_back(partOpposite(tet, k));
        }
    }
    return parts;
}

std::vector<int> addSurfaceFaces(
    const ExtendedSurface& extended, std::span<const int> blockedFaces, FacetComplex& complex
) {
    std::vector<int> added;
    for (int f = 0; f < extended.surfaceFaceCount; ++f) {
        if (!std::ranges::binary_search(blockedFaces, f)) {
            const Triangle& face = extended.faces[f];
            complex.add(
                {extended.vertices[face[0]], extended.vertices[face[1]], extended.vertices[face[2]]}
            );
            added.push_back(f);
        }
    }
    return added;
}

}  // namespace bspline_curve
