// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace bspline_curve {

/// Where a point stands on its pillar.
enum class Level : signed char { Bottom = 0, Middle = 1, Top = 2 };

/// Index of a pillar's point in PrismComplex::points.
[[nodiscard]] inline int pointOf(int pillar, Level level) {
    return 3 * pillar + static_cast<int>(level);
}

/// The pillars of a prism in the order of the split.
[[nodiscard]] inline Triangle slotsOf(Triangle pillars) {
    std::ranges::sort(pillars);
    return pillars;
}

/// +1 where the slots of a prism run counter-clockwise seen from the top, as its pillars do, else
/// -1.
[[nodiscard]] inline int orientationOf(const Triangle& pillars) {
    const Triangle slots = slotsOf(pillars);
    const std::size_t first = slots[0] == pillars[0] ? 0 : (slots[0] == pillars[1] ? 1 : 2);
    return pillars[(first + 1) % 3] == slots[1] ? 1 : -1;
}

/// The prisms of a shell while it is being simplified: plain arrays, prisms that come and go, for
/// each pillar the prisms around it, for each prism the faces of the surface that meet it.
class PrismComplex {
public:
    explicit PrismComplex(int pillarCount) : firstCorners_(pillarCount, -1) {}

    std::vector<Vec3> points;  ///< see pointOf

    [[nodiscard]] const Vec3& point(int pillar, Level level) const {
        return points[pointOf(pillar, level)];
    }

    /// Ids run from 0 to here; some are free.
    [[nodiscard]] int prismIdCount() const { return static_cast<int>(pillarsOf_.size()); }

    [[nodiscard]] int prismCount() const { return prismCount_; }

    [[nodiscard]] bool isAlive(int prism) const { return pillarsOf_[prism][0] >= 0; }

    /// Pillars of a prism, counter-clockwise seen from the top.
    [[nodiscard]] const Triangle& pillarsOf(int prism) const { return pillarsOf_[prism]; }

    [[nodiscard]] std::span<const int> facesOf(int prism) const {
        const Track& track = tracks_[prism];
        return std::span(trackPool_).subspan(track.first, track.count);
    }

    void reserve(int prismCount);

    int addPrism(const Triangle& pillars, std::span<const int> faces);
    void removePrism(int prism);
    void setFaces(int prism, std::span<const int> faces);

    /// Appends the prisms around a pillar, newest first.
    void appendPrismsAround(int pillar, std::vector<int>& prisms) const {
        for (int c = firstCorners_[pillar]; c >= 0; c = nextCorners_[c]) {
            prisms.push_back(c / 3);
        }
    }

    [[nodiscard]] bool hasPrisms(int pillar) const { return firstCorners_[pillar] >= 0; }

private:
    struct Track {
        int first = 0, count = 0;
    };

    void unlink(int pillar, int corner);
    void compactPool();

    std::vector<Triangle> pillarsOf_;
    std::vector<int>
        firstCorners_;              // of each pillar: a corner (3 * prism + k) of a prism around it
    std::vector<int> nextCorners_;  // of each corner: the next one at the same pillar
    std::vector<Track> tracks_;
    std::vector<int> trackPool_;
    std::vector<int> freeIds_;
    std::size_t usedPool_ = 0;
    int prismCount_ = 0;
};

}  // namespace bspline_curve
