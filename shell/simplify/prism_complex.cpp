// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/prism_complex.h"

#include <utility>

namespace bspline_curve {
void PrismComplex::reserve(int prismCount) {
    pillarsOf_.reserve(prismCount);
    nextCorners_.reserve(3 * prismCount);
    tracks_.reserve(prismCount);
    trackPool_.reserve(prismCount);
}

int PrismComplex::addPrism(const Triangle& pillars, std::span<const int> faces) {
    int prism = prismIdCount();
    if (freeIds_.empty()) {
        pillarsOf_.push_back(pillars);
        nextCorners_.insert(nextCorners_.end(), 3, -1);
        tracks_.emplace_back();
    } else {
        prism = freeIds_.back();
        freeIds_.pop_back();
        pillarsOf_[prism] = pillars;
    }
    for (int k = 0; k < 3; ++k) {
        int& first = firstCorners_[pillars[k]];
        nextCorners_[3 * prism + k] = std::exchange(first, 3 * prism + k);
    }
    ++prismCount_;
    tracks_[prism] = {};
    setFaces(prism, faces);
    return prism;
}

void PrismComplex::removePrism(int prism) {
    for (int k = 0; k < 3; ++k) {
        int* link = &firstCorners_[pillarsOf_[prism][k]];
        while (*link != 3 * prism + k) {
            link = &nextCorners_[*link];
        }
        *link = nextCorners_[3 * prism + k];
    }
    pillarsOf_[prism] = {-1, -1, -1};
    usedPool_ -= tracks_[prism].count;
    tracks_[prism] = {};
    freeIds_.push_back(prism);
    --prismCount_;
}

void PrismComplex::setFaces(int prism, std::span<const int> faces) {
    Track& track = tracks_[prism];
    usedPool_ += faces.size() - track.count;
    if (std::ssize(faces) > track.count) {
        if (trackPool_.size() + faces.size() > trackPool_.capacity()) {
            track.count = 0;  // not to be kept
            compactPool();
        }
        track.first = static_cast<int>(trackPool_.size());
        trackPool_.insert(trackPool_.end(), faces.begin(), faces.end());
    } else {
        std::ranges::copy(faces, trackPool_.begin() + track.first);
    }
    track.count = static_cast<int>(faces.size());
}

void PrismComplex::compactPool() {
    constexpr std::size_t kSpare = 4096;
    std::vector<int> pool;
    pool.reserve(usedPool_ + usedPool_ / 2 + kSpare);
    for (Track& track : tracks_) {
        const auto first = trackPool_.begin() + track.first;
        track.first = static_cast<int>(pool.size());
        pool.insert(pool.end(), first, first + track.count);
    }
    trackPool_.swap(pool);
}

}  // namespace bspline_curve
