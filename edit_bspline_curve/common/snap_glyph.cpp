// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/snap_glyph.h"

#include "edit_bspline_curve/common/line_style.h"

#include <vector>

namespace bspline_curve {
namespace {

constexpr SketchColour kSnapColour{0, 225, 255};
constexpr LineWidths kSnapWidths{1.25, 2.75, 3.5};

struct GlyphPoint {
    double x, y;  // logical pixels from the place, upwards
};

struct GlyphLine {
    std::vector<GlyphPoint> points;
    bool closed = false;
};

std::vector<GlyphLine> linesOf(SnapKind kind) {
    switch (kind) {
        case SnapKind::None:
            break;
        case SnapKind::Pick:
            return {{{{0, -17}, {17, 0}, {0, 17}, {-17, 0}}, true}};
        case SnapKind::Boundary:
            return {{{{-13, 13}, {13, 13}}}, {{{-13, -13}, {13, -13}}}};
        case SnapKind::Crease:
            return {{{{-13, 3}, {-13, 13}, {-3, 13}}}, {{{13, -3}, {13, -13}, {3, -13}}}};
        case SnapKind::Ridge:
            return {{{{0, 22}, {20, -12}, {-20, -12}}, true}};
        case SnapKind::Valley:
            return {{{{0, -22}, {-20, 12}, {20, 12}}, true}};
        case SnapKind::Vertex:
            return {{{{-13, -13}, {13, -13}, {13, 13}, {-13, 13}}, true}};
    }
    return {};
}

}  // namespace

void addSnapGlyph(ScreenBatch& batch, const ScreenNode& place, SnapKind kind, double ratio) {
    const LineStyle style(kSnapColour, kSnapWidths, ratio);
    for (const GlyphLine& glyph : linesOf(kind)) {
        ScreenLine line;
        line.closed = glyph.closed;
        for (const GlyphPoint& p : glyph.points) {
            ScreenNode node;
            node.at = place.at + ratio * Eigen::Vector2d(p.x, p.y);
            line.nodes.push_back(node);
        }
        style.addLine(batch, line);
    }
}

}  // namespace bspline_curve
