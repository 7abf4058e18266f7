// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rejoining.h"

#include "surface/half_edges.h"
#include "surface/repair_steps.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// Divides edges, and the faces at them into fans. A side is a half-edge by a number that stays its
/// own, whatever becomes of its face: 3 face + k for those that there were first.
class EdgeDivider {
public:
    /// Must outlive this.
    explicit EdgeDivider(MeshRepair& mesh) : mesh_(mesh) {
        const int count = static_cast<int>(mesh.mesh.faces.size());
        for (int f = 0; f < count; ++f) {
            sidesOf_.push_back({3 * f, 3 * f + 1, 3 * f + 2});
            for (int k = 0; k < 3; ++k) {
                places_.emplace_back(f, k);
            }
        }
    }

    /// Where an edge is divided: shares of its length, ascending, and vertices.
    struct Divisions {
        int from;
        std::vector<double> shares;
        std::vector<int> vertices;
    };

    [[nodiscard]] Divisions addVertices(int from, int to, std::vector<double> shares) {
        Divisions divisions{from, std::move(shares), {}};
        for (const double share : divisions.shares) {
            const Vec3 position =
                (1.0 - share) * mesh_.mesh.vertices[from] + share * mesh_.mesh.vertices[to];
            divisions.vertices.push_back(static_cast<int>(mesh_.mesh.vertices.size()));
            mesh_.mesh.vertices.push_back(position);
        }
        return divisions;
    }

    /// Divides a side of the edge. Returns its parts in the order of the divisions.
    std::vector<int> divide(int side, Divisions where) {
        auto& [from, shares, at] = where;
        const auto [face, k] = places_[side];
        const Triangle corners = mesh_.mesh.faces[face];
        const bool isReversed = corners[(k + 1) % 3] != from;
        if (isReversed) {
            std::ranges::reverse(at);
            std::ranges::reverse(shares);
            std::ranges::transform(shares, shares.begin(), [](double share) {
                return 1.0 - share;
            });
        }
        shares.insert(shares.begin(), 0.0);
        shares.push_back(1.0);
        const Vec3 apex = originOf(face, k);
        const Vec3 begin = originOf(face, (k + 1) % 3);
        const Vec3 end = originOf(face, (k + 2) % 3);
        const std::array<int, 3> sides = sidesOf_[face];
        at.insert(at.begin(), corners[(k + 1) % 3]);
        at.push_back(corners[(k + 2) % 3]);
        const auto count = static_cast<int>(at.size()) - 1;
        std::vector<int> parts;
        for (int i = 0; i < count; ++i) {
            const int part = i == 0 ? face : addFace(mesh_.faceOrigins[face]);
            mesh_.mesh.faces[part] = {corners[k], at[i], at[i + 1]};
            Eigen::Matrix3d& here = mesh_.changedCorners[part];
            here.col(0) = apex;
            here.col(1) = begin + shares[i] * (end - begin);
            here.col(2) = begin + shares[i + 1] * (end - begin);
            parts.push_back(static_cast<int>(places_.size()));
            places_.emplace_back(part, 0);
            sidesOf_[part] = {parts.back(), kInner, kInner};
        }
        setSide(places_[parts.front()].first, 2, sides[(k + 2) % 3]);
        setSide(places_[parts.back()].first, 1, sides[(k + 1) % 3]);
        if (isReversed) {
            std::ranges::reverse(parts);
        }
        return parts;
    }

    [[nodiscard]] int faceOf(int side) const { return places_[side].first; }

private:
    static constexpr int kInner = -1;

    // A corner in barycentric coordinates of the face that it comes from.
    [[nodiscard]] Vec3 originOf(int face, int k) const {
        return mesh_.toOrigin({face, Vec3::Unit(k)}).barycentric;
    }

    int addFace(int origin) {
        mesh_.mesh.faces.emplace_back();
        mesh_.faceOrigins.push_back(origin);
        sidesOf_.push_back({kInner, kInner, kInner});
        return static_cast<int>(sidesOf_.size()) - 1;
    }

    void setSide(int face, int k, int side) {
        sidesOf_[face][k] = side;
        if (side != kInner) {
            places_[side] = {face, k};
        }
    }

    MeshRepair& mesh_;
    std::vector<std::array<int, 3>> sidesOf_;  // of faces
    std::vector<std::pair<int, int>> places_;  // of sides: face and k
};

/// Where stretches of an edge and their halves end: of each passage, and around it, where ways need
/// less room.
std::vector<double> sharesFor(std::size_t passages) {
    constexpr double kOfPassage = 4.0;  // relative to a stretch between
    std::vector<double> ends = {0.5, 1.0};
    for (std::size_t i = 0; i < passages; ++i) {
        for (const double half : {0.5 * kOfPassage, 0.5 * kOfPassage, 0.5, 0.5}) {
            ends.push_back(ends.back() + half);
        }
    }
    const double all = ends.back();
    ends.pop_back();
    for (double& end : ends) {
        end /= all;
    }
    return ends;
}

/// Divides all edges of more than two faces: each passage has a stretch, between two that it leaves
/// to other pairs. A stretch has two parts: the faces that are not joined there get a vertex of
/// their own between them, though they may be joined to the others at both ends. Returns the
/// passages between the divided faces.
std::vector<Passage> divideCrowdedEdges(MeshRepair& mesh, const std::vector<Passage>& passages) {
    EdgeDivider divider(mesh);
    std::vector<std::pair<int, int>> sidesOfPassages;
    forEachEdge(sortedHalfEdges(mesh.mesh.faces), [&](std::span<const HalfEdge> edge) {
        if (edge.size() <= 2) {
            return;
        }
        const std::vector<Passage> here = passagesAt(edge, passages);
        const EdgeDivider::Divisions at =
            divider.addVertices(edge.front().low, edge.front().high, sharesFor(here.size()));
        std::vector<std::vector<int>> sides;
        for (const HalfEdge& halfEdge : edge) {
            sides.push_back(divider.divide(3 * halfEdge.face + halfEdge.k, at));
        }
        const auto sideAt = [&](int face, std::size_t part) {
            const auto found = std::ranges::find(edge, face, &HalfEdge::face);
            return sides[found - edge.begin()][part];
        };
        for (std::size_t i = 0; i < here.size(); ++i) {
            const auto [a, b] = here[i];
            for (const std::size_t part : {4 * i + 2, 4 * i + 3}) {
                sidesOfPassages.emplace_back(sideAt(a, part), sideAt(b, part));
            }
        }
    });
    std::vector<Passage> divided;
    for (const auto& [a, b] : sidesOfPassages) {
        divided.emplace_back(std::minmax(divider.faceOf(a), divider.faceOf(b)));
    }
    std::ranges::sort(divided);
    return divided;
}

}  // namespace

MeshRepair rejoined(
    const TriangleMesh& mended,
    const std::vector<int>& vertexOrigins,
    const std::vector<Passage>& passages
) {
    MeshRepair again;
    again.mesh = {.vertices = mended.vertices, .faces = facesBeforeParting(mended, vertexOrigins)};
    for (std::size_t f = 0; f < mended.faces.size(); ++f) {
        again.faceOrigins.push_back(static_cast<int>(f));
    }
    const std::vector<Passage> divided = divideCrowdedEdges(again, passages);
    repair_steps::Joints joints = repair_steps::joinAndOrient(again, divided);
    repair_steps::splitVertices(again, std::move(joints), divided);
    again.vertexOrigins.clear();
    return again;
}

}  // namespace bspline_curve
