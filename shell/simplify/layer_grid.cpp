// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/layer_grid.h"

#include "shell/simplify/tracked_surface.h"
#include "surface/self_intersection.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bspline_curve {
namespace {

// All prisms are entered anew where there are this many times the entries that this makes, and so
// many more: most entries are then of prisms that are gone.
constexpr double kEntryGrowth = 1.5;
constexpr std::size_t kSpareEntries = 4096;
// Coordinates in the shell's frame are above this.
constexpr double kLowest = -4.0;

}  // namespace

LayerGrid::Box LayerGrid::boxOf(const Triangle& triangle) const {
    const Vec3& a = points_[triangle[0]];
    const Vec3& b = points_[triangle[1]];
    const Vec3& c = points_[triangle[2]];
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.low[k] = static_cast<float>(std::min({a[k], b[k], c[k]})) - kFloatMargin;
        box.high[k] = static_cast<float>(std::max({a[k], b[k], c[k]})) + kFloatMargin;
    }
    return box;
}

LayerGrid::LayerBoxes LayerGrid::layerBoxesOf(const Triangle& pillars) const {
    return {
        boxOf(layerTriangle(pillars, Level::Top)), boxOf(layerTriangle(pillars, Level::Bottom))
    };
}

LayerGrid::CellRange LayerGrid::cellsOf(const Box& box) const {
    CellRange cells;
    constexpr double kHighest = std::numeric_limits<std::int16_t>::max();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto cell = [&](float x) {
            return static_cast<std::int16_t>(
                std::clamp((static_cast<double>(x) - kLowest) * inverseCellSize_, 0.0, kHighest)
            );
        };
        cells.low[k] = cell(box.low[k]);
        cells.high[k] = cell(box.high[k]);
    }
    return cells;
}

std::size_t LayerGrid::slotOf(int x, int y, int z) const {
    const auto hash = static_cast<std::uint32_t>(x) * 73856093U ^
                      static_cast<std::uint32_t>(y) * 19349663U ^
                      static_cast<std::uint32_t>(z) * 83492791U;
    return hash & (heads_.size() - 1);
}

void LayerGrid::enter(int item, const CellRange& cells, const CellRange* known) {
    for (int x = cells.low[0]; x <= cells.high[0]; ++x) {
        for (int y = cells.low[1]; y <= cells.high[1]; ++y) {
            for (int z = cells.low[2]; z <= cells.high[2]; ++z) {
                if (known == nullptr || !known->holds(x, y, z)) {
                    int& head = heads_[slotOf(x, y, z)];
                    entries_.push_back({item, head});
                    head = static_cast<int>(entries_.size()) - 1;
                }
            }
        }
    }
}

void LayerGrid::enterAll() {
    const auto ids = complex_.prismIdCount();
    heads_.assign(std::bit_ceil(complex_.prismCount() + endWalls_.size() + 1), -1);
    entries_.clear();
    boxes_.resize(ids);
    cells_.resize(ids);
    isEntered_.assign(ids, 0);
    stamps_.assign(ids, 0);
    wallStamps_.assign(endWalls_.size(), 0);
    stamp_ = 0;
    for (int prism = 0; prism < complex_.prismIdCount(); ++prism) {
        if (complex_.isAlive(prism)) {
            enterPrism(prism);
        }
    }
    wallBoxes_.clear();
    for (std::size_t i = 0; i < endWalls_.size(); ++i) {
        wallBoxes_.push_back(boxOf(endWalls_[i]));
        enter(-1 - static_cast<int>(i), cellsOf(wallBoxes_.back()), nullptr);
    }
    entryLimit_ = static_cast<std::size_t>(kEntryGrowth * static_cast<double>(entries_.size())) +
                  kSpareEntries;
}

void LayerGrid::insert(int prism) {
    enterPrism(prism);
    if (entries_.size() > entryLimit_) {
        enterAll();
    }
}

void LayerGrid::enterPrism(int prism) {
    boxes_[prism] = whole(layerBoxesOf(complex_.pillarsOf(prism)));
    CellRange cells = cellsOf(boxes_[prism]);
    const CellRange known = cells_[prism];
    const bool isEntered = std::exchange(isEntered_[prism], 1) != 0;
    for (std::size_t k = 0; isEntered && k < 3; ++k) {
        cells.low[k] = std::min(cells.low[k], known.low[k]);
        cells.high[k] = std::max(cells.high[k], known.high[k]);
    }
    enter(prism, cells, isEntered ? &known : nullptr);
    cells_[prism] = cells;
}

bool LayerGrid::meetsPrism(
    const Triangle& pillars,
    const LayerBoxes& boxes,
    const Triangle& other,
    const LayerBoxes& otherBoxes
) const {
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            if (boxes[i].overlaps(otherBoxes[j]) && trianglesIntersect(
                                                        points_,
                                                        layerTriangle(pillars, kOuterLevels[i]),
                                                        layerTriangle(other, kOuterLevels[j])
                                                    )) {
                return true;
            }
        }
    }
    return false;
}

bool LayerGrid::meetsWall(const Triangle& pillars, const LayerBoxes& boxes, int wall) const {
    for (std::size_t i = 0; i < 2; ++i) {
        if (boxes[i].overlaps(wallBoxes_[wall]) &&
            trianglesIntersect(points_, layerTriangle(pillars, kOuterLevels[i]), endWalls_[wall])) {
            return true;
        }
    }
    return false;
}

// Whether a prism meets an entered item that was not met in this query yet.
bool LayerGrid::meetsItem(
    const Triangle& pillars, const LayerBoxes& boxes, const Box& box, int item
) {
    if (item < 0) {
        const int wall = -1 - item;
        return std::exchange(wallStamps_[wall], stamp_) != stamp_ &&
               meetsWall(pillars, boxes, wall);
    }
    if (stamps_[item] >= stamp_ || !complex_.isAlive(item)) {
        return false;
    }
    stamps_[item] = stamp_;
    const Triangle& other = complex_.pillarsOf(item);
    return box.overlaps(boxes_[item]) && meetsPrism(pillars, boxes, other, layerBoxesOf(other));
}

bool LayerGrid::meetsOthers(const Triangle& pillars, const LayerBoxes& boxes) {
    const Box box = whole(boxes);
    const CellRange cells = cellsOf(box);
    for (int x = cells.low[0]; x <= cells.high[0]; ++x) {
        for (int y = cells.low[1]; y <= cells.high[1]; ++y) {
            for (int z = cells.low[2]; z <= cells.high[2]; ++z) {
                for (int i = heads_[slotOf(x, y, z)]; i >= 0; i = entries_[i].next) {
                    if (meetsItem(pillars, boxes, box, entries_[i].item)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

bool LayerGrid::collides(std::span<const Triangle> prisms, std::span<const int> replaced) {
    freshBoxes_.clear();
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        freshBoxes_.push_back(layerBoxesOf(prisms[i]));
        for (std::size_t j = 0; j < i; ++j) {
            if (meetsPrism(prisms[i], freshBoxes_[i], prisms[j], freshBoxes_[j])) {
                return true;
            }
        }
    }
    const int first = stamp_;
    stamp_ += static_cast<int>(prisms.size());
    for (const int prism : replaced) {
        stamps_[prism] = stamp_;
    }
    const int last = std::exchange(stamp_, first);
    bool collides = false;
    for (std::size_t i = 0; i < prisms.size() && !collides; ++i) {
        ++stamp_;
        collides = meetsOthers(prisms[i], freshBoxes_[i]);
    }
    stamp_ = last;
    return collides;
}

}  // namespace bspline_curve
