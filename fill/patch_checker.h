// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/crossing_finder.h"
#include "fill/patch_refinement.h"
#include "utility/go_on.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Faces of a patch, ascending, that cross others.
struct PatchCrossings {
    std::vector<int> clearly;   ///< also where slivers of single precision do not count
    std::vector<int> narrowly;  ///< where these count, if none does clearly

    [[nodiscard]] bool isEmpty() const { return clearly.empty() && narrowly.empty(); }

    [[nodiscard]] std::vector<int> all() const;

    /// The less the better.
    [[nodiscard]] std::pair<std::size_t, std::size_t> counts() const;
};

[[nodiscard]] bool hasFlatFace(const Patch& patch);

/// The inner points of some of its faces, numbered from 0 behind the rim, ascending.
[[nodiscard]] std::vector<int> innerCorners(const Patch& patch, const std::vector<int>& faces);

/// Checks patches for the rims of a mesh, one after the other, against the mesh, the patches before
/// and themselves: as they are, and rounded to single precision, as in many files and programs,
/// unless what is around a rim is too fine for that. Exact; O(n log n) where few faces overlap.
class PatchChecker {
public:
    explicit PatchChecker(const TriangleMesh& mesh);

    /// From now on patches are for this rim, around which edges are that long at least. `goOn` is
    /// called before a check and in its middle; where it throws, the checker is of no more use.
    void begin(const std::vector<int>& rim, double leastSize, GoOn goOn = [] {});

    /// From now on a patch for the rim is part of the mesh.
    void keep(const Patch& patch);

    /// Its faces with vertices of the mesh, new ones behind those that there are.
    [[nodiscard]] std::vector<Triangle> placed(const Patch& patch) const;

    /// The faces of the patch need area.
    [[nodiscard]] PatchCrossings crossingsOf(const Patch& patch);

    /// Faces that have no area; where all have some, those that clearly cross others; where none
    /// does and `isStrict`, those that narrowly do.
    [[nodiscard]] std::vector<int> badFaces(const Patch& patch, bool isStrict);

    /// Of faces that cross each other and have area.
    [[nodiscard]] std::vector<std::pair<int, int>> crossingPairs(const Patch& patch);

    /// Whether a triangle of three points of the rim crosses nothing that is kept; false where too
    /// many were tested.
    [[nodiscard]] bool isFree(const Triangle& places);

private:
    template <class Use>
    void withPlaced(const Patch& patch, const Use& use);

    std::vector<Vec3> vertices_;
    std::vector<Vec3> rounded_;  // those, in single precision
    CrossingFinder finder_;
    CrossingFinder roundedFinder_;
    double largest_ = 0.0;  // coordinate
    std::vector<int> rim_;
    GoOn goOn_ = [] {};
    int testsLeft_ = 0;    // of triangles of the rim's points
    bool isFine_ = false;  // what is around the rim
};

}  // namespace bspline_curve
