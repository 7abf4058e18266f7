// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/stroke_digits.h"

#include <array>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

struct GridPoint {
    double x, y;
};

struct GridLine {
    std::vector<GridPoint> points;
    bool closed = false;
};

constexpr double kDigitHeight = 6.0;
constexpr double kDigitStep = 5.9;  // from a digit to the next
constexpr double kDigitWidth = 4.0;

// On a grid of 4 by 6, from the lower left.
const std::array<std::vector<GridLine>, 10>& digits() {
    static const std::array<std::vector<GridLine>, 10> all = {{
        {{{{1, 0}, {3, 0}, {4, 1.2}, {4, 4.8}, {3, 6}, {1, 6}, {0, 4.8}, {0, 1.2}}, true}},
        {{{{0.8, 4.9}, {2.2, 6}, {2.2, 0}}}},
        {{{{0, 5}, {1, 6}, {3, 6}, {4, 5}, {4, 3.9}, {0, 0}, {4, 0}}}},
        {{{{0, 6}, {4, 6}, {1.9, 3.6}, {3, 3.6}, {4, 2.5}, {4, 1}, {3, 0}, {1, 0}, {0, 0.9}}}},
        {{{{3.1, 0}, {3.1, 6}, {0, 1.8}, {4.2, 1.8}}}},
        {{{{3.8, 6},
           {0.5, 6},
           {0.2, 3.2},
           {1.2, 3.7},
           {3, 3.7},
           {4, 2.6},
           {4, 1.1},
           {3, 0},
           {1, 0},
           {0, 0.8}}}},
        {{{{3.7, 5.3},
           {2.9, 6},
           {1.2, 6},
           {0, 4.6},
           {0, 1.1},
           {1, 0},
           {3, 0},
           {4, 1.1},
           {4, 2.4},
           {3, 3.5},
           {1, 3.5},
           {0, 2.4}}}},
        {{{{0, 6}, {4, 6}, {1.5, 0}}}},
        {{{{1, 0}, {3, 0}, {4, 1}, {4, 2.2}, {3, 3.2}, {1, 3.2}, {0, 2.2}, {0, 1}}, true},
         {{{1, 3.2}, {3, 3.2}, {3.8, 4.1}, {3.8, 5.1}, {3, 6}, {1, 6}, {0.2, 5.1}, {0.2, 4.1}},
          true}},
        {{{{0.3, 0.7},
           {1.1, 0},
           {2.8, 0},
           {4, 1.4},
           {4, 4.9},
           {3, 6},
           {1, 6},
           {0, 4.9},
           {0, 3.6},
           {1, 2.5},
           {3, 2.5},
           {4, 3.6}}}},
    }};
    return all;
}

}  // namespace

std::vector<ScreenLine> strokesOf(int number, const Eigen::Vector2d& centre, double height) {
    const std::string text = std::to_string(number);
    const double scale = height / kDigitHeight;
    const double width = kDigitStep * (static_cast<double>(text.size()) - 1.0) + kDigitWidth;
    Eigen::Vector2d corner = centre - scale / 2.0 * Eigen::Vector2d(width, kDigitHeight);
    std::vector<ScreenLine> strokes;
    for (const char digit : text) {
        for (const GridLine& line : digits().at(digit - '0')) {
            ScreenLine stroke;
            stroke.closed = line.closed;
            for (const GridPoint& p : line.points) {
                ScreenNode node;
                node.at = corner + scale * Eigen::Vector2d(p.x, p.y);
                stroke.nodes.push_back(node);
            }
            strokes.push_back(std::move(stroke));
        }
        corner.x() += kDigitStep * scale;
    }
    return strokes;
}

}  // namespace bspline_curve
