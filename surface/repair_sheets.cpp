// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces belong to one sheet, which way it looks, and where sheets are parted.
#include "surface/half_edges.h"
#include "surface/repair_steps.h"
#include "surface/surface_point.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <span>
#include <utility>

namespace bspline_curve::repair_steps {

namespace {

/// Faces that are joined into patches, with the side that each looks to.
class Patches {
public:
    explicit Patches(std::size_t faces) : sets_(2 * faces) {}

    struct Place {
        int root;       ///< the lowest face of the patch
        bool isTurned;  ///< against the root
    };

    [[nodiscard]] Place find(int face) {
        const int lowest = sets_.find(2 * face);
        return {lowest / 2, lowest % 2 != 0};
    }

    /// Joins two faces, `areOpposed`: only one of them must be turned. Returns whether the faces
    /// joined so far allow it.
    bool join(int a, int b, bool areOpposed) {
        const int same = 2 * b + static_cast<int>(areOpposed);
        const int other = 2 * b + static_cast<int>(!areOpposed);
        if (sets_.find(2 * a) == sets_.find(other)) {
            return false;
        }
        sets_.unite(2 * a, same);
        sets_.unite(2 * a + 1, other);
        return true;
    }

private:
    DisjointSets sets_;  // of 2 f, face f as it is, and 2 f + 1, the face turned over
};

/// Two faces that could go on into each other at an edge.
struct Pairing {
    bool areOpposed;
    double bend;  ///< 1 - cosine between the normals; 0 where flat
    HalfEdge a, b;
    auto operator<=>(const Pairing&) const = default;
};

class Joiner {
public:
    Joiner(MeshRepair& repair, const std::vector<Passage>& passages)
        : repair_(repair),
          passages_(passages),
          faces_(repair.mesh.faces),
          patches_(faces_.size()),
          joints_(faces_.size(), Triangle{-1, -1, -1}),
          halfEdges_(sortedHalfEdges(faces_)) {}

    Joints run() {
        joinPlainEdges();
        if (!passages_.empty()) {
            forEachCrowdedEdge([&](std::span<const HalfEdge> edge) { joinPassages(edge); });
        }
        forEachCrowdedEdge([&](std::span<const HalfEdge> edge) { joinCrowdedEdge(edge); });
        orient();
        return std::move(joints_);
    }

private:
    template <class Visitor>
    void forEachCrowdedEdge(const Visitor& visit) const {
        forEachEdge(halfEdges_, [&](std::span<const HalfEdge> edge) {
            if (edge.size() > 2) {
                visit(edge);
            }
        });
    }

    void link(const HalfEdge& a, const HalfEdge& b) {
        joints_[a.face][a.k] = b.face;
        joints_[b.face][b.k] = a.face;
    }

    /// A one-sided surface is cut open where the sides disagree. Round a vertex that is surrounded
    /// by faces they do so at an even number of edges, so the cut ends only at boundaries.
    void joinPlainEdges() {
        forEachEdge(halfEdges_, [&](std::span<const HalfEdge> edge) {
            if (edge.size() != 2) {
                return;
            }
            const bool areOpposed = areParallel(faces_, edge[0], edge[1]);
            if (patches_.join(edge[0].face, edge[1].face, areOpposed)) {
                link(edge[0], edge[1]);
            } else {
                repair_.report.cutEdges.push_back({edge[0].low, edge[0].high});
            }
        });
    }

    void joinPassages(std::span<const HalfEdge> edge) {
        for (const auto& [low, high] : passagesAt(edge, passages_)) {
            const HalfEdge& a = *std::ranges::find(edge, low, &HalfEdge::face);
            const HalfEdge& b = *std::ranges::find(edge, high, &HalfEdge::face);
            joinIfFree(a, b, areParallel(faces_, a, b));
        }
    }

    void joinIfFree(const HalfEdge& a, const HalfEdge& b, bool areOpposed) {
        const bool areFree = joints_[a.face][a.k] < 0 && joints_[b.face][b.k] < 0;
        if (areFree && patches_.join(a.face, b.face, areOpposed)) {
            link(a, b);
        }
    }

    [[nodiscard]] Vec3 normal(int face) const {
        const Triangle& corners = faces_[face];
        const std::vector<Vec3>& vertices = repair_.mesh.vertices;
        const Vec3 ab = (vertices[corners[1]] - vertices[corners[0]]).normalized();
        const Vec3 ac = (vertices[corners[2]] - vertices[corners[0]]).normalized();
        return ab.cross(ac).normalized();
    }

    /// Lets the pairs of faces that bend least go on into each other, those first that look to the
    /// same side already.
    void joinCrowdedEdge(std::span<const HalfEdge> edge) {
        // Beyond 120 degrees a sheet turns back on itself; which faces belong together is a guess.
        constexpr double kLargestBend = 1.5;
        // With so many faces every pair is a guess; keeps the work linear.
        constexpr std::size_t kMostFaces = 32;
        repair_.report.cutEdges.push_back({edge[0].low, edge[0].high});
        if (edge.size() > kMostFaces) {
            return;
        }
        std::vector<Pairing> pairings;
        for (std::size_t i = 0; i < edge.size(); ++i) {
            for (std::size_t j = i + 1; j < edge.size(); ++j) {
                const bool areOpposed = areParallel(faces_, edge[i], edge[j]);
                const double cosine = normal(edge[i].face).dot(normal(edge[j].face));
                const double bend = 1.0 - (areOpposed ? -cosine : cosine);
                if (bend <= kLargestBend) {
                    pairings.push_back({areOpposed, bend, edge[i], edge[j]});
                }
            }
        }
        std::ranges::sort(pairings);
        for (const Pairing& pair : pairings) {
            joinIfFree(pair.a, pair.b, pair.areOpposed);
        }
    }

    /// Turns the smaller part of each patch; of equal ones the part without its first face.
    void orient() {
        const int count = static_cast<int>(faces_.size());
        std::vector<int> balance(faces_.size(), 0);
        for (int f = 0; f < count; ++f) {
            const Patches::Place place = patches_.find(f);
            balance[place.root] += place.isTurned ? -1 : 1;
        }
        for (int f = 0; f < count; ++f) {
            const Patches::Place place = patches_.find(f);
            const bool isMinority = place.isTurned == (balance[place.root] >= 0);
            if (isMinority) {
                turn(f);
            }
        }
        sortUnique(repair_.report.reversedFaces);
    }

    void turn(int face) {
        std::swap(faces_[face][1], faces_[face][2]);
        std::swap(joints_[face][1], joints_[face][2]);
        const auto [corners, isNew] =
            repair_.changedCorners.try_emplace(face, Eigen::Matrix3d::Identity());
        corners->second.col(1).swap(corners->second.col(2));
        repair_.report.reversedFaces.push_back(repair_.faceOrigins[face]);
    }

    MeshRepair& repair_;
    const std::vector<Passage>& passages_;
    std::vector<Triangle>& faces_;
    Patches patches_;
    Joints joints_;
    std::vector<HalfEdge> halfEdges_;
};

/// Gives the fans around each vertex vertices of their own.
class Splitter {
public:
    Splitter(MeshRepair& repair, Joints joints, const std::vector<Passage>& passages)
        : repair_(repair),
          passages_(passages),
          faces_(repair.mesh.faces),
          joints_(std::move(joints)) {}

    void run() {
        // An edge can stay crowded where both of its ends are held together by faces around them;
        // then all but two of its faces are cut out, which may part further ones.
        std::vector<Triangle> split = splitFaces();
        while (cutCrowdedEdges(split)) {
            split = splitFaces();
        }
        takeOver(split);
    }

private:
    [[nodiscard]] int vertexAt(int corner) const { return faces_[corner / 3][corner % 3]; }

    /// The faces with vertices so numbered that each fan has one of its own.
    std::vector<Triangle> splitFaces() {
        DisjointSets fans(3 * faces_.size());  // of corners, 3 * face + k
        const int cornerCount = static_cast<int>(3 * faces_.size());
        for (int corner = 0; corner < cornerCount; ++corner) {
            // The edges at a corner lie opposite to the two others.
            for (int end = 1; end < 3; ++end) {
                const int neighbour = joints_[corner / 3][(corner + end) % 3];
                if (neighbour >= 0) {
                    const int there = cornerOf(faces_[neighbour], vertexAt(corner));
                    fans.unite(corner, 3 * neighbour + there);
                }
            }
        }
        // The largest fan at each vertex keeps it, of equal ones the first.
        std::vector<int> sizes(cornerCount, 0);
        for (int corner = 0; corner < cornerCount; ++corner) {
            ++sizes[fans.find(corner)];
        }
        std::vector<int> keeper(repair_.mesh.vertices.size(), -1);
        std::vector<std::pair<int, int>> firstCorners;  // of the fans, by vertex
        for (int corner = 0; corner < cornerCount; ++corner) {
            if (sizes[corner] > 0) {
                int& kept = keeper[vertexAt(corner)];
                kept = kept < 0 || sizes[corner] > sizes[kept] ? corner : kept;
                firstCorners.emplace_back(vertexAt(corner), corner);
            }
        }
        std::ranges::sort(firstCorners);
        std::vector<int> ids(cornerCount, -1);
        copies_.clear();
        for (const auto& [vertex, corner] : firstCorners) {
            if (keeper[vertex] == corner) {
                ids[corner] = vertex;
            } else {
                ids[corner] = static_cast<int>(repair_.mesh.vertices.size() + copies_.size());
                copies_.push_back(vertex);
            }
        }
        std::vector<Triangle> split = faces_;
        for (int corner = 0; corner < cornerCount; ++corner) {
            split[corner / 3][corner % 3] = ids[fans.find(corner)];
        }
        return split;
    }

    /// Returns whether there were any.
    bool cutCrowdedEdges(const std::vector<Triangle>& split) {
        bool hasCut = false;
        forEachEdge(sortedHalfEdges(split), [&](std::span<const HalfEdge> edge) {
            if (edge.size() == 1 || (edge.size() == 2 && !areParallel(split, edge[0], edge[1]))) {
                return;
            }
            hasCut = true;
            const HalfEdge& kept = keptAt(edge);
            const int keptPartner = joints_[kept.face][kept.k];
            for (const HalfEdge& halfEdge : edge) {
                if (halfEdge.face != kept.face && halfEdge.face != keptPartner) {
                    cutOut(halfEdge);
                }
            }
        });
        return hasCut;
    }

    /// One of the half-edges that stay: of a passage, else of two faces that are joined.
    [[nodiscard]] const HalfEdge& keptAt(std::span<const HalfEdge> edge) const {
        const auto rank = [&](const HalfEdge& halfEdge) {
            const int partner = joints_[halfEdge.face][halfEdge.k];
            const Passage pair = std::minmax(halfEdge.face, partner);
            return partner < 0 ? 2 : std::ranges::binary_search(passages_, pair) ? 0 : 1;
        };
        return *std::ranges::min_element(edge, {}, rank);
    }

    /// Parts a face from all others but the one that it is joined to at a half-edge.
    void cutOut(const HalfEdge& kept) {
        const Triangle& face = faces_[kept.face];
        for (int k = 0; k < 3; ++k) {
            int& neighbour = joints_[kept.face][k];
            if (k != kept.k && neighbour >= 0) {
                std::ranges::replace(joints_[neighbour], kept.face, -1);
                neighbour = -1;
                const auto [low, high] = std::minmax(face[(k + 1) % 3], face[(k + 2) % 3]);
                repair_.report.cutEdges.push_back({low, high});
            }
        }
    }

    void takeOver(const std::vector<Triangle>& split) {
        auto& duplicated = repair_.report.duplicatedVertices;
        for (const int vertex : copies_) {
            if (duplicated.empty() || duplicated.back().vertex != vertex) {
                duplicated.push_back({vertex, {}});
            }
            duplicated.back().copies.push_back(static_cast<int>(repair_.mesh.vertices.size()));
            const Vec3 position = repair_.mesh.vertices[vertex];
            repair_.mesh.vertices.push_back(position);
            repair_.vertexOrigins.push_back(vertex);
        }
        repair_.mesh.faces = split;
    }

    MeshRepair& repair_;
    const std::vector<Passage>& passages_;
    std::vector<Triangle>& faces_;
    Joints joints_;
    std::vector<int> copies_;  // the vertex behind each new one
};

}  // namespace

Joints joinAndOrient(MeshRepair& repair, const std::vector<Passage>& passages) {
    return Joiner(repair, passages).run();
}

void splitVertices(MeshRepair& repair, Joints joints, const std::vector<Passage>& passages) {
    Splitter(repair, std::move(joints), passages).run();
    sortUnique(repair.report.cutEdges);
}

}  // namespace bspline_curve::repair_steps
