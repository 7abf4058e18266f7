// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/near_vertices.h"

#include "surface/mesh_checks.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

using Cell = std::array<std::int64_t, 3>;

// So many cells along each axis, at most: their numbers are exact.
constexpr double kMostCells = 0x1p50;

// Unites vertices with the same coordinates; returns the first of each place, by coordinates.
std::vector<int> uniteEqual(const std::vector<Vec3>& vertices, DisjointSets& sets) {
    std::vector<int> order =
        indicesWhere<int>(vertices.size(), [&](std::size_t v) { return isUsable(vertices[v]); });
    std::ranges::sort(order, {}, [&](int v) {
        const Vec3& p = vertices[v];
        return std::tuple(p.x(), p.y(), p.z(), v);
    });
    std::vector<int> places;
    for (const int v : order) {
        if (!places.empty() && vertices[places.back()] == vertices[v]) {
            sets.unite(places.back(), v);
        } else {
            places.push_back(v);
        }
    }
    return places;
}

// Some vertices by the cells of a grid whose side is the distance, or more where that would be too
// many cells: near ones lie in cells that touch.
class Cells {
public:
    Cells(const std::vector<Vec3>& vertices, std::span<const int> places, double distance) {
        Vec3 low = vertices[places.front()];
        Vec3 high = low;
        for (const int v : places) {
            low = low.cwiseMin(vertices[v]);
            high = high.cwiseMax(vertices[v]);
        }
        // Of vertices that hardly differ, the quotient is 0.
        const double side = std::max(
            {distance, (high - low).maxCoeff() / kMostCells, std::numeric_limits<double>::min()}
        );
        for (const int v : places) {
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
    const std::vector<int> places = uniteEqual(vertices, sets);
    if (places.size() < 2) {
        return sets;
    }
    const Cells cells(vertices, places, distance);
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
