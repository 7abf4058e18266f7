// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// A candidate is optimal if it sees every normal at least as well as its supports; rounding of unit
// vectors aside.
constexpr double kRounding = 1e-12;

struct Best {
    Vec3 direction = Vec3::Zero();
    double cosine = -2.0;

    void offer(const Vec3& candidate, std::span<const Vec3> normals) {
        const double length = candidate.norm();
        if (length < kRounding) {
            return;
        }
        const Vec3 unit = candidate / length;
        const double least = leastCosine(unit, normals);
        if (least > cosine) {
            cosine = least;
            direction = unit;
        }
    }
};

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
    // The smallest spherical cap around the normals touches two or three of them (a cap of one is
    // the trivial case). Start with the most opposed pair: it supports the cap in most cases, and
    // is then optimal.
    Best best;
    const std::size_t m = normals.size();
    if (m == 1) {
        return normals[0];
    }
    double mostOpposed = 2.0;
    Vec3 bisector = Vec3::Zero();
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            const double cosine = normals[i].dot(normals[j]);
            if (cosine < mostOpposed) {
                mostOpposed = cosine;
                bisector = normals[i] + normals[j];
            }
        }
    }
    best.offer(bisector, normals);
    const double bound = std::sqrt(std::max(0.0, 0.5 * (1.0 + mostOpposed)));
    if (best.cosine >= bound - kRounding) {
        return best.direction;
    }
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = i + 1; j < m; ++j) {
            for (std::size_t k = j + 1; k < m; ++k) {
                Vec3 pole = (normals[j] - normals[i]).cross(normals[k] - normals[i]);
                if (pole.dot(normals[i]) < 0.0) {
                    pole = -pole;
                }
                best.offer(pole, normals);
            }
        }
    }
    if (best.cosine < -1.0) {
        best.direction = normals.empty() ? Vec3::UnitZ() : normals[0];
    }
    return best.direction;
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
