// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_refinement.h"

#include "bspline_curve/progress.h"
#include "fill/inner_edges.h"
#include "fill/patch_sides.h"
#include "utility/go_on.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>

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

Vec3 normalOf(const Patch& patch, int a, int b, int c) {
    const Vec3& p = patch.points[a];
    return (patch.points[b] - p).cross(patch.points[c] - p);
}

bool isObtuse(const Patch& patch, int apex, int b, int c) {
    const Vec3& p = patch.points[apex];
    return (patch.points[b] - p).dot(patch.points[c] - p) < 0.0;
}

double cotangentAt(const Patch& patch, int apex, int b, int c) {
    const Vec3 to = patch.points[b] - patch.points[apex];
    const Vec3 from = patch.points[c] - patch.points[apex];
    const double sine = std::max(to.cross(from).norm(), 1e-300);
    return to.dot(from) / sine;
}

/// Whether the other diagonal is Delaunay, and folds nothing.
bool isBetterFlipped(const Patch& patch, const PatchSides::Pair& pair) {
    const int a = pair.a;
    const int b = pair.b;
    const int c = pair.c;
    const int d = pair.d;
    // Most angles are acute.
    if (!isObtuse(patch, c, a, b) && !isObtuse(patch, d, a, b)) {
        return false;
    }
    if (cotangentAt(patch, c, a, b) + cotangentAt(patch, d, a, b) >= -kDelaunayMargin) {
        return false;
    }
    const Vec3 before = normalOf(patch, a, b, c) + normalOf(patch, b, a, d);
    return normalOf(patch, c, d, b).dot(before) > 0.0 && normalOf(patch, d, c, a).dot(before) > 0.0;
}

/// A patch while its edges are halved and flipped. Calls `goOn` within milliseconds.
class RefinedPatch {
public:
    RefinedPatch(Patch& patch, const GoOn& goOn)
        : patch_(patch), goOn_(goOn), sides_(patch.faces) {}

    /// Halves edges that are too long, the longest ones first, each face once. How many there were.
    std::size_t halveLongEdges() {
        struct LongEdge {
            double excess;
            int face, k;
        };

        std::vector<LongEdge> tooLong;
        forEachInnerSide([&](int face, int k) {
            const double much = excess(face, k);
            if (much > 1.0) {
                tooLong.push_back({much, face, k});
            }
        });
        goOn_();
        std::ranges::stable_sort(tooLong, std::greater(), &LongEdge::excess);
        goOn_();
        // New faces have changed, as those that were halved.
        const auto count = static_cast<int>(patch_.faces.size());
        ChangedFaces changed(patch_.faces.size());
        for (const auto& [much, face, k] : tooLong) {
            const int other = sides_.across(face, k);
            if (other < count && changed.take(face, other)) {
                halve(face, k);
            }
        }
        return tooLong.size();
    }

    /// Flips edges until none is better flipped, each again where one of its faces changed.
    void flip() {
        forEachInnerSide([&](int face, int k) { suspects_.push_back({face, k}); });
        // An end also where rounding would have two edges take turns.
        std::size_t left = kMostFlips * patch_.faces.size();
        for (; !suspects_.empty() && left > 0; --left) {
            const auto [face, k] = suspects_.front();
            suspects_.pop_front();
            tryFlip(face, k);
            if (left % kRoundsBetweenCalls == 0) {
                goOn_();
            }
        }
    }

private:
    struct Side {
        int face, k;
    };

    /// Once for each edge that has two faces.
    template <class Visitor>
    void forEachInnerSide(const Visitor& visit) {
        for (int face = 0; face < static_cast<int>(patch_.faces.size()); ++face) {
            if (face % static_cast<int>(kRoundsBetweenCalls) == 0) {
                goOn_();
            }
            for (int k = 0; k < 3; ++k) {
                if (sides_.across(face, k) > face) {
                    visit(face, k);
                }
            }
        }
    }

    /// Length over size; chords of the rim count more.
    [[nodiscard]] double excess(int face, int k) const {
        const int a = patch_.faces[face][(k + 1) % 3];
        const int b = patch_.faces[face][(k + 2) % 3];
        const double length = (patch_.points[a] - patch_.points[b]).norm();
        const bool isChord = patch_.isOnRim(a) && patch_.isOnRim(b);
        return length /
               (sizeBetween(patch_, a, b) * (isChord ? kLongChordRelative : kLongRelative));
    }

    void halve(int face, int k) {
        const int a = patch_.faces[face][(k + 1) % 3];
        const int b = patch_.faces[face][(k + 2) % 3];
        const auto middle = static_cast<int>(patch_.points.size());
        const double length = (patch_.points[a] - patch_.points[b]).norm();
        patch_.points.emplace_back(0.5 * (patch_.points[a] + patch_.points[b]));
        patch_.most.push_back(0.5 * (patch_.most[a] + patch_.most[b]));
        patch_.sizes.push_back(
            std::min(
                patch_.most.back(),
                std::min(patch_.sizes[a], patch_.sizes[b]) + 0.5 * kGrading * length
            )
        );
        sides_.halve(face, k, middle);
    }

    /// Whether there may be an edge between the corners beyond a side.
    [[nodiscard]] bool isFree(int face, int k, const PatchSides::Pair& pair) const {
        const auto [low, high] = std::minmax(pair.c, pair.d);
        if (patch_.isOnRim(low) && patch_.isOnRim(high)) {
            const double length = (patch_.points[low] - patch_.points[high]).norm();
            if (length > kLongChordRelative * sizeBetween(patch_, low, high)) {
                return false;  // it would be halved again
            }
        }
        return !patch_.forbidden.contains({low, high}) && !sides_.hasEdgeTo(face, k, pair.d);
    }

    void tryFlip(int face, int k) {
        if (sides_.across(face, k) < 0) {
            return;
        }
        const PatchSides::Pair pair = sides_.pairAt(face, k);
        if (!isBetterFlipped(patch_, pair) || !isFree(face, k, pair)) {
            return;
        }
        sides_.flip(face, k);
        for (const int changed : {face, pair.other}) {  // the new edge is opposite to corner 2
            suspects_.push_back({changed, 0});
            suspects_.push_back({changed, 1});
        }
    }

    Patch& patch_;
    const GoOn& goOn_;
    PatchSides sides_;
    std::deque<Side> suspects_;
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
    const GoOn goOn = [&] { report(progress, 1.0 - 1.0 / (1.0 + round), "refining a patch"); };
    RefinedPatch refined(patch, goOn);
    if (isMoving) {
        refined.flip();
    }
    for (; round < kMostRounds && patch.faces.size() <= mostFaces; ++round) {
        goOn();
        const std::size_t tooLong = refined.halveLongEdges();
        if (isMoving) {
            refined.flip();
            for (int i = 0; i < kRelaxations; ++i) {
                goOn();
                relax(patch, relaxing);
            }
            goOn();
            refined.flip();
        }
        if (tooLong <= patch.faces.size() / kFacesPerLongEdge) {
            return;
        }
    }
}

}  // namespace bspline_curve
