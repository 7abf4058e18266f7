// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "surface/predicates.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// Where a point stands on its pillar.
enum class Level : signed char { Bottom, Middle, Top };

/// The outer levels of the slabs of a prism: slab 0 is above the middle, slab 1 below it.
inline constexpr std::array<Level, 2> kOuterLevels = {Level::Top, Level::Bottom};

/// The points of pillars: bottom, middle and top of the first one, then of the second one …
struct PillarPoints {
    static constexpr int kLevels = 3;

    PillarPoints() = default;
    explicit PillarPoints(const std::vector<Pillar>& pillars);

    [[nodiscard]] static int indexOf(int pillar, Level level) {
        return kLevels * pillar + static_cast<int>(level);
    }

    [[nodiscard]] const Vec3& at(int pillar, Level level) const {
        return points[indexOf(pillar, level)];
    }

    [[nodiscard]] Pillar pillar(int i) const {
        return {at(i, Level::Bottom), at(i, Level::Middle), at(i, Level::Top)};
    }

    void set(int i, const Pillar& pillar) {
        points[indexOf(i, Level::Bottom)] = pillar.bottom;
        points[indexOf(i, Level::Middle)] = pillar.middle;
        points[indexOf(i, Level::Top)] = pillar.top;
    }

    std::vector<Vec3> points;
};

/// The corners of a tetrahedron of a prism (0 to 5) whose slots are these pillars, as indices of
/// PillarPoints, in the order of kSlabSplit.
[[nodiscard]] std::array<int, 4> tetrahedronPoints(const Triangle& slots, int inPrism);

/// The four triangles of the wall opposite to a slot, split like its prism, as indices of
/// PillarPoints.
[[nodiscard]] std::array<Triangle, 4> wallTriangles(const Triangle& slots, std::size_t slot);

/// Top or bottom of a prism, as indices of PillarPoints.
[[nodiscard]] inline Triangle layerTriangle(const Triangle& pillars, Level level) {
    return {
        PillarPoints::indexOf(pillars[0], level),
        PillarPoints::indexOf(pillars[1], level),
        PillarPoints::indexOf(pillars[2], level)
    };
}

/// One half of a prism, between the middle and top or bottom.
struct Slab {
    const PillarPoints& points;
    Triangle slots;   ///< the pillars, ascending
    int orientation;  ///< of the prism
    int slab;         ///< 0: above the middle, 1: below it

    /// The corners of tetrahedron i (0 to 2), in the order of kSlabSplit.
    [[nodiscard]] std::array<const Vec3*, 4> corners(std::size_t i) const {
        std::array<const Vec3*, 4> result{};
        for (std::size_t k = 0; k < 4; ++k) {
            const SplitVertex vertex = kSlabSplit[i][k];
            result[k] =
                &points.at(slots[vertex.slot], vertex.outer ? kOuterLevels[slab] : Level::Middle);
        }
        return result;
    }

    /// Whether every tetrahedron has positive volume (exact).
    [[nodiscard]] bool isPositive() const {
        for (std::size_t i = 0; i < kSlabSplit.size(); ++i) {
            const auto [a, b, c, d] = corners(i);
            if (orientationSign(*a, *b, *c, *d) != sign()) {
                return false;
            }
        }
        return true;
    }

    /// Whether the slab, which is positive, holds a point; its boundary counts (exact).
    [[nodiscard]] bool holds(const Vec3& point) const;

private:
    /// The orientation of the tetrahedra as kSlabSplit lists their corners.
    [[nodiscard]] int sign() const { return slab == 0 ? orientation : -orientation; }
};

}  // namespace bspline_curve
