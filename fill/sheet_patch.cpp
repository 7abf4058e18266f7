// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/sheet_patch.h"

#include "fill/inner_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// For each face the face across the side opposite to each corner; -1: none, or several.
std::vector<Triangle> facesBeside(const std::vector<Triangle>& faces) {
    Triangle none;
    none.fill(-1);
    std::vector<Triangle> beside(faces.size(), none);
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 2) {
            beside[sides[0].face][sides[0].k] = sides[1].face;
            beside[sides[1].face][sides[1].k] = sides[0].face;
        }
    });
    return beside;
}

using DirectedEdges = std::set<std::pair<int, int>>;

/// The faces that are joined to those on some directed sides, without crossing these.
std::vector<Triangle> facesJoinedTo(const std::vector<Triangle>& faces, const DirectedEdges& rim) {
    const std::vector<Triangle> beside = facesBeside(faces);
    const auto isOnRim = [&](int f, int k) {
        return rim.contains({faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]});
    };
    std::vector<char> isFound(faces.size(), 0);
    std::vector<int> found;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto face = static_cast<int>(f);
        if (isOnRim(face, 0) || isOnRim(face, 1) || isOnRim(face, 2)) {
            isFound[f] = 1;
            found.push_back(face);
        }
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const int face = found[i];
        for (int k = 0; k < 3; ++k) {
            const int other = isOnRim(face, k) ? -1 : beside[face][k];
            if (other >= 0 && isFound[other] == 0) {
                isFound[other] = 1;
                found.push_back(other);
            }
        }
    }
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
            if (changed.take(edge)) {
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
/// that are farthest from it are added, in turn.
Vec3 directionAlong(const std::vector<Vec3>& normals) {
    constexpr int kTurns = 50;
    constexpr double kShare = 0.2;
    Vec3 direction = Vec3::Zero();
    for (const Vec3& normal : normals) {
        direction += normal;
    }
    direction.stableNormalize();
    for (int turn = 0; turn < kTurns; ++turn) {
        const auto farthest =
            std::ranges::min_element(normals, {}, [&](const Vec3& n) { return n.dot(direction); });
        direction = (direction + kShare / (1.0 + 0.2 * turn) * *farthest).stableNormalized();
    }
    return direction;
}

void measure(Sheet& sheet) {
    Patch& patch = sheet.patch;
    std::vector<std::vector<Vec3>> normals(patch.points.size());
    patch.sizes.assign(patch.points.size(), 0.0);
    for (const Triangle& face : patch.faces) {
        const Vec3& p = patch.points[face[0]];
        const Vec3 normal =
            (patch.points[face[1]] - p).cross(patch.points[face[2]] - p).stableNormalized();
        for (int k = 0; k < 3; ++k) {
            normals[face[k]].push_back(normal);
            patch.sizes[face[k]] +=
                (patch.points[face[(k + 1) % 3]] - patch.points[face[k]]).norm();
        }
    }
    sheet.normals.assign(patch.points.size(), Vec3::Zero());
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        patch.sizes[i] /= static_cast<double>(normals[i].size());
        if (!patch.isOnRim(static_cast<int>(i))) {
            sheet.normals[i] = directionAlong(normals[i]);
        }
    }
}

}  // namespace

std::optional<Sheet> sheetBeside(
    const TriangleMesh& mesh, const std::vector<int>& rim, bool isBehind
) {
    DirectedEdges sides;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const int from = rim[i];
        const int to = rim[(i + 1) % rim.size()];
        sides.insert(isBehind ? std::pair{to, from} : std::pair{from, to});
    }
    const std::vector<Triangle> faces = facesJoinedTo(mesh.faces, sides);
    if (faces.empty() || !isDisc(faces, sides)) {
        return std::nullopt;
    }
    Sheet sheet;
    std::map<int, int> pointOf;
    for (const int vertex : rim) {
        pointOf.emplace(vertex, static_cast<int>(sheet.patch.points.size()));
        sheet.patch.points.push_back(mesh.vertices[vertex]);
    }
    sheet.patch.rimCount = static_cast<int>(rim.size());
    for (const Triangle& face : faces) {
        Triangle& copy = sheet.patch.faces.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const auto [at, isNew] =
                pointOf.emplace(face[k], static_cast<int>(sheet.patch.points.size()));
            if (isNew) {
                sheet.patch.points.push_back(mesh.vertices[face[k]]);
            }
            copy[k] = at->second;
        }
    }
    if (isBehind) {
        halveChords(sheet.patch);
    }
    measure(sheet);
    if (isBehind) {
        for (Triangle& face : sheet.patch.faces) {
            std::swap(face[1], face[2]);
        }
    }
    return sheet;
}

}  // namespace bspline_curve
