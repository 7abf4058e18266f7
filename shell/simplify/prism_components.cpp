// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/prism_components.h"

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

PrismComponents findComponents(const std::vector<Prism>& prisms) {
    PrismComponents result;
    result.componentOf.assign(prisms.size(), -1);
    std::vector<int> pending;
    for (int start = 0; start < static_cast<int>(prisms.size()); ++start) {
        if (prisms[at(start)].orientation == 0 || result.componentOf[at(start)] >= 0) {
            continue;
        }
        const int component = static_cast<int>(result.first.size());
        result.first.push_back(start);
        result.componentOf[at(start)] = component;
        pending.assign(1, start);
        while (!pending.empty()) {
            const int prism = pending.back();
            pending.pop_back();
            for (const int there : prisms[at(prism)].neighbours) {
                if (there >= 0 && result.componentOf[at(there)] < 0) {
                    result.componentOf[at(there)] = component;
                    pending.push_back(there);
                }
            }
        }
    }
    return result;
}

}  // namespace bspline_curve
