// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check_shell.h"

#include "surface/predicates.h"
#include "surface/self_intersection.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// The points of the shell are numbered 3 * pillar + level.
enum Level : signed char { Bottom, Middle, Top };

constexpr int kLevels = 3;

// A face of a tetrahedron by its points, ascending, and where it is.
struct TetFace {
    std::array<int, 3> points;
    int tet, k;

    auto operator<=>(const TetFace&) const = default;
};

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    int find(int i) {
        while (parents_[at(i)] != i) {
            parents_[at(i)] = parents_[at(parents_[at(i)])];
            i = parents_[at(i)];
        }
        return i;
    }

    // The smallest element stands for its set.
    void unite(int i, int j) {
        const auto [low, high] = std::minmax({find(i), find(j)});
        parents_[at(high)] = low;
    }

private:
    std::vector<int> parents_;
};

class Checker {
public:
    Checker(
        const Surface& surface,
        const ShellBase& base,
        const Shell& shell,
        std::span<const int> blockedFaces,
        const ShellCheckOptions& options
    )
        : surface_(surface), base_(base), shell_(shell), blockedFaces_(blockedFaces) {
        maxIds_ = at(std::max(0, options.maxReportedIds));
        for (const Pillar& pillar : shell.pillars()) {
            points_.insert(points_.end(), {pillar.bottom, pillar.middle, pillar.top});
        }
        collectFaces();
    }

    ShellCheck run() {
        checkTetrahedra();
        checkLayers();
        checkComponents();
        checkSurface();
        checkTracking();
        checkNeighbours();
        return std::move(result_);
    }

private:
    // ---- Plain data ----

    [[nodiscard]] int prismCount() const { return static_cast<int>(shell_.prisms().size()); }

    [[nodiscard]] const Prism& prism(int i) const { return shell_.prisms()[at(i)]; }

    // A blocked face keeps its place among the prisms.
    [[nodiscard]] bool isPresent(int i) const { return prism(i).orientation != 0; }

    // The orientation of the slots, from where they stand in the face; 0 where that makes no sense.
    [[nodiscard]] static int slotParity(const Prism& p) {
        const int first = p.faceCorner[0];
        const int second = p.faceCorner[1];
        const int third = p.faceCorner[2];
        if (std::min({first, second, third}) < 0 || first + second + third != 3 ||
            first == second || second == third || first == third) {
            return 0;
        }
        return second == (first + 1) % 3 ? 1 : -1;
    }

    [[nodiscard]] std::array<int, 4> tetPoints(int tet) const {
        const Prism& p = prism(tet / kTetrahedraPerPrism);
        const int inPrism = tet % kTetrahedraPerPrism;
        const Level outer = inPrism < 3 ? Top : Bottom;
        std::array<int, 4> points{};
        for (std::size_t k = 0; k < 4; ++k) {
            const SplitVertex vertex = kSlabSplit[at(inPrism % 3)][k];
            points[k] =
                kLevels * p.pillars[at(vertex.slot)] + (vertex.outer ? outer : Level::Middle);
        }
        return points;
    }

    [[nodiscard]] TetFace faceOpposite(int tet, int k) const {
        const std::array<int, 4> points = tetPoints(tet);
        TetFace face{{}, tet, k};
        std::size_t count = 0;
        for (int j = 0; j < 4; ++j) {
            if (j != k) {
                face.points[count++] = points[at(j)];
            }
        }
        std::sort(face.points.begin(), face.points.end());
        return face;
    }

    // All faces of all tetrahedra, so that equal ones follow each other.
    void collectFaces() {
        for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
            if (isPresent(tet / kTetrahedraPerPrism)) {
                for (int k = 0; k < 4; ++k) {
                    faces_.push_back(faceOpposite(tet, k));
                }
            }
        }
        std::sort(faces_.begin(), faces_.end());
    }

    // Calls visit(first, count) for each set of equal faces.
    template <class Visitor>
    void forEachFace(const Visitor& visit) const {
        for (std::size_t first = 0; first < faces_.size();) {
            std::size_t last = first + 1;
            while (last < faces_.size() && faces_[last].points == faces_[first].points) {
                ++last;
            }
            visit(first, last - first);
            first = last;
        }
    }

    void violate(InvariantCheck& check, std::initializer_list<int> ids) const {
        check.holds = false;
        ++check.violations;
        for (const int id : ids) {
            if (check.firstIds.size() < maxIds_) {
                check.firstIds.push_back(id);
            }
        }
    }

    // ---- Invariants ----

    [[nodiscard]] int volumeSign(const std::array<int, 4>& points) const {
        return orientationSign(
            points_[at(points[0])],
            points_[at(points[1])],
            points_[at(points[2])],
            points_[at(points[3])]
        );
    }

    // The order of a tetrahedron's points is right-handed where the slots run counter-clockwise
    // and it lies above the middle; each of the two turns it over.
    [[nodiscard]] int handedness(int tet) const {
        const int side = tet % kTetrahedraPerPrism < 3 ? 1 : -1;
        return side * slotParity(prism(tet / kTetrahedraPerPrism));
    }

    void checkTetrahedra() {
        for (int tet = 0; tet < shell_.tetrahedronCount(); ++tet) {
            if (isPresent(tet / kTetrahedraPerPrism) &&
                volumeSign(tetPoints(tet)) * handedness(tet) <= 0) {
                violate(result_.positiveTetrahedra, {tet});
            }
        }
    }

    void checkLayers() {
        std::vector<Triangle> triangles;
        std::vector<int> prisms;
        forEachFace([&](std::size_t first, std::size_t count) {
            if (count == 1) {
                triangles.push_back(faces_[first].points);
                prisms.push_back(faces_[first].tet / kTetrahedraPerPrism);
            }
        });
        for (const auto& [i, j] : findSelfIntersections(points_, triangles)) {
            violate(result_.separateLayers, {prisms[at(i)], prisms[at(j)]});
        }
    }

    // One point of each component must not lie in another one: with separate layers that stands
    // for all.
    void checkComponents() {
        DisjointSets sets(at(prismCount()));
        forEachFace([&](std::size_t first, std::size_t count) {
            for (std::size_t i = 1; i < count; ++i) {
                sets.unite(
                    faces_[first].tet / kTetrahedraPerPrism,
                    faces_[first + i].tet / kTetrahedraPerPrism
                );
            }
        });

        struct Query {
            double x;
            int point, component;
        };

        std::vector<Query> queries;
        for (int i = 0; i < prismCount(); ++i) {
            if (isPresent(i) && sets.find(i) == i) {
                const int point = kLevels * prism(i).pillars[0] + Middle;
                queries.push_back({points_[at(point)].x(), point, i});
            }
        }
        if (queries.size() < 2) {
            return;
        }
        std::sort(queries.begin(), queries.end(), [](const Query& a, const Query& b) {
            return std::pair(a.x, a.point) < std::pair(b.x, b.point);
        });
        for (int i = 0; i < prismCount(); ++i) {
            if (!isPresent(i)) {
                continue;
            }
            const auto [low, high] = extentOf(i);
            auto query =
                std::lower_bound(queries.begin(), queries.end(), low, [](const Query& q, double x) {
                    return q.x < x;
                });
            for (; query != queries.end() && query->x <= high; ++query) {
                if (query->component != sets.find(i) && prismHolds(i, query->point)) {
                    violate(result_.separateComponents, {query->point / kLevels, i});
                }
            }
        }
    }

    // Range of a prism along the x axis.
    [[nodiscard]] std::pair<double, double> extentOf(int i) const {
        std::pair<double, double> extent(points_[at(kLevels * prism(i).pillars[0])].x(), 0.0);
        extent.second = extent.first;
        for (const int pillar : prism(i).pillars) {
            for (int level = 0; level < kLevels; ++level) {
                const double x = points_[at(kLevels * pillar + level)].x();
                extent = {std::min(extent.first, x), std::max(extent.second, x)};
            }
        }
        return extent;
    }

    [[nodiscard]] bool prismHolds(int i, int point) const {
        for (int inPrism = 0; inPrism < kTetrahedraPerPrism; ++inPrism) {
            const int tet = kTetrahedraPerPrism * i + inPrism;
            const std::array<int, 4> points = tetPoints(tet);
            if (std::find(points.begin(), points.end(), point) != points.end()) {
                continue;  // components may touch in a pillar
            }
            bool inside = true;
            for (std::size_t k = 0; k < 4 && inside; ++k) {
                std::array<int, 4> replaced = points;
                replaced[k] = point;
                inside = volumeSign(replaced) * handedness(tet) >= 0;
            }
            if (inside) {
                return true;
            }
        }
        return false;
    }

    void checkSurface() {
        for (int f = 0; f < static_cast<int>(base_.faces.size()); ++f) {
            const bool isMiddle = f < prismCount() && isMiddleOf(f);
            if (!isMiddle || (isPresent(f) && !isTransversal(f))) {
                violate(result_.transversalSurface, {f});
            }
        }
    }

    // Whether prism f stands on face f of the base, and the face is that of the surface.
    [[nodiscard]] bool isMiddleOf(int f) const {
        const Prism& p = prism(f);
        if (slotParity(p) == 0 ||
            (f < surface_.faceCount() && base_.faces[at(f)] != surface_.faces()[at(f)])) {
            return false;
        }
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const int v = p.pillars[slot];
            if (v != base_.faces[at(f)][at(p.faceCorner[slot])] ||
                shell_.pillars()[at(v)].middle != base_.vertices[at(v)] || !isWhereItSays(v)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool isWhereItSays(int v) const {
        if (v >= surface_.vertexCount()) {
            return surface_.isBoundaryVertex(base_.surfaceVertex(v));
        }
        return base_.vertices[at(v)] == base_.frame.toUnit(surface_.vertices()[at(v)]) ||
               std::binary_search(base_.movedVertices.begin(), base_.movedVertices.end(), v);
    }

    // In each tetrahedron the fibres are parallel to the half pillar that it holds, which starts in
    // the face: the dot product with the normal has the sign of a volume.
    [[nodiscard]] bool isTransversal(int f) const {
        const Triangle& face = base_.faces[at(f)];
        const auto side = [&](const Vec3& tip) {
            return orientationSign(
                base_.vertices[at(face[0])],
                base_.vertices[at(face[1])],
                base_.vertices[at(face[2])],
                tip
            );
        };
        return std::all_of(face.begin(), face.end(), [&](int v) {
            const Pillar& pillar = shell_.pillars()[at(v)];
            return side(pillar.top) > 0 && side(pillar.bottom) < 0;
        });
    }

    void checkTracking() {
        std::vector<char> isListed(at(prismCount()), 0);
        int previous = -1;
        for (const int f : blockedFaces_) {
            if (f <= previous || f >= surface_.faceCount() || f >= prismCount()) {
                violate(result_.completeTracking, {f});
            } else {
                isListed[at(f)] = 1;
            }
            previous = std::max(previous, f);
        }
        for (int f = 0; f < surface_.faceCount(); ++f) {
            if (f >= prismCount() || shell_.isGhost(f) || isPresent(f) == (isListed[at(f)] != 0)) {
                violate(result_.completeTracking, {f});
            }
        }
        for (int i = 0; i < prismCount(); ++i) {
            for (const int there : prism(i).neighbours) {
                const bool isBlocked = !isPresent(i);
                const bool leadsToBlocked = there >= 0 && there < prismCount() && !isPresent(there);
                if ((isBlocked && there >= 0) || leadsToBlocked) {
                    violate(result_.completeTracking, {isBlocked ? i : there});
                }
            }
        }
    }

    void checkNeighbours() {
        std::vector<char> agrees(at(prismCount()), 1);
        for (int i = 0; i < prismCount(); ++i) {
            agrees[at(i)] = static_cast<char>(!isPresent(i) || prismAgrees(i));
        }
        // Equal faces of tetrahedra are across from each other, and no others are.
        std::vector<char> meets = agrees;
        forEachFace([&](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i < first + count; ++i) {
                const TetFace& face = faces_[i];
                const int owner = face.tet / kTetrahedraPerPrism;
                if (agrees[at(owner)] == 0) {
                    continue;  // its walls cannot be crossed
                }
                const int expected = count == 2 ? faces_[first + (i == first ? 1 : 0)].tet : -1;
                if (count > 2 || shell_.neighbour(face.tet, face.k) != expected) {
                    meets[at(owner)] = 0;
                }
            }
        });
        for (int i = 0; i < prismCount(); ++i) {
            if (meets[at(i)] == 0) {
                violate(result_.consistentNeighbours, {i});
            }
        }
    }

    // Ranks, orientation, and walls that lead there and back between the same pillars.
    [[nodiscard]] bool prismAgrees(int i) const {
        const Prism& p = prism(i);
        if (p.orientation != slotParity(p) || p.pillars[0] >= p.pillars[1] ||
            p.pillars[1] >= p.pillars[2]) {
            return false;
        }
        for (int wall = 0; wall < 3; ++wall) {
            const int there = p.neighbours[at(wall)];
            const int wallThere = p.neighbourWalls[at(wall)];
            if (there == -1) {
                continue;
            }
            if (there < 0 || there >= prismCount() || there == i || wallThere < 0 ||
                wallThere > 2 || prism(there).neighbours[at(wallThere)] != i ||
                prism(there).neighbourWalls[at(wallThere)] != wall ||
                wallPillars(p, wall) != wallPillars(prism(there), wallThere)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] static std::pair<int, int> wallPillars(const Prism& p, int wall) {
        return std::minmax(p.pillars[at((wall + 1) % 3)], p.pillars[at((wall + 2) % 3)]);
    }

    const Surface& surface_;
    const ShellBase& base_;
    const Shell& shell_;
    std::span<const int> blockedFaces_;
    std::size_t maxIds_ = 0;
    std::vector<Vec3> points_;
    std::vector<TetFace> faces_;
    ShellCheck result_;
};

}  // namespace

bool ShellCheck::passed() const {
    const auto all = invariants();
    return std::all_of(all.begin(), all.end(), [](const InvariantCheck* invariant) {
        return invariant->holds;
    });
}

ShellCheck checkShell(
    const Surface& surface,
    const ShellBase& base,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options
) {
    return Checker(surface, base, shell, blockedFaces, options).run();
}

}  // namespace bspline_curve
