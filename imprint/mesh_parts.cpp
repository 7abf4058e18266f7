// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/mesh_parts.h"

#include "surface/half_edges.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

namespace bspline_curve {

std::vector<std::array<int, 2>> edgesOf(const ImprintedCurve& curve) {
    std::vector<std::array<int, 2>> edges;
    const std::size_t count = curve.vertices.size();
    for (std::size_t i = 0; i + 1 < count + (curve.closed ? 1 : 0); ++i) {
        const auto [low, high] = std::minmax(curve.vertices[i], curve.vertices[(i + 1) % count]);
        if (low != high) {
            edges.push_back({low, high});
        }
    }
    sortUnique(edges);
    return edges;
}

std::vector<std::array<int, 2>> curveEdges(const ImprintedMesh& imprinted) {
    std::vector<std::array<int, 2>> edges;
    for (const ImprintedCurve& curve : imprinted.curves) {
        std::ranges::copy(edgesOf(curve), std::back_inserter(edges));
    }
    sortUnique(edges);
    return edges;
}

namespace {

/// The faces at some edges and further vertices, and the fans into which these edges part those
/// around each vertex.
class EdgeFans {
public:
    EdgeFans(
        const TriangleMesh& mesh,
        const std::vector<std::array<int, 2>>& edges,
        const std::vector<int>& vertices
    )
        : mesh_(mesh),
          edges_(edges),
          isOnEdge_(isAmong(vertices, mesh.vertices.size())),
          near_(nearFaces(mesh.faces)),
          corners_(3 * near_.size()) {
        for (const int face : near_) {
            triangles_.push_back(mesh.faces[face]);
        }
        forEachEdge(sortedHalfEdges(triangles_), [&](std::span<const HalfEdge> sides) {
            const std::array<int, 2> edge{sides[0].low, sides[0].high};
            if (sides.size() > 1 && !std::ranges::binary_search(edges_, edge)) {
                for (const int end : edge) {
                    corners_.unite(cornerAt(sides[0], end), cornerAt(sides[1], end));
                }
            }
        });
    }

    /// Gives each fan but the first of a vertex a copy of it.
    [[nodiscard]] CutMesh open() {
        CutMesh cut{.mesh = mesh_, .source = std::vector<int>(isOnEdge_.size())};
        std::iota(cut.source.begin(), cut.source.end(), 0);
        std::vector<int> vertexOfFan(3 * near_.size(), -1);
        int before = -1;
        for (const auto& [vertex, fan] : fans()) {
            vertexOfFan[fan] = vertex;
            if (vertex == before) {
                vertexOfFan[fan] = static_cast<int>(cut.mesh.vertices.size());
                cut.mesh.vertices.push_back(mesh_.vertices[vertex]);
                cut.source.push_back(vertex);
            }
            before = vertex;
        }
        for (int corner = 0; corner < cornerCount(); ++corner) {
            if (isOnEdge_[vertexAt(corner)] != 0) {
                cut.mesh.faces[near_[corner / 3]].at(corner % 3) =
                    vertexOfFan[corners_.find(corner)];
            }
        }
        return cut;
    }

private:
    static std::vector<char> isAmong(const std::vector<int>& vertices, std::size_t count) {
        std::vector<char> isAmong(count, 0);
        for (const int vertex : vertices) {
            isAmong[vertex] = 1;
        }
        return isAmong;
    }

    std::vector<int> nearFaces(const std::vector<Triangle>& faces) {
        for (const auto& [low, high] : edges_) {
            isOnEdge_[low] = isOnEdge_[high] = 1;
        }
        return indicesWhere<int>(faces.size(), [&](std::size_t f) {
            return std::ranges::any_of(faces[f], [&](int v) { return isOnEdge_[v] != 0; });
        });
    }

    [[nodiscard]] int cornerCount() const { return static_cast<int>(3 * near_.size()); }

    [[nodiscard]] int vertexAt(int corner) const { return triangles_[corner / 3][corner % 3]; }

    /// The corner of a side's face at one end of the side.
    [[nodiscard]] int cornerAt(const HalfEdge& side, int end) const {
        const int next = (side.k + 1) % 3;
        return 3 * side.face + (triangles_[side.face][next] == end ? next : (side.k + 2) % 3);
    }

    /// The fans at vertices of the edges as (vertex, first corner), ascending.
    [[nodiscard]] std::vector<std::pair<int, int>> fans() {
        std::vector<std::pair<int, int>> fans;
        for (int corner = 0; corner < cornerCount(); ++corner) {
            if (isOnEdge_[vertexAt(corner)] != 0 && corners_.find(corner) == corner) {
                fans.emplace_back(vertexAt(corner), corner);
            }
        }
        std::ranges::sort(fans);
        return fans;
    }

    const TriangleMesh& mesh_;
    const std::vector<std::array<int, 2>>& edges_;
    std::vector<char> isOnEdge_;  // by vertex; or among the further ones
    std::vector<int> near_;       // faces with such a vertex
    std::vector<Triangle> triangles_;
    DisjointSets corners_;  // 3 f + k for near face f; those of one fan are one set
};

}  // namespace

CutMesh cutAlongEdges(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& edges) {
    return EdgeFans(mesh, edges, {}).open();
}

CutMesh partFans(const TriangleMesh& mesh, const std::vector<int>& vertices) {
    return EdgeFans(mesh, {}, vertices).open();
}

CutMesh cutAlongCurves(const ImprintedMesh& imprinted) {
    return cutAlongEdges(imprinted.mesh, curveEdges(imprinted));
}

namespace {

double areaOf(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& a = mesh.vertices[face[0]];
    return 0.5 * (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a).norm();
}

/// Numbers the sets of faces from the largest area to the smallest.
std::vector<int> labelByArea(const TriangleMesh& mesh, DisjointSets& sets, int& count) {
    const auto faceCount = static_cast<int>(mesh.faces.size());
    std::vector<double> area(faceCount, 0.0);
    std::vector<int> roots;
    for (int f = 0; f < faceCount; ++f) {
        const int root = sets.find(f);
        area[root] += areaOf(mesh, mesh.faces[f]);
        if (root == f) {
            roots.push_back(f);
        }
    }
    std::ranges::stable_sort(roots, [&](int a, int b) { return area[a] > area[b]; });
    std::vector<int> labelOf(faceCount, -1);
    count = static_cast<int>(roots.size());
    for (int label = 0; label < count; ++label) {
        labelOf[roots[label]] = label;
    }
    std::vector<int> labels(faceCount);
    for (int f = 0; f < faceCount; ++f) {
        labels[f] = labelOf[sets.find(f)];
    }
    return labels;
}

}  // namespace

MeshParts partsOf(const ImprintedMesh& imprinted, const GoOn& goOn) {
    const CutMesh cut = cutAlongCurves(imprinted);
    goOn();
    const TriangleMesh& mesh = cut.mesh;
    DisjointSets sets(mesh.faces.size());
    const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh.faces);
    goOn();
    forEachEdge(halfEdges, [&](std::span<const HalfEdge> sides) {
        if (sides.size() > 1) {
            sets.unite(sides[0].face, sides[1].face);
        }
    });
    goOn();
    MeshParts result;
    int count = 0;
    result.labels = labelByArea(mesh, sets, count);
    goOn();
    result.parts.resize(count);
    std::vector<int> partOfVertex(mesh.vertices.size(), -1);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        MeshPart& part = result.parts[result.labels[f]];
        const double area = areaOf(mesh, mesh.faces[f]);
        ++part.faces;
        ++part.euler;
        part.area += area;
        for (const int vertex : mesh.faces[f]) {
            part.centroid += area / 3.0 * mesh.vertices[vertex];
            partOfVertex[vertex] = result.labels[f];
        }
    }
    goOn();
    for (const int part : partOfVertex) {
        if (part >= 0) {
            ++result.parts[part].euler;
        }
    }
    forEachEdge(halfEdges, [&](std::span<const HalfEdge> sides) {
        MeshPart& part = result.parts[result.labels[sides[0].face]];
        --part.euler;
        if (sides.size() == 1) {
            part.perimeter += (mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).norm();
        }
    });
    for (MeshPart& part : result.parts) {
        part.centroid /= part.area;
    }
    return result;
}

SubMesh facesWithLabels(
    const TriangleMesh& mesh, const std::vector<int>& labels, const std::vector<int>& chosen
) {
    SubMesh part;
    part.faces = indicesWhere<int>(labels.size(), [&](std::size_t f) {
        return std::ranges::binary_search(chosen, labels[f]);
    });
    std::vector<int> newVertex(mesh.vertices.size(), -1);
    for (const int face : part.faces) {
        for (const int vertex : mesh.faces[face]) {
            newVertex[vertex] = 0;
        }
    }
    for (std::size_t v = 0; v < newVertex.size(); ++v) {
        if (newVertex[v] == 0) {
            newVertex[v] = static_cast<int>(part.vertices.size());
            part.vertices.push_back(static_cast<int>(v));
            part.mesh.vertices.push_back(mesh.vertices[v]);
        }
    }
    for (const int face : part.faces) {
        const auto& [a, b, c] = mesh.faces[face];
        part.mesh.faces.push_back({newVertex[a], newVertex[b], newVertex[c]});
    }
    return part;
}

}  // namespace bspline_curve
