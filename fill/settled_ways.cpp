// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/settled_ways.h"

#include "surface/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

constexpr int kMostSettlingRounds = 32;
/// In the first rounds ways are smoothed alone, so that they keep their length.
constexpr int kSmoothRounds = 6;
constexpr int kSmoothPasses = 4;  // in a round
/// Where faces cross, their vertices keep this share of their way in each round.
constexpr double kShorter = 0.7;
/// Of the lengths along edges, where they were reduced.
constexpr double kSteepestStop = 0.5;
/// Ways that short are turned out of the faces around: at folds, mean normals lead into some.
constexpr double kTurnedShare = 0.3;
/// Cosines between a turned way and the normals around that are enough, and steps towards them.
constexpr double kEnoughCosine = 0.2;
constexpr int kMostTurns = 50;

}  // namespace

SettledWays::SettledWays(
    const TriangleMesh& sheet, std::vector<Vec3> ways, double reach, double leastShare
)
    : sheet_(sheet),
      ways_(std::move(ways)),
      shares_(ways_.size(), 1.0),
      reach_(reach),
      leastShare_(leastShare),
      isOnRim_(ways_.size(), 0) {
    forEachEdge(sortedHalfEdges(sheet.faces), [&](std::span<const HalfEdge> sides) {
        const auto& [low, high, face, k] = sides[0];
        const bool isRim = sides.size() == 1;
        edges_.push_back(
            {.a = low,
             .b = high,
             .length = (sheet.vertices[low] - sheet.vertices[high]).norm(),
             .isOnRim = isRim}
        );
        if (isRim) {
            isOnRim_[low] = isOnRim_[high] = 1;
        }
    });
}

void SettledWays::settle(const Crossing& crossing, const Progress& progress) {
    if (!settle(crossing, false, partOf(progress, 0.0, 0.5))) {
        return;
    }
    const std::vector<Vec3> ways = ways_;
    const std::vector<double> shares = shares_;
    if (!settle(crossing, true, partOf(progress, 0.5, 1.0))) {
        ways_ = ways;
        shares_ = shares;
        static_cast<void>(crossing(points(), false));
    }
}

/// False where faces cross in the end.
bool SettledWays::settle(const Crossing& crossing, bool isStrict, const Progress& progress) {
    const std::vector<Vec3> straight = ways_;
    const auto search = [&] { return crossing(points(), isStrict); };
    std::vector<int> bad = search();
    const std::size_t before = bad.size();
    int round = 0;
    const auto goOn = [&] {
        ++round;
        report(
            progress,
            static_cast<double>(round) / (kMostSettlingRounds + 1),
            "looking for crossings"
        );
        return !bad.empty() && round <= kMostSettlingRounds;
    };
    while (goOn() && round <= kSmoothRounds) {
        smoothAround(bad, round);
        bad = search();
    }
    if (!bad.empty() && bad.size() >= before) {
        ways_ = straight;
        bad = search();
    }
    while (goOn() && shorten(bad)) {
        bad = search();
    }
    return bad.empty();
}

std::vector<Vec3> SettledWays::points() const {
    std::vector<Vec3> points = sheet_.vertices;
    for (std::size_t v = 0; v < points.size(); ++v) {
        points[v] += shares_[v] * ways_[v];
    }
    return points;
}

/// Ways become means of those around, of their own length; on the rim of those along it, so that
/// walls do not fold. The region grows by rings.
void SettledWays::smoothAround(const std::vector<int>& vertices, int rings) {
    std::vector<char> near(ways_.size(), 0);
    for (const int vertex : vertices) {
        near[vertex] = 1;
    }
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<char> wider = near;
        for (const Edge& edge : edges_) {
            wider[edge.a] = static_cast<char>(wider[edge.a] | near[edge.b]);
            wider[edge.b] = static_cast<char>(wider[edge.b] | near[edge.a]);
        }
        near = std::move(wider);
    }
    for (int pass = 0; pass < kSmoothPasses; ++pass) {
        std::vector<Vec3> sums(ways_.size(), Vec3::Zero());
        std::vector<double> weights(ways_.size(), 0.0);
        for (const Edge& edge : edges_) {
            for (const auto& [to, from] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
                if (edge.isOnRim || isOnRim_[to] == 0) {
                    sums[to] += ways_[from] / edge.length;
                    weights[to] += 1.0 / edge.length;
                }
            }
        }
        for (std::size_t v = 0; v < ways_.size(); ++v) {
            if (near[v] != 0 && weights[v] > 0.0) {
                const Vec3 mean = ways_[v] + sums[v] / weights[v];
                ways_[v] = ways_[v].norm() * mean.stableNormalized();
            }
        }
    }
}

/// False where no way can end earlier.
bool SettledWays::shorten(const std::vector<int>& vertices) {
    bool isShorter = false;
    std::vector<int> narrow;
    for (const int vertex : vertices) {
        double& share = shares_[vertex];
        if (share > leastShare_) {
            share = std::max(kShorter * share, leastShare_);
            isShorter = true;
        }
        if (share < kTurnedShare) {
            narrow.push_back(vertex);
        }
    }
    turnOutOfFaces(narrow);
    for (bool isLowered = isShorter; isLowered;) {
        isLowered = false;
        for (const auto& [a, b, length, isRim] : edges_) {
            const double most =
                std::min(shares_[a], shares_[b]) + kSteepestStop * length / std::abs(reach_);
            isLowered = isLowered || shares_[a] > most || shares_[b] > most;
            shares_[a] = std::min(shares_[a], most);
            shares_[b] = std::min(shares_[b], most);
        }
    }
    return isShorter;
}

/// Turns ways towards the normal that they are least along, so often until they are along all.
void SettledWays::turnOutOfFaces(const std::vector<int>& vertices) {
    if (vertices.empty()) {
        return;
    }
    std::vector<int> placeOf(ways_.size(), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        placeOf[vertices[i]] = static_cast<int>(i);
    }
    std::vector<std::vector<Vec3>> normals(vertices.size());
    for (const auto& face : sheet_.faces) {
        const auto& [a, b, c] = face;
        const Vec3& corner = sheet_.vertices[a];
        const Vec3 normal =
            std::copysign(1.0, reach_) *
            (sheet_.vertices[b] - corner).cross(sheet_.vertices[c] - corner).stableNormalized();
        for (const int vertex : face) {
            if (placeOf[vertex] >= 0) {
                normals[placeOf[vertex]].push_back(normal);
            }
        }
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Vec3& way = ways_[vertices[i]];
        Vec3 direction = way.stableNormalized();
        for (int turn = 0; turn < kMostTurns && !normals[i].empty(); ++turn) {
            const Vec3& least = *std::ranges::min_element(normals[i], {}, [&](const Vec3& normal) {
                return normal.dot(direction);
            });
            const double cosine = least.dot(direction);
            if (cosine >= kEnoughCosine) {
                break;
            }
            direction = (direction + (kEnoughCosine - cosine) * least).stableNormalized();
        }
        way = way.norm() * direction;
    }
}

}  // namespace bspline_curve
