// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/near_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace bspline_curve {
namespace {

using Cell = std::array<std::int64_t, 3>;

// Vertices by the cells of a grid whose side is the distance: near ones lie in cells that touch.
class Cells {
public:
    Cells(const std::vector<Vec3>& vertices, double side) {
        Vec3 low = vertices.front();
        for (const Vec3& p : vertices) {
            low = low.cwiseMin(p);
        }
        for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
            const Vec3 at = (vertices[v] - low) / side;
            entries_.push_back(
                {{static_cast<std::int64_t>(std::floor(at.x())),
                  static_cast<std::int64_t>(std::floor(at.y())),
                  static_cast<std::int64_t>(std::floor(at.z()))},
                 v}
            );
        }
        std::ranges::sort(entries_);
    }

    struct Entry {
        Cell cell;
        int vertex;
        auto operator<=>(const Entry&) const = default;
    };

    [[nodiscard]] std::span<const Entry> all() const { return entries_; }

    /// Those of a row of three cells along z.
    [[nodiscard]] std::span<const Entry> row(const Cell& middle) const {
        const Cell first = {middle[0], middle[1], middle[2] - 1};
        const Cell last = {middle[0], middle[1], middle[2] + 1};
        const auto begin = std::ranges::lower_bound(entries_, first, {}, &Entry::cell);
        return {begin, std::ranges::upper_bound(begin, entries_.end(), last, {}, &Entry::cell)};
    }

private:
    std::vector<Entry> entries_;
};

}  // namespace

DisjointSets nearVertices(const std::vector<Vec3>& vertices, double distance) {
    DisjointSets sets(vertices.size());
    if (vertices.empty()) {
        return sets;
    }
    const Cells cells(vertices, distance);
    for (const auto& [cell, vertex] : cells.all()) {
        for (std::int64_t x = cell[0]; x <= cell[0] + 1; ++x) {
            for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
                for (const auto& [otherCell, other] : cells.row({x, y, cell[2]})) {
                    if ((vertices[vertex] - vertices[other]).norm() <= distance) {
                        sets.unite(vertex, other);
                    }
                }
            }
        }
    }
    return sets;
}

}  // namespace bspline_curve
