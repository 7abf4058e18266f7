// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/slits.h"

#include "surface/half_edges.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

namespace bspline_curve {

namespace {

using Edge = std::array<int, 2>;  // (lower, higher vertex)

/// What lies beside the edges of curves.
class CurveSides {
public:
    CurveSides(const ImprintedMesh& imprinted, const MeshParts& parts)
        : isOnCurve_(imprinted.mesh.vertices.size(), 0),
          isOnBoundary_(imprinted.mesh.vertices.size(), 0) {
        for (const ImprintedCurve& curve : imprinted.curves) {
            for (const int vertex : curve.vertices) {
                isOnCurve_[vertex] = 1;
            }
        }
        std::vector<Triangle> faces;
        std::vector<int> labels;
        for (std::size_t f = 0; f < imprinted.mesh.faces.size(); ++f) {
            const Triangle& face = imprinted.mesh.faces[f];
            if (std::ranges::any_of(face, [&](int vertex) { return isOnCurve_[vertex] != 0; })) {
                faces.push_back(face);
                labels.push_back(parts.labels[f]);
            }
        }
        forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
            addEdge(sides, labels);
        });
    }

    /// Of edges of curves only.
    [[nodiscard]] bool hasTwoParts(const Edge& edge) const {
        return std::ranges::binary_search(parting_, edge);
    }

    [[nodiscard]] bool hasOnePartTwice(const Edge& edge) const {
        return std::ranges::binary_search(inside_, edge);
    }

    [[nodiscard]] bool isOnBoundary(int vertex) const { return isOnBoundary_[vertex] != 0; }

private:
    void addEdge(std::span<const HalfEdge> sides, const std::vector<int>& labels) {
        const Edge edge{sides[0].low, sides[0].high};
        if (sides.size() == 1) {
            // At vertices beside curves, faces are missing here that the mesh has.
            for (const int end : edge) {
                isOnBoundary_[end] = static_cast<char>(isOnBoundary_[end] | isOnCurve_[end]);
            }
        } else if (isOnCurve_[edge[0]] != 0 && isOnCurve_[edge[1]] != 0) {
            const bool isOne = labels[sides[0].face] == labels[sides[1].face];
            (isOne ? inside_ : parting_).push_back(edge);
        }
    }

    std::vector<char> isOnCurve_;     // of each vertex
    std::vector<char> isOnBoundary_;  // of each vertex on a curve
    std::vector<Edge> parting_;       // ascending, as the next
    std::vector<Edge> inside_;
};

}  // namespace

Slits slitsOf(const ImprintedMesh& imprinted, const MeshParts& parts) {
    const CurveSides sides(imprinted, parts);
    const auto opens = [&](const Edge& edge) { return sides.hasOnePartTwice(edge); };
    Slits slits;
    slits.allCurves = static_cast<int>(imprinted.curves.size());
    std::vector<Edge> open;
    for (const ImprintedCurve& curve : imprinted.curves) {
        const std::vector<Edge> edges = edgesOf(curve);
        const bool isParting =
            std::ranges::any_of(edges, [&](const Edge& edge) { return sides.hasTwoParts(edge); });
        if (isParting || std::ranges::none_of(edges, opens)) {
            continue;
        }
        const bool joinsBoundaries =
            sides.isOnBoundary(curve.vertices.front()) && sides.isOnBoundary(curve.vertices.back());
        ++slits.curves;
        slits.completeCurves += curve.closed || joinsBoundaries ? 1 : 0;
        std::ranges::copy_if(edges, std::back_inserter(open), opens);
    }
    sortUnique(open);
    slits.edges = static_cast<int>(open.size());
    return slits;
}

std::string describeSlits(const Slits& slits, bool isCut) {
    if (slits.curves == 0) {
        return {};
    }
    const bool isOne = slits.curves == 1;
    const std::string count = std::to_string(slits.curves);
    std::string text = isOne ? "the curve" : "the " + count + " curves";
    if (slits.curves < slits.allCurves) {
        text = count + " of " + std::to_string(slits.allCurves) + " curves";
    }
    text += isOne ? " parts nothing" : " part nothing";
    if (isCut) {
        text += std::string(": the mesh is cut open along ") + (isOne ? "it" : "them") + " (" +
                std::to_string(slits.edges) + (slits.edges == 1 ? " edge" : " edges") +
                "), a slit that is closed to the eye";
    }
    text += slits.curves == slits.completeCurves
                ? "; round a handle, or from one boundary to another, it takes two curves to part "
                  "the mesh"
                : "; draw a closed curve, or one from boundary to boundary, to part the mesh";
    return text;
}

}  // namespace bspline_curve
