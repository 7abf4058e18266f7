// SPDX-License-Identifier: GPL-3.0-or-later
// The shell itself: tetrahedra, its boundary, its components, and the links between its prisms.
#include "shell/check/checked_shell.h"
#include "surface/self_intersection.h"
#include "utility/disjoint_sets.h"
#include "utility/infinity.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace bspline_curve {
namespace {

// Range of a prism along the x axis.
std::pair<double, double> extentOf(const CheckedShell& shell, int prism) {
    std::pair<double, double> extent(kInfinity, -kInfinity);
    for (const int pillar : shell.prism(prism).pillars) {
        for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
            const double x = shell.points.at(pillar, level).x();
            extent = {std::min(extent.first, x), std::max(extent.second, x)};
        }
    }
    return extent;
}

bool prismHolds(const CheckedShell& shell, int prism, int point) {
    for (int inPrism = 0; inPrism < kTetrahedraPerPrism; ++inPrism) {
        const int tet = kTetrahedraPerPrism * prism + inPrism;
        const std::array<int, 4> points = shell.tetPoints(tet);
        if (std::ranges::find(points, point) != points.end()) {
            continue;  // components may touch in a pillar
        }
        bool inside = true;
        for (std::size_t k = 0; k < 4 && inside; ++k) {
            std::array<int, 4> replaced = points;
            replaced[k] = point;
            inside = shell.volumeSign(replaced) * shell.handedness(tet) >= 0;
        }
        if (inside) {
            return true;
        }
    }
    return false;
}

std::pair<int, int> wallPillars(const Prism& p, int wall) {
    return std::minmax(p.pillars[(wall + 1) % 3], p.pillars[(wall + 2) % 3]);
}

// Ranks, orientation, and walls that lead there and back between the same pillars.
bool prismAgrees(const CheckedShell& shell, int i) {
    const Prism& p = shell.prism(i);
    if (p.orientation != shell.slotParity(i) || (p.orientation != 1 && p.orientation != -1) ||
        p.pillars[0] >= p.pillars[1] || p.pillars[1] >= p.pillars[2]) {
        return false;
    }
    for (int wall = 0; wall < 3; ++wall) {
        const int there = p.neighbours[wall];
        const int wallThere = p.neighbourWalls[wall];
        if (there == -1) {
            continue;
        }
        if (there < 0 || there >= shell.prismCount() || there == i || wallThere < 0 ||
            wallThere > 2 || shell.prism(there).neighbours[wallThere] != i ||
            shell.prism(there).neighbourWalls[wallThere] != wall ||
            wallPillars(p, wall) != wallPillars(shell.prism(there), wallThere)) {
            return false;
        }
    }
    return true;
}

DisjointSets componentsOf(const CheckedShell& shell) {
    DisjointSets sets(shell.prismCount());
    shell.forEachFace([&](std::span<const TetFace> equal) {
        for (const TetFace& face : equal.subspan(1)) {
            sets.unite(equal.front().prism(), face.prism());
        }
    });
    return sets;
}

// A closed part of the boundary: six times the volume that it encloses, positive where it looks
// outwards, with the sum of the sizes of its terms, and a prism of it.
struct BoundaryPart {
    double volume = 0.0, magnitude = 0.0;
    int terms = 0, prism = -1;

    // Certain, but for parts that enclose nothing.
    [[nodiscard]] bool looksOutwards() const {
        constexpr double kUlp = 0x1p-52;
        return volume > -(terms + 16) * kUlp * magnitude;
    }
};

std::map<int, BoundaryPart> boundaryParts(
    const CheckedShell& shell, const std::vector<TetFace>& boundary
) {
    DisjointSets sets(shell.points.points.size());
    for (const TetFace& face : boundary) {
        sets.unite(face.points[0], face.points[1]);
        sets.unite(face.points[0], face.points[2]);
    }
    std::map<int, BoundaryPart> parts;
    for (const TetFace& face : boundary) {
        const int first = sets.find(face.points[0]);
        const Vec3& nearby = shell.point(first);
        const Vec3 a = shell.point(face.points[0]) - nearby;
        const Vec3 b = shell.point(face.points[1]) - nearby;
        const Vec3 c = shell.point(face.points[2]) - nearby;
        const int inside = shell.tetPoints(face.tet)[face.k];
        const int side = shell.volumeSign({face.points[0], face.points[1], face.points[2], inside});
        BoundaryPart& part = parts[first];
        part.volume -= side * a.dot(b.cross(c));
        part.magnitude += a.norm() * b.norm() * c.norm();
        ++part.terms;
        part.prism = face.prism();
    }
    return parts;
}

// Two parts that look outwards lie in each other, or one would not reach the other: a bottom that
// turned inside out, whose prisms overlap there.
void checkOrientation(
    const CheckedShell& shell, const std::vector<TetFace>& boundary, Violations violations
) {
    DisjointSets components = componentsOf(shell);
    std::map<int, int> outerPrisms;
    for (const auto& [point, part] : boundaryParts(shell, boundary)) {
        if (part.looksOutwards()) {
            const auto [outer, isFirst] =
                outerPrisms.try_emplace(components.find(part.prism), part.prism);
            if (!isFirst) {
                violations.add({outer->second, part.prism});
            }
        }
    }
}

}  // namespace

void checkTetrahedra(const CheckedShell& shell, Violations violations) {
    for (int tet = 0; tet < shell.shell.tetrahedronCount(); ++tet) {
        if (shell.isPresent(tet / kTetrahedraPerPrism) &&
            shell.volumeSign(shell.tetPoints(tet)) * shell.handedness(tet) <= 0) {
            violations.add({tet});
        }
    }
}

void checkLayers(const CheckedShell& shell, Violations violations) {
    std::vector<Triangle> triangles;
    std::vector<int> prisms;
    const std::vector<TetFace> boundary = shell.boundary();
    for (const TetFace& face : boundary) {
        triangles.push_back(face.points);
        prisms.push_back(face.prism());
    }
    for (const auto& [i, j] : findSelfIntersections(shell.points.points, triangles)) {
        violations.add({prisms[i], prisms[j]});
    }
    checkOrientation(shell, boundary, violations);
}

// One point of each component's middle, top and bottom must not lie in another one: with separate
// layers these stand for all, since each closed part of the boundary is inside or outside whole.
void checkComponents(const CheckedShell& shell, Violations violations) {
    DisjointSets sets = componentsOf(shell);

    struct Query {
        double x;
        int point, component;
    };

    std::vector<Query> queries;
    for (int i = 0; i < shell.prismCount(); ++i) {
        if (shell.isPresent(i) && sets.find(i) == i) {
            for (const Level level : {Level::Bottom, Level::Middle, Level::Top}) {
                const int point = PillarPoints::indexOf(shell.prism(i).pillars[0], level);
                queries.push_back({shell.point(point).x(), point, i});
            }
        }
    }
    if (queries.size() <= PillarPoints::kLevels) {
        return;
    }
    std::set<std::pair<int, int>> found;
    std::ranges::sort(queries, {}, [](const Query& q) { return std::pair(q.x, q.point); });
    for (int i = 0; i < shell.prismCount(); ++i) {
        if (!shell.isPresent(i)) {
            continue;
        }
        const auto [low, high] = extentOf(shell, i);
        auto query = std::ranges::lower_bound(queries, low, {}, &Query::x);
        for (; query != queries.end() && query->x <= high; ++query) {
            if (query->component != sets.find(i) && prismHolds(shell, i, query->point) &&
                found.emplace(query->component, sets.find(i)).second) {
                violations.add({query->point / PillarPoints::kLevels, i});
            }
        }
    }
}

void checkNeighbours(const CheckedShell& shell, Violations violations) {
    std::vector<char> disagrees(shell.prismCount(), 0);
    for (int i = 0; i < shell.prismCount(); ++i) {
        disagrees[i] = static_cast<char>(shell.isPresent(i) && !prismAgrees(shell, i));
    }
    // Equal faces of tetrahedra are across from each other, and no others are. The walls of prisms
    // that disagree cannot be crossed.
    std::vector<char> violates = disagrees;
    shell.forEachFace([&](std::span<const TetFace> equal) {
        for (std::size_t i = 0; i < equal.size(); ++i) {
            const TetFace& face = equal[i];
            const int expected = equal.size() == 2 ? equal[1 - i].tet : -1;
            if (disagrees[face.prism()] == 0 &&
                (equal.size() > 2 || shell.shell.neighbour(face.tet, face.k) != expected)) {
                violates[face.prism()] = 1;
            }
        }
    });
    violations.addAll(violates);
}

}  // namespace bspline_curve
