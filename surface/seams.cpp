// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/seams.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <utility>

namespace bspline_curve {

namespace {

/// For each vertex the first one at its place; empty where no two are at one place.
std::vector<int> firstAtPlaces(const std::vector<Vec3>& vertices) {
    const std::size_t mask = std::bit_ceil(2 * vertices.size() + 1) - 1;
    std::vector<int> slots(mask + 1, -1);
    std::vector<int> first(vertices.size());
    bool isShared = false;
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
        std::uint64_t hash = 0;
        for (const double x : vertices[v]) {
            // 0 is added since both zeros are one place.
            hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15ULL;
            hash ^= hash >> 32U;
        }
        std::size_t slot = hash & mask;
        while (slots[slot] >= 0 && vertices[slots[slot]] != vertices[v]) {
            slot = (slot + 1) & mask;
        }
        if (slots[slot] < 0) {
            slots[slot] = v;
        } else {
            isShared = true;
        }
        first[v] = slots[slot];
    }
    return isShared ? first : std::vector<int>();
}

/// A half-edge and the place that it lies at.
struct PlacedHalfEdge {
    int low, high;  // first vertices at the places of its ends
    HalfEdge at;
    auto operator<=>(const PlacedHalfEdge&) const = default;
};

bool areIndices(const TriangleMesh& mesh) {
    const auto count = static_cast<int>(mesh.vertices.size());
    return std::ranges::all_of(mesh.faces, [&](const Triangle& face) {
        return std::ranges::all_of(face, [&](int v) { return v >= 0 && v < count; });
    });
}

/// The half-edges with an end where vertices share a place, sorted.
std::vector<PlacedHalfEdge> halfEdgesAt(const TriangleMesh& mesh, const std::vector<int>& first) {
    std::vector<char> isShared(first.size(), 0);
    for (int v = 0; v < static_cast<int>(first.size()); ++v) {
        if (first[v] != v) {
            isShared[v] = isShared[first[v]] = 1;
        }
    }
    std::vector<PlacedHalfEdge> halfEdges;
    for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
        const Triangle& face = mesh.faces[f];
        for (int k = 0; k < 3; ++k) {
            const int from = face[(k + 1) % 3];
            const int to = face[(k + 2) % 3];
            if (isShared[from] != 0 || isShared[to] != 0) {
                const auto [low, high] = std::minmax(first[from], first[to]);
                halfEdges.push_back({low, high, {std::min(from, to), std::max(from, to), f, k}});
            }
        }
    }
    std::ranges::sort(halfEdges);
    return halfEdges;
}

/// Whether two faces on an edge lie on each other: at an angle of less than a tenth of a degree.
bool isFold(const TriangleMesh& mesh, const HalfEdge& a, const HalfEdge& b) {
    constexpr double kFoldCosine = 1.0 - 1e-6;
    const Vec3& from = mesh.vertices[a.low];
    const Vec3 along = (mesh.vertices[a.high] - from).normalized();
    const auto across = [&](const HalfEdge& halfEdge) {
        const Vec3 way = mesh.vertices[mesh.faces[halfEdge.face][halfEdge.k]] - from;
        return Vec3(way - way.dot(along) * along).normalized();
    };
    return across(a).dot(across(b)) > kFoldCosine;
}

}  // namespace

std::vector<Seam> findSeams(const TriangleMesh& mesh) {
    const std::vector<int> first = firstAtPlaces(mesh.vertices);
    if (first.empty() || !areIndices(mesh)) {
        return {};
    }
    const std::vector<PlacedHalfEdge> halfEdges = halfEdgesAt(mesh, first);
    const auto edgeOf = [](const PlacedHalfEdge& h) { return std::pair(h.at.low, h.at.high); };
    std::vector<Seam> seams;
    std::vector<HalfEdge> boundary;  // edges of one face at one place
    for (std::size_t i = 0; i < halfEdges.size(); ++i) {
        const PlacedHalfEdge& here = halfEdges[i];
        const bool isAlone =
            (i == 0 || edgeOf(halfEdges[i - 1]) != edgeOf(here)) &&
            (i + 1 == halfEdges.size() || edgeOf(halfEdges[i + 1]) != edgeOf(here));
        if (isAlone && here.low != here.high) {
            boundary.push_back(here.at);
        }
        const bool isLast =
            i + 1 == halfEdges.size() ||
            std::tie(halfEdges[i + 1].low, halfEdges[i + 1].high) != std::tie(here.low, here.high);
        if (isLast) {
            if (boundary.size() == 2 && !isFold(mesh, boundary[0], boundary[1])) {
                const auto startOf = [&](const HalfEdge& h) {
                    return first[mesh.faces[h.face][(h.k + 1) % 3]];
                };
                seams.push_back(
                    {boundary[0], boundary[1], startOf(boundary[0]) == startOf(boundary[1])}
                );
            }
            boundary.clear();
        }
    }
    return seams;
}

}  // namespace bspline_curve
