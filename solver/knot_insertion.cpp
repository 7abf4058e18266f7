// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/knot_insertion.h"

#include <algorithm>

namespace bspline_curve {
namespace {

// Spans that together promise this share of the gain are halved at once: 0.7 costs twice the
// rounds, 1.0 more knots.
constexpr double kShareOfGain = 0.9;

bool canHalve(const SplineSpace& space, int span, double minimumSpan) {
    return 0.5 * space.spanLength(span) >= minimumSpan;
}

}  // namespace

std::vector<double> halveSpans(
    const SplineSpace& space, const std::vector<char>& marked, double minimumSpan
) {
    std::vector<double> breaks{space.breaks().front()};
    for (int span = 0; span < space.spanCount(); ++span) {
        if (marked[span] != 0 && canHalve(space, span, minimumSpan)) {
            breaks.push_back(0.5 * (space.breaks()[span] + space.breaks()[span + 1]));
        }
        breaks.push_back(space.breaks()[span + 1]);
    }
    return breaks;
}

std::vector<double> halveLargest(
    const SplineSpace& space, const KnotDemand& gain, double minimumSpan
) {
    std::vector<int> order;
    double sum = 0.0;
    for (int span = 0; span < space.spanCount(); ++span) {
        if (canHalve(space, span, minimumSpan) && gain.perSpan[span] > 0.0) {
            order.push_back(span);
            sum += gain.perSpan[span];
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return gain.perSpan[a] > gain.perSpan[b];
    });
    std::vector<char> marked(gain.perSpan.size(), 0);
    double reached = 0.0;
    for (const int span : order) {
        if (reached >= kShareOfGain * sum) {
            break;
        }
        reached += gain.perSpan[span];
        marked[span] = 1;
    }
    return halveSpans(space, marked, minimumSpan);
}

}  // namespace bspline_curve
