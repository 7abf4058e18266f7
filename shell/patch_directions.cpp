// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/patch_directions.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <utility>

namespace bspline_curve {
namespace {

// Patches as large as the faces of a surface with so many, whose edges are 0.005 times the root of
// its area. With 20,000 curves are as quick on fine surfaces, but directions follow the surface
// less closely than on one of 100,000 faces.
constexpr int kFewestPatches = 80000;
// Averages over the neighbours, of the largest patches and on the way back to the finest. With 4 or
// 5 of the first curves take as many steps.
constexpr int kPasses = 3;
constexpr int kPassesBack = 2;

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

const PatchLevels::Level* patchesToSmoothOver(const PatchLevels& patches) {
    const PatchLevels::Level* largest = nullptr;
    for (const PatchLevels::Level& level : patches.levels()) {
        if (level.count() >= kFewestPatches) {
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
    smooth(*largest, kPasses, directions);
    for (const PatchLevels::Level* level = largest; level != finest;) {
        const std::vector<int>& patchOf = (level--)->patchOf;
        std::vector<Vec3> finer;
        finer.reserve(patchOf.size());
        for (const int patch : patchOf) {
            finer.push_back(directions[patch]);
        }
        directions = std::move(finer);
        smooth(*level, kPassesBack, directions);
    }
    return directions;
}

}  // namespace bspline_curve
