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
#include <limits>

namespace bspline_curve {

namespace {

// Least heights of triangles in single precision, relative to their largest coordinate: 8 ulps,
// below which rounding may turn a triangle over, and 1.
constexpr double kSliverHeight = 0x1p-20;
constexpr double kLeastHeight = 0x1p-23;
/// How often a part of the mesh is prepared before the whole is.
constexpr int kMostMoves = 8;
/// A region is that much longer than what is in it, at either end.
constexpr double kRegionMargin = 0.5;
/// All pairs are gone through where more than one of so many faces has moved.
constexpr int kMovedToTestAll = 8;
constexpr std::size_t kFacesBetween = 4096;  // two calls of goOn

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
    : vertices_(vertices), mesh_(kept), isRounded_(isRounded) {}

CrossingFinder::Box CrossingFinder::boxOf(const Triangle& face) const {
    Box box(vertices_[face[0]]);
    return box.extend(vertices_[face[1]]).extend(vertices_[face[2]]);
}

std::unique_ptr<const CrossingFinder::Kept> CrossingFinder::madeReady(
    const std::vector<Triangle>& faces
) const {
    std::vector<Triangle> kept;
    std::ranges::copy_if(faces, std::back_inserter(kept), [&](const Triangle& face) {
        return !isRounded_ || !isSliver(face);
    });
    return std::make_unique<const Kept>(vertices_, std::move(kept));
}

/// Makes the faces of the mesh ready that a box meets.
void CrossingFinder::prepareNear(const Box& box) {
    if (near_ && region_.contains(box)) {
        return;
    }
    const Vec3 margin = kRegionMargin * box.sizes();
    const Box wider(box.min() - margin, box.max() + margin);
    region_ = region_.intersects(box) ? region_.merged(wider) : wider;
    if (++moves_ == kMostMoves) {
        region_ =
            Box(Vec3::Constant(-std::numeric_limits<double>::infinity()),
                Vec3::Constant(std::numeric_limits<double>::infinity()));
    }
    std::vector<Triangle> inRegion;
    std::ranges::copy_if(mesh_, std::back_inserter(inRegion), [&](const Triangle& face) {
        return region_.intersects(boxOf(face));
    });
    near_ = madeReady(inRegion);
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

bool CrossingFinder::crossesKept(const Triangle& face) {
    prepareNear(boxOf(face));
    return crossesPrepared(face);
}

bool CrossingFinder::crossesPrepared(const Triangle& face) const {
    if (!counts(face)) {
        return false;
    }
    const std::array corners{vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]};
    const auto isCrossed = [&](const std::unique_ptr<const Kept>& kept) {
        return kept->tree.anyMeeting(corners, [&](int other) {
            return cross(face, kept->faces[other]);
        });
    };
    return isCrossed(near_) || std::ranges::any_of(patches_, isCrossed);
}

/// Which faces are not where they were the last time.
std::vector<char> CrossingFinder::movedSinceLast(const Checked& now) const {
    std::vector<char> hasMoved(now.faces.size(), 1);
    if (now.faces == last_.faces) {
        for (std::size_t f = 0; f < hasMoved.size(); ++f) {
            hasMoved[f] = static_cast<char>(now.corners[f] != last_.corners[f]);
        }
    }
    return hasMoved;
}

/// Of faces that cross each other, those of which one has moved at least, and what was found of the
/// others the last time. Ascending.
std::vector<std::pair<int, int>> CrossingFinder::crossingPairs(
    const std::vector<Triangle>& faces, const std::vector<char>& hasMoved, const GoOn& tell
) const {
    const auto count = static_cast<int>(faces.size());
    const auto stays = [&](int face) { return face < count && hasMoved[face] == 0; };
    std::vector<std::pair<int, int>> pairs;
    std::ranges::copy_if(last_.found.pairs, std::back_inserter(pairs), [&](const auto& pair) {
        return stays(pair.first) && stays(pair.second);
    });
    std::vector<char> isCounted;
    for (const Triangle& face : faces) {
        isCounted.push_back(static_cast<char>(counts(face)));
    }
    const TriangleTree tree(vertices_, faces);
    tell();
    const auto test = [&](int i, int j) {
        tell();
        if (isCounted[i] != 0 && isCounted[j] != 0 && cross(faces[i], faces[j])) {
            pairs.emplace_back(i, j);
        }
    };
    if (kMovedToTestAll * std::ranges::count(hasMoved, 1) > count) {
        tree.forEachOverlappingPair([&](int i, int j) {
            if (!stays(i) || !stays(j)) {
                test(i, j);
            }
        });
    } else {
        for (int i = 0; i < count; ++i) {
            const auto testOnce = [&](int j) {
                if (i < j || (i != j && stays(j))) {
                    test(std::min(i, j), std::max(i, j));
                }
            };
            if (!stays(i)) {
                tree.forEachOverlapping(i, testOnce);
            }
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

Crossings CrossingFinder::crossingsOf(const std::vector<Triangle>& faces, const GoOn& goOn) {
    std::size_t tested = 0;
    const auto tell = [&] {
        if (++tested % kFacesBetween == 0) {
            goOn();
        }
    };
    Checked now{.faces = faces, .corners = {}, .found = {}};
    Box box;
    for (const Triangle& face : faces) {
        box.extend(boxOf(face));
        now.corners.push_back({vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]});
    }
    prepareNear(box);
    goOn();
    const std::vector<char> hasMoved = movedSinceLast(now);
    now.found.pairs = crossingPairs(faces, hasMoved, tell);
    std::vector<char> crossesKept(faces.size(), 0);
    for (const int face : last_.found.withKept) {
        if (face < std::ssize(faces)) {
            crossesKept[face] = 1;
        }
    }
    now.found.withKept = indicesWhere<int>(faces.size(), [&](std::size_t f) {
        tell();
        return hasMoved[f] != 0 ? crossesPrepared(faces[f]) : crossesKept[f] != 0;
    });
    last_ = std::move(now);
    return last_.found;
}

}  // namespace bspline_curve
