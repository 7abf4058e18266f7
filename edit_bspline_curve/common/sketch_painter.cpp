// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/sketch_painter.h"

#include <algorithm>

namespace bspline_curve {
namespace {

// Sizes in logical pixels, colours as red, green, blue.
struct Style {
    double line = 2.5, otherLine = 1.5, pick = 10.0, rim = 14.0;
    Vec3 active{0.95, 0.25, 0.1}, other{0.6, 0.2, 0.15}, preview{0.95, 0.7, 0.2};
    Vec3 handle{1.0, 1.0, 1.0}, edge{0.1, 0.1, 0.1}, selected{1.0, 0.75, 0.1};
    Vec3 hovered{1.0, 1.0, 0.4}, bad{0.9, 0.0, 0.0};
    double hiddenAlpha = 0.2;
    /// What lies on the surface is drawn nearer by this share of the depth's range.
    double depthShift = 2e-4;
};

const Style kStyle;

void setColour(const Vec3& colour, double alpha) {
    glColor4d(colour[0], colour[1], colour[2], alpha);
}

void drawLine(const std::vector<Vec3>& points, bool closed) {
    glBegin(closed ? GL_LINE_LOOP : GL_LINE_STRIP);
    for (const Vec3& p : points) {
        glVertex3d(p[0], p[1], p[2]);
    }
    glEnd();
}

class Painter {
public:
    Painter(const DrawingSession& session, const View& view) : session_(session), view_(view) {}

    void paintLines(double alpha) const {
        const Sketch& sketch = session_.sketch();
        for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
            const SketchCurve& curve = *sketch.curves[c];
            const bool isActive = c == sketch.active;
            glLineWidth(width(isActive ? kStyle.line : kStyle.otherLine));
            setColour(isActive ? kStyle.active : kStyle.other, alpha);
            drawLine(curve.shownPoints(), curve.options.solver.closed);
        }
        if (session_.preview()) {
            glLineWidth(width(kStyle.otherLine));
            glEnable(GL_LINE_STIPPLE);
            glLineStipple(2, 0x5555);
            setColour(kStyle.preview, alpha);
            drawLine(session_.preview()->polyline.points, false);
            glDisable(GL_LINE_STIPPLE);
        }
    }

    // Whole ones: on a steep surface a part of a disc would lie behind it.
    void paintPicks() const {
        const Sketch& sketch = session_.sketch();
        for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
            for (int i = 0; i < static_cast<int>(sketch.curves[c]->picks.size()); ++i) {
                paintPick(c, i);
            }
        }
    }

private:
    [[nodiscard]] GLfloat width(double pixels) const {
        return static_cast<GLfloat>(pixels * view_.ratio());
    }

    void paintPick(int c, int i) const {
        const SketchCurve& curve = *session_.sketch().curves[c];
        const SketchProblem& problem = curve.problem;
        const bool isBad =
            !problem.message.empty() &&
            (problem.picks.empty() || std::ranges::find(problem.picks, i) != problem.picks.end());
        Vec3 colour = kStyle.handle;
        if (isBad) {
            colour = kStyle.bad;
        } else if (session_.hovered() == SketchHit{c, i, -1}) {
            colour = kStyle.hovered;
        } else if (c == session_.sketch().active && i == session_.sketch().selected) {
            colour = kStyle.selected;
        }
        const Vec3& position = curve.picks[i].position;
        const Pointer towards = view_.pointerAt(view_.positionOf(position));
        const double alpha = session_.hides(towards, position) ? kStyle.hiddenAlpha : 1.0;
        paintPoint(position, kStyle.rim, kStyle.edge, alpha);
        paintPoint(position, kStyle.pick, colour, alpha);
    }

    void paintPoint(const Vec3& p, double size, const Vec3& colour, double alpha) const {
        glPointSize(width(size));
        setColour(colour, alpha);
        glBegin(GL_POINTS);
        glVertex3d(p[0], p[1], p[2]);
        glEnd();
    }

    const DrawingSession& session_;
    const View& view_;
};

}  // namespace

void paintSketch(const DrawingSession& session, const View& view) {
    const Painter painter(session, view);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_CLIP_PLANE0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    painter.paintLines(kStyle.hiddenAlpha);
    glDepthRange(0.0, 1.0 - kStyle.depthShift);
    glDepthFunc(GL_LEQUAL);
    painter.paintLines(1.0);
    glDisable(GL_DEPTH_TEST);
    painter.paintPicks();
    glPopAttrib();
}

}  // namespace bspline_curve
