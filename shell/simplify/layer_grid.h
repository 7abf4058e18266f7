// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/simplify/prism_complex.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// Finds where top and bottom of new prisms meet those of other prisms, or the walls where the
/// shell ends: a hashed grid over the boxes of the prisms.
class LayerGrid {
public:
    /// `endWalls`: triangles between points of the complex where the shell ends, which stay as they
    /// are.
    LayerGrid(const PrismComplex& complex, std::vector<Triangle> endWalls)
        : complex_(complex), points_(complex.points.points), endWalls_(std::move(endWalls)) {}

    /// Enters all prisms anew, in cells of the given size.
    void rebuild(double cellSize) {
        inverseCellSize_ = 1.0 / cellSize;
        enterAll();
    }

    /// Enters a prism; an id may be entered again with other pillars.
    void insert(int prism);

    /// Whether top and bottom of the prisms meet each other, those of another prism than the
    /// replaced ones, or an end wall (exact; pairs that share a pillar included).
    [[nodiscard]] bool collides(std::span<const Triangle> prisms, std::span<const int> replaced);

private:
    struct Box {
        std::array<float, 3> low{}, high{};

        [[nodiscard]] bool overlaps(const Box& other) const {
            return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
                   other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
        }

        [[nodiscard]] Box joined(const Box& other) const {
            Box box;
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = std::min(low[k], other.low[k]);
                box.high[k] = std::max(high[k], other.high[k]);
            }
            return box;
        }
    };

    // Cells from low to high along each axis.
    struct CellRange {
        std::array<std::int16_t, 3> low{}, high{};

        [[nodiscard]] bool holds(int x, int y, int z) const {
            return x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] &&
                   z <= high[2];
        }
    };

    struct Entry {
        int item;  // prism, or -1 - wall
        int next;
    };

    // Boxes of top and bottom of a prism.
    using LayerBoxes = std::array<Box, 2>;

    [[nodiscard]] static Box whole(const LayerBoxes& boxes) { return boxes[0].joined(boxes[1]); }

    [[nodiscard]] Box boxOf(const Triangle& triangle) const;
    [[nodiscard]] LayerBoxes layerBoxesOf(const Triangle& pillars) const;
    [[nodiscard]] CellRange cellsOf(const Box& box) const;
    [[nodiscard]] std::size_t slotOf(int x, int y, int z) const;
    void enterAll();
    void enterPrism(int prism);
    void enter(int item, const CellRange& cells, const CellRange* known);
    [[nodiscard]] bool meetsOthers(const Triangle& pillars, const LayerBoxes& boxes);
    [[nodiscard]] bool meetsItem(
        const Triangle& pillars, const LayerBoxes& boxes, const Box& box, int item
    );
    [[nodiscard]] bool meetsPrism(
        const Triangle& pillars,
        const LayerBoxes& boxes,
        const Triangle& other,
        const LayerBoxes& otherBoxes
    ) const;
    [[nodiscard]] bool meetsWall(const Triangle& pillars, const LayerBoxes& boxes, int wall) const;

    const PrismComplex& complex_;
    const std::vector<Vec3>& points_;  // of the complex
    std::vector<Triangle> endWalls_;
    std::vector<Box> boxes_;  // of top and bottom together of each prism, as entered
    std::vector<Box> wallBoxes_;
    std::vector<CellRange> cells_;  // that each prism was ever entered in
    std::vector<char> isEntered_;
    std::vector<int> heads_;
    std::vector<Entry> entries_;
    std::size_t entryLimit_ = 0;  // beyond it most entries are of prisms that are no more
    double inverseCellSize_ = 1.0;
    std::vector<LayerBoxes> freshBoxes_;
    std::vector<int> stamps_, wallStamps_;  // of the query that met the item last
    int stamp_ = 0;
};

}  // namespace bspline_curve
