// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_measures.h"

#include "io/shell_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace bspline_curve {

namespace {

/// The share-th quantile of ascending values, linear between the two nearest.
double quantile(const std::vector<double>& ascending, double share) {
    const double place = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    return std::lerp(ascending[below], ascending[above], place - static_cast<double>(below));
}

}  // namespace

PrismCounts countPrisms(const Shell& shell) {
    PrismCounts counts;
    std::vector<char> isUsed(shell.pillars().size(), 0);
    for (int i = 0; i < static_cast<int>(shell.prisms().size()); ++i) {
        const Prism& prism = shell.prisms()[i];
        if (prism.orientation != 0) {
            ++counts.all;
            counts.ghosts += isGhostPrism(shell, i) ? 1 : 0;
            for (const int pillar : prism.pillars) {
                isUsed[pillar] = 1;
            }
        }
    }
    counts.pillars = static_cast<int>(std::ranges::count(isUsed, 1));
    return counts;
}

ShellThickness measureThickness(
    const Surface& surface, const ShellFrame& frame, const Shell& shell
) {
    std::vector<char> isMeasured(shell.pillars().size(), 0);
    for (int i = 0; i < static_cast<int>(shell.prisms().size()); ++i) {
        const Prism& prism = shell.prisms()[i];
        if (prism.orientation != 0 && !isGhostPrism(shell, i)) {
            for (const int pillar : prism.pillars) {
                isMeasured[pillar] = 1;
            }
        }
    }
    const double unit = longestSideOf(surface) / frame.scale;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < isMeasured.size(); ++i) {
        if (isMeasured[i] != 0) {
            const Pillar& pillar = shell.pillars()[i];
            const double length =
                (pillar.top - pillar.middle).norm() + (pillar.middle - pillar.bottom).norm();
            lengths.push_back(length / unit);
        }
    }
    if (lengths.empty()) {
        return {};
    }
    std::ranges::sort(lengths);
    constexpr double kLowShare = 0.05;
    return {
        .mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) /
                static_cast<double>(lengths.size()),
        .p5 = quantile(lengths, kLowShare),
        .min = lengths.front()
    };
}

}  // namespace bspline_curve
