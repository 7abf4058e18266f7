// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_refinement.h"

#include "bspline_curve/progress.h"
#include "fill/inner_edges.h"
#include "surface/surface_point.h"
#include "utility/go_on.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_set>

namespace bspline_curve {

namespace {

/// Edges longer than this times their size are halved; the halves are then as near to it.
constexpr double kLongRelative = 1.4;
/// Edges between points of the rim longer than this times their size are halved, so that no large
/// face hangs on the rim alone and cannot be faired.
constexpr double kLongChordRelative = 0.5;
/// Sums of cotangents below minus this are not Delaunay; a margin against endless turns.
constexpr double kDelaunayMargin = 1e-9;
/// How much longer edges may become for each length away from a point whose edges are short.
constexpr double kGrading = 0.5;
constexpr int kMostRounds = 40;
/// Rounds end with less than one edge that is too long in so many faces: points that relax make a
/// few longer again.
constexpr std::size_t kFacesPerLongEdge = 1000;
constexpr std::size_t kMostFlips = 150;  // tried, for each face
constexpr int kRelaxations = 2;          // in each round
constexpr double kRelaxationStep = 0.5;

/// The size halfway between two points.
double sizeBetween(const Patch& patch, int a, int b) {
    const double length = (patch.points[a] - patch.points[b]).norm();
    return std::min(
        0.5 * (patch.sizes[a] + patch.sizes[b]),
        std::min(patch.sizes[a], patch.sizes[b]) + 0.5 * kGrading * length
    );
}

/// Length over size; chords of the rim count more.
double excess(const Patch& patch, const InnerEdge& edge) {
    const double length = (patch.points[edge.a] - patch.points[edge.b]).norm();
    const double size = sizeBetween(patch, edge.a, edge.b);
    const bool isChord = patch.isOnRim(edge.a) && patch.isOnRim(edge.b);
    return length / (size * (isChord ? kLongChordRelative : kLongRelative));
}

/// How many were too long.
std::size_t halveLongEdges(Patch& patch, const GoOn& goOn) {
    std::vector<std::pair<double, InnerEdge>> tooLong;
    const std::vector<InnerEdge> edges = innerEdges(patch.faces);
    goOn();
    for (const InnerEdge& edge : edges) {
        const double much = excess(patch, edge);
        if (much > 1.0) {
            tooLong.emplace_back(much, edge);
        }
    }
    goOn();
    std::ranges::stable_sort(tooLong, std::greater(), [](const auto& each) { return each.first; });
    goOn();
    ChangedFaces changed(patch.faces.size());
    for (const auto& [much, edge] : tooLong) {
        if (!changed.take(edge)) {
            continue;
        }
        const auto& [a, b, c, d, first, second] = edge;
        const auto middle = static_cast<int>(patch.points.size());
        patch.points.emplace_back(0.5 * (patch.points[a] + patch.points[b]));
        const double length = (patch.points[a] - patch.points[b]).norm();
        patch.most.push_back(0.5 * (patch.most[a] + patch.most[b]));
        patch.sizes.push_back(
            std::min(
                patch.most.back(),
                std::min(patch.sizes[a], patch.sizes[b]) + 0.5 * kGrading * length
            )
        );
        patch.faces[first] = {a, middle, c};
        patch.faces[second] = {b, middle, d};
        patch.faces.push_back({middle, b, c});
        patch.faces.push_back({middle, a, d});
    }
    return tooLong.size();
}

Vec3 normalOf(const Patch& patch, int a, int b, int c) {
    const Vec3& p = patch.points[a];
    return (patch.points[b] - p).cross(patch.points[c] - p);
}

double cotangentAt(const Patch& patch, int apex, int b, int c) {
    const Vec3 to = patch.points[b] - patch.points[apex];
    const Vec3 from = patch.points[c] - patch.points[apex];
    const double sine = std::max(to.cross(from).norm(), 1e-300);
    return to.dot(from) / sine;
}

/// Whether the other diagonal is Delaunay, and folds nothing.
bool isBetterFlipped(const Patch& patch, const InnerEdge& edge) {
    const auto& [a, b, c, d, first, second] = edge;
    if (cotangentAt(patch, c, a, b) + cotangentAt(patch, d, a, b) >= -kDelaunayMargin) {
        return false;
    }
    const Vec3 before = normalOf(patch, a, b, c) + normalOf(patch, b, a, d);
    return normalOf(patch, c, d, b).dot(before) > 0.0 && normalOf(patch, d, c, a).dot(before) > 0.0;
}

/// Flips edges until none is better flipped, each again where one of its faces changed.
class Flips {
public:
    Flips(Patch& patch, const GoOn& goOn) : patch_(patch) {
        Triangle none;
        none.fill(-1);
        beside_.assign(patch.faces.size(), none);
        for (const InnerEdge& edge : innerEdges(patch.faces)) {
            beside_[edge.first][cornerOf(patch.faces[edge.first], edge.c)] = edge.second;
            beside_[edge.second][cornerOf(patch.faces[edge.second], edge.d)] = edge.first;
        }
        edges_.reserve(2 * patch.faces.size());
        for (std::size_t f = 0; f < patch.faces.size(); ++f) {
            if (f % kRoundsBetweenCalls == 0) {
                goOn();
            }
            const Triangle& face = patch.faces[f];
            for (int k = 0; k < 3; ++k) {
                edges_.insert(keyOf(face[k], face[(k + 1) % 3]));
            }
        }
    }

    /// Over all edges; may be called again after points have moved. Calls `goOn` within
    /// milliseconds.
    void run(const GoOn& goOn) {
        for (int face = 0; face < static_cast<int>(patch_.faces.size()); ++face) {
            for (int k = 0; k < 3; ++k) {
                if (beside_[face][k] > face) {
                    suspects_.push_back({face, k});
                }
            }
        }
        // An end also where rounding would have two edges take turns.
        std::size_t left = kMostFlips * patch_.faces.size();
        for (; !suspects_.empty() && left > 0; --left) {
            const auto [face, k] = suspects_.front();
            suspects_.pop_front();
            tryFlip(face, k);
            if (left % kRoundsBetweenCalls == 0) {
                goOn();
            }
        }
    }

private:
    struct Side {
        int face, k;  // opposite to corner k
    };

    static std::uint64_t keyOf(int a, int b) {
        const auto [low, high] = std::minmax(a, b);
        return static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint32_t>(high);
    }

    [[nodiscard]] bool isFree(int c, int d) const {
        const auto [low, high] = std::minmax(c, d);
        if (patch_.isOnRim(c) && patch_.isOnRim(d)) {
            const double length = (patch_.points[c] - patch_.points[d]).norm();
            const double size = sizeBetween(patch_, c, d);
            if (length > kLongChordRelative * size) {
                return false;  // it would be halved again
            }
        }
        return !edges_.contains(keyOf(c, d)) && !patch_.forbidden.contains({low, high});
    }

    void tryFlip(int face, int k) {
        const int other = beside_[face][k];
        if (other < 0) {
            return;
        }
        const Triangle one = patch_.faces[face];
        const int a = one[(k + 1) % 3];
        const int b = one[(k + 2) % 3];
        const int c = one[k];
        const int j = (cornerOf(patch_.faces[other], a) + 1) % 3;
        const int d = patch_.faces[other][j];
        const InnerEdge edge{.a = a, .b = b, .c = c, .d = d, .first = face, .second = other};
        if (!isBetterFlipped(patch_, edge) || !isFree(c, d)) {
            return;
        }
        const Triangle besideOne = beside_[face];
        const Triangle besideOther = beside_[other];
        const int pastBC = besideOne[(k + 1) % 3];
        const int pastCA = besideOne[(k + 2) % 3];
        const int pastAD = besideOther[(j + 1) % 3];
        const int pastDB = besideOther[(j + 2) % 3];
        patch_.faces[face] = {c, d, b};
        patch_.faces[other] = {d, c, a};
        beside_[face] = {pastDB, pastBC, other};
        beside_[other] = {pastCA, pastAD, face};
        renameBeside(pastDB, other, face);
        renameBeside(pastCA, face, other);
        edges_.erase(keyOf(a, b));
        edges_.insert(keyOf(c, d));
        for (const int changed : {face, other}) {
            suspects_.push_back({changed, 0});
            suspects_.push_back({changed, 1});
        }
    }

    void renameBeside(int neighbour, int before, int after) {
        if (neighbour >= 0) {
            std::ranges::replace(beside_[neighbour], before, after);
        }
    }

    Patch& patch_;
    std::vector<Triangle> beside_;  // the face across the side opposite to each corner, or -1
    std::deque<Side> suspects_;
    std::unordered_set<std::uint64_t> edges_;
};

void relax(Patch& patch, Relaxing relaxing) {
    std::vector<Vec3> sum(patch.points.size(), Vec3::Zero());
    std::vector<Vec3> normal(patch.points.size(), Vec3::Zero());
    std::vector<int> count(patch.points.size(), 0);
    for (const auto& [a, b, c] : patch.faces) {
        const Vec3 area = normalOf(patch, a, b, c);
        for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
            sum[from] += patch.points[to];
            normal[from] += area;
            ++count[from];
        }
    }
    for (std::size_t i = patch.rimCount; i < patch.points.size(); ++i) {
        Vec3 move = kRelaxationStep * (sum[i] / count[i] - patch.points[i]);
        const double length = normal[i].norm();
        if (relaxing == Relaxing::Tangential && length > 0.0) {
            move -= move.dot(normal[i]) / (length * length) * normal[i];
        }
        patch.points[i] += move;
    }
}

}  // namespace

void relaxAround(Patch& patch, const std::vector<int>& faces) {
    Patch relaxed = patch;
    relax(relaxed, Relaxing::Free);
    for (const int face : faces) {
        for (const int corner : patch.faces[face]) {
            if (!patch.isOnRim(corner)) {
                patch.points[corner] = relaxed.points[corner];
            }
        }
    }
}

void refinePatch(Patch& patch, Relaxing relaxing, const Progress& progress, std::size_t mostFaces) {
    const bool isMoving = relaxing != Relaxing::None;
    int round = 0;
    const auto goOn = [&] { report(progress, 1.0 - 1.0 / (1.0 + round), "refining a patch"); };
    if (isMoving) {
        Flips(patch, goOn).run(goOn);
    }
    for (; round < kMostRounds && patch.faces.size() <= mostFaces; ++round) {
        goOn();
        const std::size_t tooLong = halveLongEdges(patch, goOn);
        goOn();
        if (isMoving) {
            Flips flips(patch, goOn);
            goOn();
            flips.run(goOn);
            for (int i = 0; i < kRelaxations; ++i) {
                goOn();
                relax(patch, relaxing);
            }
            goOn();
            flips.run(goOn);
        }
        if (tooLong <= patch.faces.size() / kFacesPerLongEdge) {
            return;
        }
    }
}

}  // namespace bspline_curve
