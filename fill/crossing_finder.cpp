// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/crossing_finder.h"

#include "surface/self_intersection.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace bspline_curve {

namespace {

// Least heights of triangles in single precision, relative to their largest coordinate: 8 ulps,
// below which rounding may turn a triangle over, and 1.
constexpr double kSliverHeight = 0x1p-20;
constexpr double kLeastHeight = 0x1p-23;

}  // namespace

std::vector<int> Crossings::faces() const {
    std::vector<int> all = withKept;
    for (const auto& [one, other] : pairs) {
        all.push_back(one);
        all.push_back(other);
    }
    sortUnique(all);
    return all;
}

CrossingFinder::CrossingFinder(
    const std::vector<Vec3>& vertices, const std::vector<Triangle>& kept, bool isRounded
)
    : vertices_(vertices), isRounded_(isRounded) {
    keep(kept);
}

void CrossingFinder::keep(const std::vector<Triangle>& faces) {
    std::vector<Triangle> kept;
    std::ranges::copy_if(faces, std::back_inserter(kept), [&](const Triangle& face) {
        return !isRounded_ || !isSliver(face);
    });
    kept_.push_back(std::make_unique<const Kept>(vertices_, std::move(kept)));
}

bool CrossingFinder::isBroad(const Triangle& face, double leastHeight) const {
    const Vec3& a = vertices_[face[0]];
    const Vec3& b = vertices_[face[1]];
    const Vec3& c = vertices_[face[2]];
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const double largest =
        std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
    return (b - a).cross(c - a).norm() > leastHeight * longest * largest;
}

bool CrossingFinder::isSliver(const Triangle& face) const {
    return !isBroad(face, kSliverHeight);
}

bool CrossingFinder::counts(const Triangle& face) const {
    return !isRounded_ || isBroad(face, kLeastHeight);
}

bool CrossingFinder::cross(const Triangle& a, const Triangle& b) const {
    if (!isRounded_) {
        return trianglesIntersect(vertices_, a, b);
    }
    Triangle other = b;  // by the vertices of `a` where they became one place
    for (int& corner : other) {
        const auto* const same = std::ranges::find_if(a, [&](int vertex) {
            return vertices_[vertex] == vertices_[corner];
        });
        corner = same != a.end() ? *same : corner;
    }
    // Faces on both sides of an edge that became one place lie on each other.
    const bool isSame = std::ranges::is_permutation(a, other) && !std::ranges::is_permutation(a, b);
    return !isSame && trianglesIntersect(vertices_, a, other);
}

bool CrossingFinder::crossesKept(const Triangle& face) const {
    if (!counts(face)) {
        return false;
    }
    const std::array corners{vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]};
    return std::ranges::any_of(kept_, [&](const std::unique_ptr<const Kept>& kept) {
        bool crosses = false;
        kept->tree.forEachMeeting(corners, [&](int other) {
            crosses = crosses || cross(face, kept->faces[other]);
        });
        return crosses;
    });
}

Crossings CrossingFinder::crossingsOf(const std::vector<Triangle>& faces) const {
    Crossings found;
    const TriangleTree tree(vertices_, faces);
    tree.forEachOverlappingPair([&](int i, int j) {
        if (counts(faces[i]) && counts(faces[j]) && cross(faces[i], faces[j])) {
            found.pairs.emplace_back(i, j);
        }
    });
    std::ranges::sort(found.pairs);
    found.withKept =
        indicesWhere<int>(faces.size(), [&](std::size_t f) { return crossesKept(faces[f]); });
    return found;
}

}  // namespace bspline_curve
