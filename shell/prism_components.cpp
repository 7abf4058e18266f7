// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/prism_components.h"

namespace bspline_curve {
namespace {

// `neighboursOf(i)`: three prisms, -1 where there is none.
template <class IsPresent, class NeighboursOf>
PrismComponents findComponentsOf(
    std::size_t count, const IsPresent& isPresent, const NeighboursOf& neighboursOf
) {
    PrismComponents result;
    result.componentOf.assign(count, -1);
    std::vector<int> pending;
    for (int start = 0; start < static_cast<int>(count); ++start) {
        if (!isPresent(start) || result.componentOf[start] >= 0) {
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
            for (const int there : neighboursOf(prism)) {
                if (there < 0 || !isPresent(there)) {
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

}  // namespace

PrismComponents findComponents(const std::vector<Prism>& prisms) {
    return findComponentsOf(
        prisms.size(),
        [&](int i) { return prisms[i].orientation != 0; },
        [&](int i) { return prisms[i].neighbours; }
    );
}

PrismComponents findComponents(
    const std::vector<Triangle>& faceNeighbours, const std::vector<char>& blocked
) {
    return findComponentsOf(
        faceNeighbours.size(),
        [&](int i) { return blocked[i] == 0; },
        [&](int i) { return faceNeighbours[i]; }
    );
}

}  // namespace bspline_curve
