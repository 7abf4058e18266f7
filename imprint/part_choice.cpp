// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/part_choice.h"

#include "bspline_curve/error.h"
#include "surface/half_edges.h"
#include "surface/picks.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Calls visit(edge, first label, second label) for each edge with two faces of different parts,
/// ascending. Such an edge is on a curve, so that only faces with two corners on curves are sorted.
template <class Visitor>
void forEachPartingEdge(
    const ImprintedMesh& imprinted, const std::vector<int>& labels, const Visitor& visit
) {
    std::vector<char> isOnCurve(imprinted.mesh.vertices.size(), 0);
    for (const ImprintedCurve& curve : imprinted.curves) {
        for (const int vertex : curve.vertices) {
            isOnCurve[vertex] = 1;
        }
    }
    const std::vector<Triangle>& faces = imprinted.mesh.faces;
    const std::vector<int> beside = indicesWhere<int>(faces.size(), [&](std::size_t f) {
        const auto& [a, b, c] = faces[f];
        return isOnCurve[a] + isOnCurve[b] + isOnCurve[c] > 1;
    });
    std::vector<Triangle> triangles;
    for (const int face : beside) {
        triangles.push_back(faces[face]);
    }
    forEachEdge(sortedHalfEdges(triangles), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 2) {
            const int one = labels[beside[sides[0].face]];
            const int other = labels[beside[sides[1].face]];
            if (one != other) {
                visit(std::array{sides[0].low, sides[0].high}, one, other);
            }
        }
    });
}

std::string describePoint(const Vec3& point) {
    std::string text = "(";
    for (int k = 0; k < 3; ++k) {
        text += (k > 0 ? ", " : "");
        text += describeNumber(point[k]);
    }
    return text + ")";
}

double diagonalOf(const TriangleMesh& mesh) {
    Vec3 low = mesh.vertices[mesh.faces[0][0]];
    Vec3 high = low;
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            low = low.cwiseMin(mesh.vertices[vertex]);
            high = high.cwiseMax(mesh.vertices[vertex]);
        }
    }
    return (high - low).norm();
}

int partAt(const TriangleMesh& mesh, const std::vector<int>& labels, const Vec3& seed) {
    const std::string name = "the seed " + describePoint(seed);
    if (!seed.allFinite()) {
        throw InputError(InputErrorCode::NonFiniteCoordinate, name + " is not finite");
    }
    const TriangleTree tree(mesh.vertices, mesh.faces);
    const TriangleTree::Closest closest = tree.closestPoint(seed);
    const double reach = kPickReachRelative * diagonalOf(mesh);
    if (closest.squaredDistance > reach * reach) {
        throw InputError(
            InputErrorCode::PickTooFar,
            name + " is " + describeNumber(std::sqrt(closest.squaredDistance)) +
                " away from the mesh; at most " + describeNumber(reach) +
                " is allowed; give a point of the part that is meant"
        );
    }
    // All faces that hold the point: those with each corner that it needs.
    const Triangle& face = mesh.faces[closest.point.face];
    const int label = labels[closest.point.face];
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        bool holds = true;
        for (int k = 0; k < 3; ++k) {
            holds = holds && (closest.point.barycentric[k] <= kOnEdgeBarycentric ||
                              cornerOf(mesh.faces[f], face[k]) >= 0);
        }
        if (holds && labels[f] != label) {
            throw InputError(
                InputErrorCode::NoPath,
                name + " lies on a curve, between two parts; give a point inside one of them"
            );
        }
    }
    return label;
}

/// For each part at curves whether an odd number of curves is between it and the largest of its
/// component, on the way that passes the fewest parts.
std::vector<char> oddParts(const ImprintedMesh& imprinted, const MeshParts& parts) {
    std::vector<std::array<int, 2>> onCurves;
    for (const ImprintedCurve& curve : imprinted.curves) {
        std::ranges::copy(edgesOf(curve), std::back_inserter(onCurves));
    }
    std::ranges::sort(onCurves);

    struct Passage {
        int to;
        bool isOdd;
    };

    std::vector<std::vector<Passage>> passages(parts.parts.size());
    forEachPartingEdge(imprinted, parts.labels, [&](const auto& edge, int one, int other) {
        const bool isOdd = std::ranges::ssize(std::ranges::equal_range(onCurves, edge)) % 2 != 0;
        passages[one].push_back({other, isOdd});
        passages[other].push_back({one, isOdd});
    });
    std::vector<char> isOdd(parts.parts.size(), 0);
    std::vector<char> isReached(parts.parts.size(), 0);
    std::vector<int> reached;
    for (int first = 0; first < static_cast<int>(passages.size()); ++first) {
        if (isReached[first] == 0) {  // the largest of its component
            isReached[first] = 1;
            reached.push_back(first);
        }
        for (std::size_t i = 0; i < reached.size(); ++i) {
            for (const auto& [to, changes] : passages[reached[i]]) {
                if (isReached[to] == 0) {
                    isReached[to] = 1;
                    isOdd[to] = static_cast<char>((isOdd[reached[i]] != 0) != changes);
                    reached.push_back(to);
                }
            }
        }
        reached.clear();
    }
    return isOdd;
}

/// For each part whether it lies inside strokes, or else inside curves, by even and odd.
std::vector<char> insideParts(const ImprintedMesh& imprinted, const MeshParts& parts) {
    if (parts.strokes.empty()) {
        return oddParts(imprinted, parts);
    }
    std::vector<char> isInside(parts.parts.size(), 0);
    for (const int stroke : parts.strokes) {
        isInside[stroke] = 1;
    }
    return isInside;
}

}  // namespace

std::vector<int> partedParts(const ImprintedMesh& imprinted, const MeshParts& parts) {
    std::vector<int> parted;
    forEachPartingEdge(imprinted, parts.labels, [&](const auto&, int one, int other) {
        parted.push_back(one);
        parted.push_back(other);
    });
    sortUnique(parted);
    return parted;
}

void refuseNothingParted() {
    throw InputError(
        InputErrorCode::NoPath,
        "the curves part nothing: no edge of a curve has two parts beside it; give closed curves, "
        "or curves from boundary to boundary"
    );
}

std::vector<int> chosenParts(
    const ImprintedMesh& imprinted, const MeshParts& parts, const PartChoice& choice
) {
    const std::vector<int> parted = partedParts(imprinted, parts);
    if (parted.empty()) {
        refuseNothingParted();
    }
    std::vector<int> chosen;
    switch (choice.which) {
        case PartChoice::Which::Largest:
            return {parted.front()};
        case PartChoice::Which::Smallest:
            return {parted.back()};
        case PartChoice::Which::Inside:
        case PartChoice::Which::Outside: {
            const std::vector<char> isInside = insideParts(imprinted, parts);
            const bool wanted = choice.which == PartChoice::Which::Inside;
            std::ranges::copy_if(parted, std::back_inserter(chosen), [&](int part) {
                return (isInside[part] != 0) == wanted;
            });
            break;
        }
        case PartChoice::Which::Seeds:
            for (const Vec3& seed : choice.seeds) {
                chosen.push_back(partAt(imprinted.mesh, parts.labels, seed));
            }
            sortUnique(chosen);
            break;
    }
    if (chosen.empty()) {
        throw InputError(
            InputErrorCode::NoPath,
            "no part is meant: none lies inside the curves, or there is no seed"
        );
    }
    return chosen;
}

std::vector<int> keptParts(
    const ImprintedMesh& imprinted, const MeshParts& parts, const PartChoice& choice
) {
    std::vector<int> kept = chosenParts(imprinted, parts, choice);
    if (!choice.dropUntouched) {
        const std::vector<int> parted = partedParts(imprinted, parts);
        for (int part = 0; part < static_cast<int>(parts.parts.size()); ++part) {
            if (!std::ranges::binary_search(parted, part)) {
                kept.push_back(part);
            }
        }
        sortUnique(kept);
    }
    return kept;
}

std::vector<std::vector<int>> partsPerMesh(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::optional<PartChoice>& choice,
    bool split
) {
    if (choice) {
        return {keptParts(imprinted, parts, *choice)};
    }
    std::vector<int> all(parts.parts.size());
    std::iota(all.begin(), all.end(), 0);
    if (!split) {
        return {all};
    }
    std::vector<std::vector<int>> groups;
    const std::vector<int> parted = partedParts(imprinted, parts);
    for (const int part : parted) {
        groups.push_back({part});
    }
    std::vector<int> others;
    std::ranges::set_difference(all, parted, std::back_inserter(others));
    if (!others.empty()) {
        groups.push_back(std::move(others));
    }
    std::ranges::sort(groups);
    return groups;
}

CutMesh openedAlongCurves(const ImprintedMesh& imprinted) {
    CutMesh cut = cutAlongCurves(imprinted);
    if (cut.mesh.vertices.size() == imprinted.mesh.vertices.size()) {
        throw InputError(
            InputErrorCode::NoPath,
            "there is nothing to cut: the curves run along the boundary, or are one edge long and "
            "end inside the mesh"
        );
    }
    return cut;
}

std::vector<std::array<int, 2>> edgesAround(
    const ImprintedMesh& imprinted, const MeshParts& parts, const std::vector<int>& chosen
) {
    const auto isChosen = [&](int label) { return std::ranges::binary_search(chosen, label); };
    std::vector<std::array<int, 2>> edges;
    forEachPartingEdge(imprinted, parts.labels, [&](const auto& edge, int one, int other) {
        if (isChosen(one) != isChosen(other)) {
            edges.push_back(edge);
        }
    });
    return edges;
}

}  // namespace bspline_curve
