// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces belong to one sheet, which way it looks, and where sheets are parted.
#include "surface/half_edges.h"
#include "surface/mesh_checks.h"
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
    explicit Joiner(MeshRepair& repair)
        : repair_(repair),
          faces_(repair.mesh.faces),
          patches_(faces_.size()),
          joints_(faces_.size(), Triangle{-1, -1, -1}),
          halfEdges_(sortedHalfEdges(faces_)) {}

    Joints run(const std::vector<Passage>& passages, const std::vector<Seam>& seams) {
        for (const auto& [a, b] : passages) {
            const HalfEdge atA = sideTowards(a, b);
            const HalfEdge atB = sideTowards(b, a);
            joinIfFree(atA, atB, areParallel(faces_, atA, atB));
        }
        joinPlainEdges(passages);
        joinSeams(seams);
        forEachEdge(halfEdges_, [&](std::span<const HalfEdge> edge) {
            if (edge.size() > 2) {
                joinCrowdedEdge(edge);
            }
        });
        orient();
        return std::move(joints_);
    }

private:
    void link(const HalfEdge& a, const HalfEdge& b) {
        joints_[a.face][a.k] = b.face;
        joints_[b.face][b.k] = a.face;
    }

    /// The half-edge of a face that it has in common with another one.
    [[nodiscard]] HalfEdge sideTowards(int face, int other) const {
        int k = 0;
        while (k < 2 && cornerOf(faces_[other], faces_[face][k]) >= 0) {
            ++k;
        }
        return {.low = -1, .high = -1, .face = face, .k = k};
    }

    /// A one-sided surface is cut open where the sides disagree. Round a vertex that is surrounded
    /// by faces they do so at an even number of edges, so the cut ends only at boundaries. Faces
    /// are joined from the passages outwards, so that cuts are far from these.
    void joinPlainEdges(const std::vector<Passage>& passages) {
        std::vector<int> across(3 * faces_.size(), -1);  // of half-edges 3 face + k
        forEachEdge(halfEdges_, [&](std::span<const HalfEdge> edge) {
            if (edge.size() == 2) {
                across[3 * edge[0].face + edge[0].k] = 3 * edge[1].face + edge[1].k;
                across[3 * edge[1].face + edge[1].k] = 3 * edge[0].face + edge[0].k;
            }
        });
        std::vector<char> isReached(faces_.size(), 0);
        std::vector<int> reached;
        const auto reach = [&](int face) {
            if (isReached[face] == 0) {
                isReached[face] = 1;
                reached.push_back(face);
            }
        };
        std::size_t next = 0;
        const auto spread = [&] {
            for (; next < reached.size(); ++next) {
                const int face = reached[next];
                for (int k = 0; k < 3; ++k) {
                    if (const int there = across[3 * face + k]; there >= 0) {
                        joinPlain({-1, -1, face, k}, {-1, -1, there / 3, there % 3});
                        reach(there / 3);
                    }
                }
            }
        };
        for (const auto& [a, b] : passages) {
            reach(a);
            reach(b);
        }
        spread();
        for (int face = 0; face < static_cast<int>(faces_.size()); ++face) {
            reach(face);
            spread();
        }
    }

    void joinPlain(const HalfEdge& a, const HalfEdge& b) {
        if (joints_[a.face][a.k] >= 0) {
            return;
        }
        if (patches_.join(a.face, b.face, areParallel(faces_, a, b))) {
            link(a, b);
        } else {
            repair_.isOneSided = true;
            const Triangle& face = faces_[a.face];
            const auto [low, high] = std::minmax(face[(a.k + 1) % 3], face[(a.k + 2) % 3]);
            repair_.report.cutEdges.push_back({low, high});
        }
    }

    void joinSeams(const std::vector<Seam>& seams) {
        const std::size_t count = seams.empty() ? 0 : repair_.mesh.vertices.size();
        DisjointSets roots(count);
        DisjointSets closed(repair_.removedEdges.empty() ? 0 : count);
        bool isAnyClosed = false;
        for (const auto& [a, b, isParallel] : seams) {
            if (!patches_.join(a.face, b.face, isParallel)) {
                repair_.isOneSided = true;
                continue;
            }
            link(a, b);
            const auto end = [&](const HalfEdge& h, int i) {
                return faces_[h.face][(h.k + i) % 3];
            };
            const auto unite = [&](DisjointSets& sets) {
                sets.unite(end(a, 1), end(b, isParallel ? 1 : 2));
                sets.unite(end(a, 2), end(b, isParallel ? 2 : 1));
            };
            unite(roots);
            if (wasClosed(a) && wasClosed(b)) {
                isAnyClosed = true;
                unite(closed);
            }
            repair_.report.joinedEdges.push_back({{{a.low, a.high}, {b.low, b.high}}});
        }
        if (!repair_.report.joinedEdges.empty()) {
            repair_.seamRoots = std::move(roots).lowest();
        }
        if (isAnyClosed) {
            repair_.closedSeamRoots = std::move(closed).lowest();
        }
    }

    /// Whether a face without area was at a boundary edge.
    [[nodiscard]] bool wasClosed(const HalfEdge& h) const {
        return std::ranges::binary_search(repair_.removedEdges, std::array{h.low, h.high});
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
    std::vector<Triangle>& faces_;
    Patches patches_;
    Joints joints_;
    std::vector<HalfEdge> halfEdges_;
};

/// Gives the fans around each vertex vertices of their own.
class Splitter {
public:
    Splitter(MeshRepair& repair, Joints joints, Crowded crowded, std::vector<Passage> passages)
        : repair_(repair),
          crowded_(crowded),
          passages_(std::move(passages)),
          faces_(repair.mesh.faces),
          joints_(std::move(joints)) {
        sortUnique(passages_);
        if (!repair.seamRoots.empty()) {
            given_ = faces_;
            for (Triangle& face : faces_) {
                for (int& v : face) {
                    v = repair.seamRoots[v];
                }
            }
        }
    }

    void run() {
        // An edge can stay crowded where both of its ends are held together by faces around them;
        // what is done to all but two of its faces may make further ones crowded.
        std::vector<Triangle> split = splitFaces();
        while (clearCrowdedEdges(split)) {
            split = splitFaces();
        }
        takeOver(split);
    }

private:
    [[nodiscard]] const std::vector<Triangle>& given() const {
        return given_.empty() ? faces_ : given_;
    }

    [[nodiscard]] int vertexAt(int corner) const { return given()[corner / 3][corner % 3]; }

    /// Of corners, 3 face + k: those around a vertex whose faces are joined.
    [[nodiscard]] DisjointSets fansOfCorners() const {
        const int cornerCount = static_cast<int>(3 * faces_.size());
        DisjointSets fans(cornerCount);
        for (int corner = 0; corner < cornerCount; ++corner) {
            // The edges at a corner lie opposite to the two others.
            for (int end = 1; end < 3; ++end) {
                const int neighbour = joints_[corner / 3][(corner + end) % 3];
                if (neighbour >= 0) {
                    const int vertex = faces_[corner / 3][corner % 3];
                    fans.unite(corner, 3 * neighbour + cornerOf(faces_[neighbour], vertex));
                }
            }
        }
        return fans;
    }

    /// The faces with vertices so numbered that each fan has one of its own.
    std::vector<Triangle> splitFaces() {
        DisjointSets fans = fansOfCorners();
        const int cornerCount = static_cast<int>(3 * faces_.size());
        // The largest fan at each vertex keeps it, of equal ones the first.
        std::vector<int> sizes(cornerCount, 0);
        for (int corner = 0; corner < cornerCount; ++corner) {
            ++sizes[fans.find(corner)];
        }
        keepers_.assign(repair_.mesh.vertices.size(), -1);
        for (int corner = 0; corner < cornerCount; ++corner) {
            int& kept = keepers_[vertexAt(corner)];
            const int fan = fans.find(corner);
            kept = kept < 0 || sizes[fan] > sizes[kept] ? fan : kept;
        }
        // A fan keeps the lowest of its vertices, joined along seams, that it can.
        ids_.assign(cornerCount, -1);
        for (int v = static_cast<int>(keepers_.size()) - 1; v >= 0; --v) {
            if (keepers_[v] >= 0) {
                ids_[keepers_[v]] = v;
            }
        }
        std::vector<std::pair<int, int>> others;  // their first vertices and corners
        for (int corner = 0; corner < cornerCount; ++corner) {
            if (sizes[corner] > 0 && ids_[corner] < 0) {
                others.emplace_back(vertexAt(corner), corner);
            }
        }
        std::ranges::sort(others);
        copies_.clear();
        for (const auto& [vertex, corner] : others) {
            ids_[corner] = static_cast<int>(repair_.mesh.vertices.size() + copies_.size());
            copies_.push_back(vertex);
        }
        std::vector<Triangle> split = faces_;
        for (int corner = 0; corner < cornerCount; ++corner) {
            split[corner / 3][corner % 3] = ids_[fans.find(corner)];
        }
        return split;
    }

    /// Returns whether there were any.
    bool clearCrowdedEdges(const std::vector<Triangle>& split) {
        bool hasCleared = false;
        isDivided_.assign(split.size(), 0);
        forEachEdge(sortedHalfEdges(split), [&](std::span<const HalfEdge> edge) {
            if (edge.size() == 1 || (edge.size() == 2 && !areParallel(split, edge[0], edge[1]))) {
                return;
            }
            hasCleared = true;
            const HalfEdge& kept = keptAt(edge);
            const int keptPartner = joints_[kept.face][kept.k];
            std::vector<HalfEdge> tooShort;
            for (const HalfEdge& halfEdge : edge) {
                const bool isKept = halfEdge.face == kept.face || halfEdge.face == keptPartner;
                if (!isKept && (crowded_ == Crowded::CutOut || !divide(halfEdge))) {
                    tooShort.push_back(halfEdge);
                }
            }
            cutOut(split, tooShort);
        });
        return hasCleared;
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

    /// Gives a face, and the one that it is joined to there, a vertex between the ends of a
    /// half-edge; waits for the next round where one of them was divided in this one. Returns
    /// whether the edge is long enough.
    bool divide(const HalfEdge& at) {
        const int other = joints_[at.face][at.k];
        if (isDivided_[at.face] != 0 || (other >= 0 && isDivided_[other] != 0)) {
            return true;
        }
        const auto side =
            other < 0 ? 0 : std::ranges::find(joints_[other], at.face) - joints_[other].begin();
        const auto there = static_cast<int>(side);
        const Triangle& face = faces_[at.face];
        const Vec3 from = repair_.mesh.vertices[face[(at.k + 1) % 3]];
        const Vec3 to = repair_.mesh.vertices[face[(at.k + 2) % 3]];
        const Vec3 middle = 0.5 * (from + to);
        const auto areParts = [&](int f, int k) {
            const Vec3& apex = repair_.mesh.vertices[faces_[f][k]];
            return hasArea(apex, from, middle) && hasArea(apex, middle, to);
        };
        if (!areParts(at.face, at.k) || (other >= 0 && !areParts(other, there))) {
            return false;
        }
        const auto vertex = static_cast<int>(repair_.mesh.vertices.size());
        repair_.mesh.vertices.push_back(middle);
        const int part = divideJoined(at.face, at.k, vertex);
        if (other >= 0) {
            // Which leads the other way.
            const int partThere = divideJoined(other, there, vertex);
            link(at.face, at.k, partThere, there);
            link(part, at.k, other, there);
        }
        return true;
    }

    int divideJoined(int face, int k, int vertex) {
        const int part = divideFace(repair_, face, k, vertex, 0.5);
        joints_.push_back(joints_[face]);
        const int last = (k + 1) % 3;
        if (const int neighbour = joints_[face][last]; neighbour >= 0) {
            std::ranges::replace(joints_[neighbour], face, part);
        }
        link(face, last, part, (k + 2) % 3);
        isDivided_[face] = 1;
        isDivided_.push_back(1);
        return part;
    }

    void link(int a, int k, int b, int there) {
        joints_[a][k] = b;
        joints_[b][there] = a;
    }

    /// Parts faces at an edge from their neighbours at one of its ends, where that cuts less, so
    /// that they get a vertex of their own there with those that they are joined to at the edge.
    void cutOut(const std::vector<Triangle>& split, std::span<const HalfEdge> edge) {
        const auto sideAt = [&](const HalfEdge& h, bool isHigh) {
            const bool isFirst = split[h.face][(h.k + 1) % 3] == (isHigh ? h.high : h.low);
            return (h.k + (isFirst ? 2 : 1)) % 3;
        };
        const auto cutsAt = [&](bool isHigh) {
            return std::ranges::count_if(edge, [&](const HalfEdge& h) {
                return joints_[h.face][sideAt(h, isHigh)] >= 0;
            });
        };
        const bool isHigh = cutsAt(true) < cutsAt(false);
        for (const HalfEdge& h : edge) {
            const int k = sideAt(h, isHigh);
            int& neighbour = joints_[h.face][k];
            if (neighbour >= 0) {
                std::ranges::replace(joints_[neighbour], h.face, -1);
                neighbour = -1;
                const Triangle& face = given()[h.face];
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
        for (int v = 0; v < static_cast<int>(keepers_.size()); ++v) {
            if (keepers_[v] >= 0 && ids_[keepers_[v]] != v) {
                repair_.report.joinedVertices.emplace_back(v, ids_[keepers_[v]]);
            }
        }
        repair_.mesh.faces = split;
        keepUnjoined();
    }

    /// Seams that were closed in the given mesh stay joined.
    void keepUnjoined() {
        const std::vector<int>& closed = repair_.closedSeamRoots;
        bool isAnyOpen = false;
        for (std::size_t f = 0; f < given_.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                int& own = given_[f][k];
                const int joined = repair_.vertexOrigins[repair_.mesh.faces[f][k]];
                if (!closed.empty()) {
                    own = closed[own] == closed[joined] ? joined : closed[own];
                }
                isAnyOpen = isAnyOpen || own != joined;
            }
        }
        if (isAnyOpen) {
            repair_.cornerOrigins = std::move(given_);
        }
    }

    MeshRepair& repair_;
    Crowded crowded_;
    std::vector<Passage> passages_;  // ascending
    std::vector<Triangle>& faces_;   // where there are seams, of their roots
    std::vector<Triangle> given_;    // there, the faces before that; else empty
    Joints joints_;
    std::vector<char> isDivided_;  // in this round
    std::vector<int> keepers_;     // of vertices: the first corner of the fan that has it, or -1
    std::vector<int> ids_;         // of fans, by first corner
    std::vector<int> copies_;      // the vertex behind each new one
};

}  // namespace

Joints joinAndOrient(
    MeshRepair& repair, const std::vector<Passage>& passages, const std::vector<Seam>& seams
) {
    return Joiner(repair).run(passages, seams);
}

void splitVertices(
    MeshRepair& repair, Joints joints, Crowded crowded, std::vector<Passage> passages
) {
    Splitter(repair, std::move(joints), crowded, std::move(passages)).run();
    sortUnique(repair.report.cutEdges);
}

}  // namespace bspline_curve::repair_steps
