// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/operations.h"
#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve {
namespace {

// A flip has to make the worse triangle better by this factor.
constexpr double kWorthwhile = 1.1;

class Flipper {
public:
    Flipper(ShellEditor& editor, const Creases& creases) : editor_(editor), creases_(creases) {}

    // Flips the edge from corner k of a prism to the next.
    bool flip(int prism, std::size_t k) {
        const Triangle pillars = complex().pillarsOf(prism);
        const int a = pillars[k];
        const int b = pillars[(k + 1) % 3];
        const int c = pillars[(k + 2) % 3];
        const int across = prismAlong(b, a);
        if (across < 0 || creases_.holdEdge(a, b)) {
            return false;
        }
        const Triangle& other = complex().pillarsOf(across);
        const int d = other[(cornerOf(other, b) + 2) % 3];
        const double now = std::min(editor_.quality(pillars), editor_.quality(other));
        editor_.old = {prism, across};
        editor_.fresh = {{c, a, d}, {d, b, c}};
        return editor_.leastQuality() > kWorthwhile * now && prismAlong(c, d) < 0 &&
               prismAlong(d, c) < 0 && editor_.replace();
    }

private:
    [[nodiscard]] const PrismComplex& complex() const { return editor_.complex(); }

    // The prism that runs from one pillar to another counter-clockwise, or -1.
    [[nodiscard]] int prismAlong(int from, int to) {
        around_.clear();
        complex().appendPrismsAround(from, around_);
        const auto found = std::ranges::find_if(around_, [&](int prism) {
            const Triangle& pillars = complex().pillarsOf(prism);
            return pillars[(cornerOf(pillars, from) + 1) % 3] == to;
        });
        return found == around_.end() ? -1 : *found;
    }

    ShellEditor& editor_;
    const Creases& creases_;
    std::vector<int> around_;
};

}  // namespace

void flipEdges(ShellEditor& editor, const Creases& creases) {
    Flipper flipper(editor, creases);
    for (int prism = 0; prism < editor.complex().prismIdCount(); ++prism) {
        for (std::size_t k = 0; k < 3 && editor.complex().isAlive(prism); ++k) {
            const Triangle& pillars = editor.complex().pillarsOf(prism);
            if (pillars[k] < pillars[(k + 1) % 3] && flipper.flip(prism, k)) {
                break;
            }
        }
    }
}

}  // namespace bspline_curve
