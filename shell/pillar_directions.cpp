// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace bspline_curve {
namespace {

struct PatchConstants {
    /// Patches that are left on the largest level: their edges are then 0.005 times the root of the
    /// area. Directions on fewer follow the surface less closely.
    int fewest = 80000;
    /// Averages over the neighbours on the largest level: smooth enough for curves.
    int passes = 3;
    /// Likewise on each level on the way back to the finest.
    int passesBack = 2;
};

constexpr PatchConstants kPatches;

// A direction is optimal if it sees every normal at least as well as its supports; rounding of unit
// vectors aside.
constexpr double kRounding = 1e-12;
// A cap whose cosine falls by less is as wide as the one before.
constexpr double kLeastGrowth = 1e-15;
// Of up to so many normals all pairs and triples are tried.
constexpr std::size_t kFewNormals = 16;

// The best direction for a few normals: it has the same angle to two or three of them, its
// supports.
struct Cap {
    static constexpr std::size_t kMost = 3;

    Vec3 direction = Vec3::Zero();
    double cosine = -2.0;
    std::array<Vec3, kMost> supports{};  // the first `count`
    std::size_t count = 0;

    void offer(
        const Vec3& candidate, std::span<const Vec3> normals, std::initializer_list<Vec3> touched
    ) {
        const double length = candidate.norm();
        if (length < kRounding) {
            return;
        }
        const Vec3 unit = candidate / length;
        const double least = leastCosine(unit, normals);
        if (least > cosine) {
            cosine = least;
            direction = unit;
            count = touched.size();
            std::ranges::copy(touched, supports.begin());
        }
    }
};

// The smallest cap around a few normals, by all pairs, then all triples: O(m^4). Starts with the
// most opposed pair, which supports the cap in most cases, and is then optimal.
Cap capOfFew(std::span<const Vec3> normals) {
    const std::size_t m = normals.size();
    double mostOpposed = 2.0;
    std::pair<std::size_t, std::size_t> pair;
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            const double cosine = normals[i].dot(normals[j]);
            if (cosine < mostOpposed) {
                mostOpposed = cosine;
                pair = {i, j};
            }
        }
    }
    const Vec3& a = normals[pair.first];
    const Vec3& b = normals[pair.second];
    Cap best;
    best.offer(a + b, normals, {a, b});
    if (best.cosine >= std::sqrt(std::max(0.0, 0.5 * (1.0 + mostOpposed))) - kRounding) {
        return best;
    }
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            for (std::size_t k = j + 1; k < m; ++k) {
                Vec3 pole = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                if (pole.dot(normals[i]) < 0.0) {
                    pole = -pole;
                }
                best.offer(pole, normals, {normals[i], normals[j], normals[k]});
            }
        }
    }
    return best;
}

// Wolfe's way to the smallest cap: that around the supports of the last one and the normal that is
// farthest outside of it, until there is none. Each cap is wider than the one before, so none comes
// twice.
Cap capOfMany(std::span<const Vec3> normals) {
    Cap cap{.direction = normals[0], .cosine = 1.0, .supports = {normals[0]}, .count = 1};
    while (cap.cosine > 0.0) {  // else no direction sees the supports from the front
        const Vec3& farthest = *std::ranges::min_element(normals, {}, [&](const Vec3& normal) {
            return cap.direction.dot(normal);
        });
        std::array<Vec3, Cap::kMost + 1> few;
        std::ranges::copy(cap.supports, few.begin());
        few[cap.count] = farthest;
        const Cap wider = capOfFew({few.data(), cap.count + 1});
        if (cap.direction.dot(farthest) >= cap.cosine - kLeastGrowth ||
            wider.cosine >= cap.cosine || wider.count == 0) {
            break;
        }
        cap = wider;
    }
    return cap;
}

void normalize(std::vector<Vec3>& directions) {
    for (Vec3& direction : directions) {
        direction.normalize();
    }
}

// A patch counts half as much as its neighbours together, as a vertex does among its ring.
void smooth(const PatchLevels::Level& level, int passes, std::vector<Vec3>& directions) {
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Vec3> sums;
        sums.reserve(directions.size());
        for (int patch = 0; patch < level.count(); ++patch) {
            const int begin = level.offsets[patch];
            const int end = level.offsets[patch + 1];
            Vec3 sum = 0.5 * (end - begin) * directions[patch];
            for (int i = begin; i < end; ++i) {
                sum += directions[level.neighbours[i]];
            }
            sums.push_back(begin < end ? sum : directions[patch]);
        }
        normalize(sums);
        directions = std::move(sums);
    }
}

// Of the patches of a level, by what they are made of.
std::vector<Vec3> sumsOver(const PatchLevels::Level& level, const std::vector<Vec3>& below) {
    std::vector<Vec3> sums(level.count(), Vec3::Zero());
    for (std::size_t i = 0; i < below.size(); ++i) {
        sums[level.patchOf[i]] += below[i];
    }
    return sums;
}

}  // namespace

Vec3 directionOfLeastAngle(std::span<const Vec3> normals) {
    if (normals.size() <= 1) {
        return normals.empty() ? Vec3::UnitZ() : normals[0];
    }
    const Cap cap = normals.size() <= kFewNormals ? capOfFew(normals) : capOfMany(normals);
    return cap.count > 0 ? cap.direction : normals[0];
}

const PatchLevels::Level* patchesToSmoothOver(const PatchLevels& patches) {
    const PatchLevels::Level* largest = nullptr;
    for (const PatchLevels::Level& level : patches.levels()) {
        if (level.count() >= kPatches.fewest) {
            largest = &level;
        }
    }
    return largest;
}

std::vector<Vec3> smoothPatchDirections(
    const PatchLevels& patches, const std::vector<Vec3>& faceNormals
) {
    const PatchLevels::Level* const largest = patchesToSmoothOver(patches);
    const PatchLevels::Level* const finest = &patches.levels().front();
    std::vector<Vec3> directions = sumsOver(*finest, faceNormals);
    for (const PatchLevels::Level* level = finest; level != largest;) {
        directions = sumsOver(*++level, directions);
    }
    normalize(directions);
    smooth(*largest, kPatches.passes, directions);
    for (const PatchLevels::Level* level = largest; level != finest;) {
        const std::vector<int>& patchOf = (level--)->patchOf;
        std::vector<Vec3> finer;
        finer.reserve(patchOf.size());
        for (const int patch : patchOf) {
            finer.push_back(directions[patch]);
        }
        directions = std::move(finer);
        smooth(*level, kPatches.passesBack, directions);
    }
    return directions;
}

}  // namespace bspline_curve
