// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/pillar_points.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <span>
#include <vector>

namespace bspline_curve {

/// The pillars of a prism in the order of the split.
[[nodiscard]] inline Triangle slotsOf(Triangle pillars) {
    std::ranges::sort(pillars);
    return pillars;
}

/// The orientation of a prism whose pillars run counter-clockwise seen from the top.
[[nodiscard]] inline int orientationOf(const Triangle& pillars) {
    const Triangle slots = slotsOf(pillars);
    return pillars[(cornerOf(pillars, slots[0]) + 1) % 3] == slots[1] ? 1 : -1;
}

/// The prisms of a shell while it is being simplified: plain arrays, prisms that come and go, for
/// each pillar the prisms around it, for each prism the faces of the surface that meet it.
class PrismComplex {
public:
    explicit PrismComplex(const std::vector<Pillar>& pillars)
        : points(pillars), firstCorners_(pillars.size(), -1) {}

    PillarPoints points;

    [[nodiscard]] const Vec3& point(int pillar, Level level) const {
        return points.at(pillar, level);
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

    /// The prism that runs from one pillar to another counter-clockwise, or -1.
    [[nodiscard]] int prismAlong(int from, int to) const {
        for (int c = firstCorners_[from]; c >= 0; c = nextCorners_[c]) {
            if (pillarsOf_[c / 3][(c % 3 + 1) % 3] == to) {
                return c / 3;
            }
        }
        return -1;
    }

    [[nodiscard]] bool hasEdge(int a, int b) const {
        return prismAlong(a, b) >= 0 || prismAlong(b, a) >= 0;
    }

    [[nodiscard]] bool hasPrisms(int pillar) const { return firstCorners_[pillar] >= 0; }

private:
    struct Track {
        int first = 0, count = 0;
    };

    void compactPool();

    std::vector<Triangle> pillarsOf_;
    std::vector<int> firstCorners_;  // of each pillar: a corner, 3 * prism + k, at it
    std::vector<int> nextCorners_;   // of each corner: the next one at the same pillar
    std::vector<Track> tracks_;
    std::vector<int> trackPool_;
    std::vector<int> freeIds_;
    std::size_t usedPool_ = 0;
    int prismCount_ = 0;
};

}  // namespace bspline_curve
