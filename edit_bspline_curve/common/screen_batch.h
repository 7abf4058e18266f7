// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"
#include "edit_bspline_curve/common/screen_line.h"

#include <cstdint>
#include <vector>

namespace bspline_curve {

struct Paint {
    SketchColour colour;
    double alpha = 1.0;
};

/// Shapes on the screen, made of triangles whose edges fade out over a pixel: lines and discs of
/// OpenGL have another greatest width on each machine, and gaps where they bend. Lengths are in
/// device pixels. What is added later lies above.
class ScreenBatch {
public:
    /// With round joins and ends.
    void addStroke(const ScreenLine& line, double halfWidth, const Paint& paint);
    void addDisc(const ScreenNode& centre, double radius, const Paint& paint);

    /// Into the context of the screen, see ScreenFrame. `opacity` is a factor of all alphas.
    void draw(double opacity = 1.0) const;

private:
    struct Vertex {
        float x, y, depth;
        SketchColour colour;
        std::uint8_t alpha;
    };

    /// Half of the width of a stroke, from its middle to its side.
    struct Brush {
        double inner, outer;  ///< where it begins to fade, and where it ends
        Paint paint;
    };

    struct CrossSection {
        const ScreenNode* node;
        Eigen::Vector2d left;  ///< for half a width of 1
    };

    static Brush brush(double halfWidth, const Paint& paint);
    void beginStrip();
    void add(const ScreenNode& node, const Eigen::Vector2d& offset, const Paint& paint);
    void addSides(const std::vector<CrossSection>& sections, const Brush& brush);
    /// The part of a disc between two directions, counter-clockwise.
    void addSector(const ScreenNode& centre, double from, double angle, const Brush& brush);

    std::vector<Vertex> strip_;  ///< one, whose parts triangles without area join
    bool begins_ = false;        ///< the next vertex begins a part
};

/// While it lives, OpenGL draws what ScreenBatch has: without lights, textures and clipping planes,
/// blended, without changing depths. Restores the state of OpenGL.
class ScreenFrame {
public:
    explicit ScreenFrame(const View& view);
    ~ScreenFrame();
    ScreenFrame(const ScreenFrame&) = delete;
    ScreenFrame& operator=(const ScreenFrame&) = delete;
};

}  // namespace bspline_curve
