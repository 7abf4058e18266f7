// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "surface/triangle_tree.h"
#include "utility/go_on.h"

#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace bspline_curve {

/// What new faces cross.
struct Crossings {
    std::vector<std::pair<int, int>> pairs;  ///< of new faces that cross each other, ascending
    std::vector<int> withKept;               ///< new faces that cross kept ones, ascending

    [[nodiscard]] bool isEmpty() const { return pairs.empty() && withKept.empty(); }

    /// New faces that cross anything, ascending.
    [[nodiscard]] std::vector<int> faces() const;
};

/// Finds where new faces cross each other or those that are there, exactly: faces cross where they
/// meet anywhere but in the corners and the edge that they share by index. New faces must have
/// area. Of the mesh only what is near the new faces is prepared for that, anew where they are
/// elsewhere, O(n); the whole one when that was so a few times.
class CrossingFinder {
public:
    /// The arrays must outlive it. `vertices` may grow; those of kept faces stay where they are.
    /// `isRounded`: they were rounded to single precision, so that kept faces that this may have
    /// turned over and new ones without area do not count, and corners that became one place are
    /// one.
    CrossingFinder(
        const std::vector<Vec3>& vertices, const std::vector<Triangle>& kept, bool isRounded
    );

    /// From now on these are kept as well. O(n log n).
    void keep(const std::vector<Triangle>& faces) {
        patches_.push_back(madeReady(faces));
        last_ = {};
    }

    /// Whether a face is so narrow that rounding to single precision may turn it over.
    [[nodiscard]] bool isSliver(const Triangle& face) const;

    /// O(log n) where few kept faces are near.
    [[nodiscard]] bool crossesKept(const Triangle& face);

    /// O(n log n) where few faces overlap. Of the same faces as the last time only those are tested
    /// that have moved.
    [[nodiscard]] Crossings crossingsOf(
        const std::vector<Triangle>& faces, const GoOn& goOn = [] {}
    );

private:
    struct Kept {
        Kept(const std::vector<Vec3>& vertices, std::vector<Triangle> those)
            : faces(std::move(those)), tree(vertices, faces) {}

        std::vector<Triangle> faces;
        TriangleTree tree;
    };

    struct Checked {
        std::vector<Triangle> faces;
        std::vector<std::array<Vec3, 3>> corners;
        Crossings found;
    };

    using Box = Eigen::AlignedBox3d;

    [[nodiscard]] Box boxOf(const Triangle& face) const;
    [[nodiscard]] std::unique_ptr<const Kept> madeReady(const std::vector<Triangle>& faces) const;
    void prepareNear(const Box& box);
    [[nodiscard]] std::vector<char> movedSinceLast(const Checked& now) const;
    [[nodiscard]] std::vector<std::pair<int, int>> crossingPairs(
        const std::vector<Triangle>& faces, const std::vector<char>& hasMoved, const GoOn& tell
    ) const;
    [[nodiscard]] bool crossesPrepared(const Triangle& face) const;
    [[nodiscard]] bool isBroad(const Triangle& face, double leastHeight) const;
    [[nodiscard]] bool counts(const Triangle& face) const;
    [[nodiscard]] bool cross(const Triangle& a, const Triangle& b) const;

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& mesh_;
    bool isRounded_;
    Box region_;     // where faces of the mesh are ready
    int moves_ = 0;  // of the region
    std::unique_ptr<const Kept> near_;
    std::vector<std::unique_ptr<const Kept>> patches_;
    Checked last_;
};

}  // namespace bspline_curve
