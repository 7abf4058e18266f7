// SPDX-License-Identifier: GPL-3.0-or-later
// Directions of fine surfaces, smooth at a scale that faces do not have.
#include "shell/extended_surface.h"
#include "shell/pillar_directions.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kSmoothingPasses = 3;
// Squares along a side of plates.
constexpr int kFine = 440;
constexpr int kCoarse = 220;
// Of noise, in edges.
constexpr double kRoughness = 0.2;

Surface noisyPlate(int squares) {
    return Surface(withNoise(plate(squares, squares), kRoughness / squares, 7));
}

// How far directions of a plate are turned from its own, root mean square.
double unevenness(const ExtendedSurface& extended) {
    double sum = 0.0;
    for (int v = 0; v < extended.surfaceVertexCount; ++v) {
        sum += extended.directions[v].head<2>().squaredNorm();
    }
    return std::sqrt(sum / extended.surfaceVertexCount);
}

TEST(PatchDirections, AreForFineSurfacesAlone) {
    const PatchLevels coarse{noisyPlate(kCoarse)};
    EXPECT_FALSE(coarse.levels().empty());
    EXPECT_EQ(patchesToSmoothOver(coarse), nullptr);
    const PatchLevels fine{noisyPlate(kFine)};
    EXPECT_EQ(patchesToSmoothOver(fine), &fine.levels().front());
}

// Noise as high as edges are long turns the directions of either alike, but for patches.
TEST(PatchDirections, AreSmootherThanFacesAre) {
    const Surface surface = noisyPlate(kFine);
    const double coarse = unevenness(extendSurface(noisyPlate(kCoarse), kSmoothingPasses));
    const double fine = unevenness(extendSurface(surface, kSmoothingPasses));
    EXPECT_LT(fine, 0.6 * coarse);
    EXPECT_GT(fine, 0.0);
    const double rough = unevenness(extendSurface(surface, 0));
    EXPECT_EQ(rough, unevenness(makeRoughBase(surface).extended));
    EXPECT_GT(rough, 3.0 * fine);
}

TEST(PatchDirections, SeeAllFaces) {
    const Surface surface(box(200));
    const PatchLevels patches(surface);
    ASSERT_NE(patchesToSmoothOver(patches), nullptr);
    const ExtendedSurface extended = extendSurface(surface, kSmoothingPasses);
    const RoughBase rough = makeRoughBase(surface);
    for (int v = 0; v < surface.vertexCount(); ++v) {
        std::vector<Vec3> normals;
        for (const int face : surface.facesAround(v)) {
            normals.push_back(rough.faceNormals[face]);
        }
        const double before = leastCosine(rough.extended.directions[v], std::span(normals));
        const double after = leastCosine(extended.directions[v], std::span(normals));
        EXPECT_GE(after, std::min(before, 0.8) - 1e-12);
    }
    // Averages over three rings alone reach no farther than these.
    const auto turnAt = [&](double distance) {
        double largest = 0.0;
        for (int v = 0; v < surface.vertexCount(); ++v) {
            const Vec3& p = surface.vertices()[v];
            const bool isOnTop = p.z() == 1.0 && std::abs(p.y() - 0.5) < 0.1;
            if (isOnTop && std::abs(1.0 - p.x() - distance) < 1e-9) {
                largest = std::max(largest, extended.directions[v].x());
            }
        }
        return largest;
    };
    EXPECT_GT(turnAt(5.0 / 200.0), 1e-3);
    EXPECT_LT(turnAt(5.0 / 200.0), turnAt(3.0 / 200.0));
    EXPECT_LT(turnAt(0.2), 1e-9);
}

}  // namespace
}  // namespace bspline_curve
