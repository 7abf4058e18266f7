// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/sheet_patch.h"

#include "fill/inner_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// The faces around each vertex.
class VertexFaces {
public:
    VertexFaces(const std::vector<Triangle>& faces, std::size_t vertexCount)
        : faces_(faces), first_(vertexCount + 2, 0), around_(3 * faces.size()) {
        for (const Triangle& face : faces) {
            for (const int vertex : face) {
                ++first_[vertex + 2];
            }
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            for (const int vertex : faces[f]) {
                around_[first_[vertex + 1]++] = static_cast<int>(f);
            }
        }
    }

    [[nodiscard]] std::span<const int> around(int vertex) const {
        return std::span(around_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }

    /// The face across the side opposite to a corner; -1: none, or several.
    [[nodiscard]] int across(int face, int k) const {
        const int from = faces_[face][(k + 1) % 3];
        const int to = faces_[face][(k + 2) % 3];
        int found = -1;
        for (const int other : around(from)) {
            if (other != face && std::ranges::find(faces_[other], to) != faces_[other].end()) {
                if (found >= 0) {
                    return -1;
                }
                found = other;
            }
        }
        return found;
    }

private:
    const std::vector<Triangle>& faces_;
    std::vector<std::size_t> first_;  // of each vertex in `around_`
    std::vector<int> around_;
};

using DirectedEdges = std::set<std::pair<int, int>>;

/// The faces that are joined to those on some directed sides, without crossing these, ascending;
/// none where they are more than `most`.
std::vector<Triangle> facesJoinedTo(
    const TriangleMesh& mesh, const DirectedEdges& rim, std::size_t most
) {
    const std::vector<Triangle>& faces = mesh.faces;
    const VertexFaces vertices(faces, mesh.vertices.size());
    const auto isOnRim = [&](int f, int k) {
        return rim.contains({faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]});
    };
    std::vector<char> isFound(faces.size(), 0);
    std::vector<int> found;
    for (const auto& [from, to] : rim) {
        for (const int face : vertices.around(from)) {
            if (isFound[face] == 0 && (isOnRim(face, 0) || isOnRim(face, 1) || isOnRim(face, 2))) {
                isFound[face] = 1;
                found.push_back(face);
            }
        }
    }
    for (std::size_t i = 0; i < found.size() && found.size() <= most; ++i) {
        const int face = found[i];
        for (int k = 0; k < 3; ++k) {
            const int other = isOnRim(face, k) ? -1 : vertices.across(face, k);
            if (other >= 0 && isFound[other] == 0) {
                isFound[other] = 1;
                found.push_back(other);
            }
        }
    }
    if (found.size() > most) {
        return {};
    }
    std::ranges::sort(found);
    std::vector<Triangle> joined;
    joined.reserve(found.size());
    for (const int face : found) {
        joined.push_back(faces[face]);
    }
    return joined;
}

/// Whether faces are a disc whose boundary is made of some directed sides.
bool isDisc(const std::vector<Triangle>& faces, const DirectedEdges& rim) {
    std::set<int> vertices;
    for (const Triangle& face : faces) {
        vertices.insert(face.begin(), face.end());
    }
    std::size_t edges = 0;
    std::size_t boundary = 0;
    bool isManifold = true;
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        ++edges;
        isManifold = isManifold && sides.size() <= 2;
        if (sides.size() == 1) {
            const Triangle& face = faces[sides[0].face];
            const int k = sides[0].k;
            ++boundary;
            isManifold = isManifold && rim.contains({face[(k + 1) % 3], face[(k + 2) % 3]});
        }
    });
    return isManifold && boundary == rim.size() && vertices.size() + faces.size() == edges + 1;
}

/// Halves inner edges between points of the rim.
void halveChords(Patch& patch) {
    for (bool isDone = false; !isDone;) {
        isDone = true;
        ChangedFaces changed(patch.faces.size());
        for (const InnerEdge& edge : innerEdges(patch.faces)) {
            const auto& [a, b, c, d, first, second] = edge;
            if (!patch.isOnRim(a) || !patch.isOnRim(b)) {
                continue;
            }
            isDone = false;
            if (changed.take(first, second)) {
                const auto middle = static_cast<int>(patch.points.size());
                patch.points.emplace_back(0.5 * (patch.points[a] + patch.points[b]));
                patch.faces[first] = {a, middle, c};
                patch.faces[second] = {b, middle, d};
                patch.faces.push_back({middle, b, c});
                patch.faces.push_back({middle, a, d});
            }
        }
    }
}

/// A unit direction on whose side all of some unit normals are, as far as there is one: normals
/// that are farthest from it are added, in turn, until none is far.
Vec3 directionAlong(const std::vector<Vec3>& normals) {
    constexpr int kTurns = 50;
    constexpr double kShare = 0.2;
    constexpr double kNearCosine = 0.7;
    Vec3 direction = Vec3::Zero();
    for (const Vec3& normal : normals) {
        direction += normal;
    }
    direction.stableNormalize();
    for (int turn = 0; turn < kTurns; ++turn) {
        const auto farthest =
            std::ranges::min_element(normals, {}, [&](const Vec3& n) { return n.dot(direction); });
        if (farthest->dot(direction) > kNearCosine) {
            break;
        }
        direction = (direction + kShare / (1.0 + 0.2 * turn) * *farthest).stableNormalized();
    }
    return direction;
}

}  // namespace

std::optional<Patch> sheetBeside(
    const TriangleMesh& mesh, const std::vector<int>& rim, bool isBehind, std::size_t most
) {
    DirectedEdges sides;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const int from = rim[i];
        const int to = rim[(i + 1) % rim.size()];
        sides.insert(isBehind ? std::pair{to, from} : std::pair{from, to});
    }
    const std::vector<Triangle> faces = facesJoinedTo(mesh, sides, most);
    if (faces.empty() || !isDisc(faces, sides)) {
        return std::nullopt;
    }
    Patch patch;
    std::map<int, int> pointOf;
    for (const int vertex : rim) {
        pointOf.emplace(vertex, static_cast<int>(patch.points.size()));
        patch.points.push_back(mesh.vertices[vertex]);
    }
    patch.rimCount = static_cast<int>(rim.size());
    for (const Triangle& face : faces) {
        Triangle& copy = patch.faces.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const auto [at, isNew] =
                pointOf.emplace(face[k], static_cast<int>(patch.points.size()));
            if (isNew) {
                patch.points.push_back(mesh.vertices[face[k]]);
            }
            copy[k] = at->second;
        }
    }
    if (isBehind) {
        halveChords(patch);
        for (Triangle& face : patch.faces) {
            std::swap(face[1], face[2]);
        }
    }
    return patch;
}

std::vector<Vec3> waysOff(const Patch& patch) {
    std::vector<std::vector<Vec3>> normals(patch.points.size());
    std::vector<double> lengths(patch.points.size(), 0.0);
    for (const Triangle& face : patch.faces) {
        const Vec3& p = patch.points[face[0]];
        const Vec3 normal =
            (patch.points[face[1]] - p).cross(patch.points[face[2]] - p).stableNormalized();
        for (int k = 0; k < 3; ++k) {
            normals[face[k]].push_back(normal);
            lengths[face[k]] += (patch.points[face[(k + 1) % 3]] - patch.points[face[k]]).norm();
        }
    }
    std::vector<Vec3> ways(patch.points.size(), Vec3::Zero());
    for (std::size_t i = patch.rimCount; i < ways.size(); ++i) {
        ways[i] = lengths[i] / static_cast<double>(normals[i].size()) * directionAlong(normals[i]);
    }
    return ways;
}

}  // namespace bspline_curve
