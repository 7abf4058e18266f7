// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/prism_graph.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <compare>

namespace bspline_curve {
namespace {

// A wall of a prism by its pillars.
struct Wall {
    int low, high;
    int prism, slot;

    auto operator<=>(const Wall&) const = default;
};

void setNeighbour(std::vector<Prism>& prisms, const Wall& wall, const Wall& opposite) {
    prisms[wall.prism].neighbours[wall.slot] = opposite.prism;
    prisms[wall.prism].neighbourWalls[wall.slot] = static_cast<signed char>(opposite.slot);
}

}  // namespace

Prism prismOver(const Triangle& face) {
    Prism prism;
    prism.pillars = face;
    std::ranges::sort(prism.pillars);
    for (std::size_t slot = 0; slot < 3; ++slot) {
        prism.faceCorner[slot] = static_cast<signed char>(cornerOf(face, prism.pillars[slot]));
    }
    prism.orientation = (prism.faceCorner[1] - prism.faceCorner[0] + 3) % 3 == 1 ? 1 : -1;
    prism.neighbours = {-1, -1, -1};
    return prism;
}

// Wall k is opposite to slot k, hence to corner faceCorner[k] of the face.
void connectPrisms(std::vector<Prism>& prisms, const std::vector<Triangle>& faceNeighbours) {
    for (std::size_t f = 0; f < prisms.size(); ++f) {
        Prism& prism = prisms[f];
        for (std::size_t slot = 0; prism.orientation != 0 && slot < 3; ++slot) {
            const int there = faceNeighbours[f][prism.faceCorner[slot]];
            if (there < 0 || prisms[there].orientation == 0) {
                continue;
            }
            prism.neighbours[slot] = there;
            const Prism& other = prisms[there];
            for (std::size_t k = 0; k < 3; ++k) {
                // Two faces may be neighbours across two edges.
                if (faceNeighbours[there][other.faceCorner[k]] == static_cast<int>(f) &&
                    other.pillars[k] != prism.pillars[(slot + 1) % 3] &&
                    other.pillars[k] != prism.pillars[(slot + 2) % 3]) {
                    prism.neighbourWalls[slot] = static_cast<signed char>(k);
                }
            }
        }
    }
}

void connectPrisms(std::vector<Prism>& prisms) {
    std::vector<Wall> walls;
    walls.reserve(3 * prisms.size());
    for (int i = 0; i < static_cast<int>(prisms.size()); ++i) {
        const std::array<int, 3>& p = prisms[i].pillars;
        walls.insert(walls.end(), {{p[1], p[2], i, 0}, {p[0], p[2], i, 1}, {p[0], p[1], i, 2}});
    }
    std::ranges::sort(walls);
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
        const Wall& here = walls[i];
        const Wall& there = walls[i + 1];
        if (here.low == there.low && here.high == there.high) {
            setNeighbour(prisms, here, there);
            setNeighbour(prisms, there, here);
        }
    }
}

PrismComponents findComponents(const std::vector<Prism>& prisms) {
    PrismComponents result;
    result.componentOf.assign(prisms.size(), -1);
    std::vector<int> pending;
    for (int start = 0; start < static_cast<int>(prisms.size()); ++start) {
        if (prisms[start].orientation == 0 || result.componentOf[start] >= 0) {
            continue;
        }
        const int component = result.count();
        result.first.push_back(start);
        result.isClosed.push_back(1);
        result.componentOf[start] = component;
        pending.assign(1, start);
        while (!pending.empty()) {
            const int prism = pending.back();
            pending.pop_back();
            for (const int there : prisms[prism].neighbours) {
                if (there < 0 || prisms[there].orientation == 0) {
                    result.isClosed.back() = 0;
                } else if (result.componentOf[there] < 0) {
                    result.componentOf[there] = component;
                    pending.push_back(there);
                }
            }
        }
    }
    return result;
}

}  // namespace bspline_curve
