// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/screen_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve {
namespace {

constexpr double kFade = 0.5;         // pixels on each side of an edge
constexpr double kRoundFrom = 0.5;    // radians: joins of sharper bends are round
constexpr double kChordUnseen = 0.1;  // pixels from arcs to their chords

constexpr std::array<GLenum, 17> kSwitchedOff = {
    GL_LIGHTING,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_FOG,
    GL_CULL_FACE,
    GL_ALPHA_TEST,
    GL_STENCIL_TEST,
    GL_COLOR_LOGIC_OP,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_POLYGON_OFFSET_FILL,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE1,
    GL_CLIP_PLANE2,
    GL_CLIP_PLANE3,
    GL_CLIP_PLANE4,
    GL_CLIP_PLANE5,
};

Eigen::Vector2d directionOf(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

double angleOf(const Eigen::Vector2d& direction) {
    return std::atan2(direction.y(), direction.x());
}

// From one direction to another, in (-pi, pi].
double turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

// Unit directions of the segments; those without length take that of the one before.
std::vector<Eigen::Vector2d> directionsOf(const ScreenLine& line) {
    const std::size_t count = line.nodes.size();
    std::vector<Eigen::Vector2d> directions;
    for (std::size_t i = 0; i + (line.closed ? 0U : 1U) < count; ++i) {
        const Eigen::Vector2d way = line.nodes[(i + 1) % count].at - line.nodes[i].at;
        const double length = way.norm();
        if (length > 0.0) {
            directions.emplace_back(way / length);
        } else {
            directions.push_back(
                directions.empty() ? Eigen::Vector2d(Eigen::Vector2d::UnitX()) : directions.back()
            );
        }
    }
    return directions;
}

}  // namespace

ScreenBatch::Brush ScreenBatch::brush(double halfWidth, const Paint& paint) {
    return {std::max(halfWidth - kFade, 0.0), halfWidth + kFade, paint};
}

void ScreenBatch::beginStrip() {
    begins_ = true;
}

void ScreenBatch::add(const ScreenNode& node, const Eigen::Vector2d& offset, const Paint& paint) {
    const Eigen::Vector2d at = node.at + offset;
    const Vertex vertex{
        static_cast<float>(at.x()),
        static_cast<float>(at.y()),
        static_cast<float>(node.depthAt(at)),
        paint.colour,
        static_cast<std::uint8_t>(std::lround(255.0 * paint.alpha))
    };
    if (std::exchange(begins_, false) && !strip_.empty()) {
        strip_.push_back(strip_.back());
        strip_.push_back(vertex);
    }
    strip_.push_back(vertex);
}

void ScreenBatch::addSector(
    const ScreenNode& centre, double from, double angle, const Brush& brush
) {
    const double step = 2.0 * std::sqrt(2.0 * kChordUnseen / brush.outer);
    const int steps = std::max(1, static_cast<int>(std::ceil(angle / step)));
    const auto ring = [&](double inner, double outer, double outerAlpha) {
        beginStrip();
        for (int i = 0; i <= steps; ++i) {
            const Eigen::Vector2d direction = directionOf(from + angle * i / steps);
            add(centre, outer * direction, {brush.paint.colour, outerAlpha});
            add(centre, inner * direction, brush.paint);
        }
    };
    ring(0.0, brush.inner, brush.paint.alpha);
    ring(brush.inner, brush.outer, 0.0);
}

void ScreenBatch::addDisc(const ScreenNode& centre, double radius, const Paint& paint) {
    addSector(centre, 0.0, 2.0 * std::numbers::pi, brush(radius, paint));
}

// The sides of a part of a stroke, through its cross-sections.
void ScreenBatch::addSides(const std::vector<CrossSection>& sections, const Brush& brush) {
    const auto strip = [&](double from, double to, double fromAlpha, double toAlpha) {
        beginStrip();
        for (const CrossSection& section : sections) {
            add(*section.node, from * section.left, {brush.paint.colour, fromAlpha});
            add(*section.node, to * section.left, {brush.paint.colour, toAlpha});
        }
    };
    const double alpha = brush.paint.alpha;
    strip(-brush.outer, -brush.inner, 0.0, alpha);
    strip(-brush.inner, brush.inner, alpha, alpha);
    strip(brush.inner, brush.outer, alpha, 0.0);
}

void ScreenBatch::addStroke(const ScreenLine& line, double halfWidth, const Paint& paint) {
    const std::size_t count = line.nodes.size();
    if (count < 2) {
        return;
    }
    const Brush wide = brush(halfWidth, paint);
    const std::vector<Eigen::Vector2d> directions = directionsOf(line);
    const std::size_t segments = directions.size();
    std::vector<CrossSection> sections;
    for (std::size_t i = 0; i <= segments; ++i) {
        const ScreenNode& node = line.nodes[i % count];
        const Eigen::Vector2d& before = directions[(i + segments - 1) % segments];
        const Eigen::Vector2d& after = directions[i % segments];
        const bool isEnd = !line.closed && (i == 0 || i == segments);
        const double bend = turn(before, after);
        if (isEnd) {
            const Eigen::Vector2d left = leftOf(i == 0 ? after : before);
            sections.push_back({&node, left});
            addSector(node, angleOf(i == 0 ? left : -left), std::numbers::pi, wide);
        } else if (std::abs(bend) <= kRoundFrom) {
            sections.push_back(
                {&node, leftOf((before + after).normalized()) / std::cos(bend / 2.0)}
            );
        } else {
            if (i > 0) {
                sections.push_back({&node, leftOf(before)});
                addSides(std::exchange(sections, {}), wide);
                addSector(
                    node,
                    angleOf(bend > 0.0 ? -leftOf(before) : leftOf(after)),
                    std::abs(bend),
                    wide
                );
            }
            sections.push_back({&node, leftOf(after)});
        }
    }
    addSides(sections, wide);
}

void ScreenBatch::draw(double opacity) const {
    glBegin(GL_TRIANGLE_STRIP);
    for (const Vertex& v : strip_) {
        const auto alpha = static_cast<GLubyte>(std::lround(opacity * v.alpha));
        glColor4ub(v.colour.red, v.colour.green, v.colour.blue, alpha);
        glVertex3f(v.x, v.y, v.depth);
    }
    glEnd();
}

ScreenFrame::ScreenFrame(const View& view) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    for (const GLenum state : kSwitchedOff) {
        glDisable(state);
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glShadeModel(GL_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    // Depth stays as it is.
    glOrtho(0.0, view.size().x(), 0.0, view.size().y(), 1.0, -1.0);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
}

ScreenFrame::~ScreenFrame() {
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
    glPopAttrib();
}

}  // namespace bspline_curve
