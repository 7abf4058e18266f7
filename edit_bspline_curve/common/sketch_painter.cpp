// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/sketch_painter.h"

#include "edit_bspline_curve/common/handle_glyph.h"
#include "edit_bspline_curve/common/line_style.h"
#include "edit_bspline_curve/common/snap_glyph.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace bspline_curve {
namespace {

// Logical pixels.
constexpr LineWidths kActive{1.3, 2.7, 4.0};
constexpr LineWidths kOther{0.9, 1.9, 3.2};
constexpr double kDot = 2.2;  // radius of picks without handles
constexpr double kPreview = 1.1, kPreviewHalo = 2.4;
constexpr double kDash = 7.0, kGap = 5.0;
constexpr double kLift = 4.0;         // see ScreenProjection
constexpr double kLeastApart = 18.0;  // picks that get a number

constexpr double kLeastBend = 0.05;  // of a curve that has an outer side

constexpr SketchColour kPreviewColour{255, 245, 215};
constexpr double kPreviewHaloAlpha = 0.8;
constexpr double kHiddenLine = 0.35, kHiddenHandle = 0.4;

// A pick with a handle.
struct PaintedPick {
    ScreenNode node;
    HandleState state;
    bool isHidden = false;
};

class Painter {
public:
    Painter(const DrawingSession& session, const View& view)
        : session_(session), view_(view), projection_(view, kLift) {}

    // What lies on the surface.
    [[nodiscard]] ScreenBatch lines() const {
        ScreenBatch batch;
        const Sketch& sketch = session_.sketch();
        for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
            if (c != sketch.active) {
                addCurve(batch, c);
            }
        }
        addFreehand(batch);
        if (session_.preview()) {
            addPreview(batch, session_.preview()->polyline);
        }
        if (sketch.active >= 0) {
            addLeeways(batch, curve(sketch.active));
            addCurve(batch, sketch.active);
        }
        return batch;
    }

    // Above the surface, whole: on a steep one a part of a handle would lie behind it.
    void paintHandles() const {
        ScreenBatch hidden;
        ScreenBatch shown;
        const Sketch& sketch = session_.sketch();
        for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
            if (hasHandles(c)) {
                if (c == sketch.active) {
                    addDirectionOfSelected(hidden, shown);
                }
                const std::vector<std::optional<PaintedPick>> picks = paintedPicks(c);
                addHandles(picks, false, hidden);
                addHandles(picks, true, shown);
                if (c == sketch.active) {
                    addNumbers(picks, hidden, shown);
                }
            }
        }
        const Snap& snapped = session_.snapped();
        if (snapped.kind != SnapKind::None) {
            if (const auto place = nodeOf(
                    {snapped.point, positionOf(session_.workpiece().mesh(), snapped.point)}
                )) {
                addSnapGlyph(shown, *place, snapped.kind, view_.ratio());
            }
        }
        hidden.draw(kHiddenHandle);
        shown.draw();
    }

private:
    [[nodiscard]] const SketchCurve& curve(int c) const { return *session_.sketch().curves[c]; }

    [[nodiscard]] bool hasHandles(int c) const {
        return !curve(c).look.isHidden &&
               (c == session_.sketch().active || c == session_.hovered().curve);
    }

    [[nodiscard]] std::optional<ScreenNode> nodeOf(const SketchPick& pick) const {
        return projection_.node(pick.position, session_.normalAt(pick.point));
    }

    [[nodiscard]] std::vector<ScreenLine> onScreen(
        const SurfacePolyline& line, const std::vector<Vec3>& points, bool closed
    ) const {
        const auto normalOf = [&](std::size_t i) {
            return session_.normalAt(line.surfacePoints[i]);
        };
        return projection_.lines(points, normalOf, closed);
    }

    void addCurve(ScreenBatch& batch, int c) const {
        const SketchCurve& curve = this->curve(c);
        if (curve.look.isHidden) {
            return;
        }
        const LineStyle style(
            curve.look.colour, c == session_.sketch().active ? kActive : kOther, view_.ratio()
        );
        if (const auto& solved = curve.settled ? curve.settled : curve.last) {
            const bool closed = curve.options.solver.closed;
            for (const ScreenLine& line : onScreen(solved->polyline, curve.shownPoints(), closed)) {
                style.addLine(batch, line);
            }
        }
        if (!hasHandles(c)) {
            for (const SketchPick& pick : curve.picks) {
                if (const auto node = nodeOf(pick)) {
                    style.addDot(batch, *node, kDot);
                }
            }
        }
    }

    // Round each pick that the curve need not pass, how far from it that may be.
    void addLeeways(ScreenBatch& batch, const SketchCurve& curve) const {
        constexpr int kCorners = 48;
        const double reach =
            curve.options.solver.pickTolerance.in(session_.workpiece().meanEdgeLength());
        if (curve.look.isHidden || !(reach > 0.0)) {
            return;
        }
        for (const SketchPick& pick : curve.picks) {
            const Vec3 normal = session_.normalAt(pick.point);
            if (kindOf(pick) != PickKind::Automatic || normal.isZero(0.0)) {
                continue;
            }
            const Vec3 first = normal.unitOrthogonal();
            const Vec3 second = normal.cross(first);
            std::vector<Vec3> circle;
            for (int i = 0; i < kCorners; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / kCorners;
                circle.emplace_back(
                    pick.position + reach * (std::cos(angle) * first + std::sin(angle) * second)
                );
            }
            const auto normalOf = [&](std::size_t) { return session_.normalAt(pick.point); };
            for (const ScreenLine& line : projection_.lines(circle, normalOf, true)) {
                batch.addStroke(line, kPreviewHalo * view_.ratio(), {kDark, kPreviewHaloAlpha});
                batch.addStroke(line, kPreview * view_.ratio(), {kPreviewColour});
            }
        }
    }

    // As the preview, but whole.
    void addFreehand(ScreenBatch& batch) const {
        const std::vector<SketchPick>& stroke = session_.stroke();
        std::vector<Vec3> points;
        for (const SketchPick& pick : stroke) {
            points.push_back(pick.position);
        }
        const auto normalOf = [&](std::size_t i) { return session_.normalAt(stroke[i].point); };
        const double ratio = view_.ratio();
        for (const ScreenLine& line : projection_.lines(points, normalOf, false)) {
            batch.addStroke(line, kPreviewHalo * ratio, {kDark, kPreviewHaloAlpha});
            batch.addStroke(line, kPreview * ratio, {kPreviewColour});
        }
    }

    // Light dashes in a dark band.
    void addPreview(ScreenBatch& batch, const SurfacePolyline& polyline) const {
        const double ratio = view_.ratio();
        for (const ScreenLine& line : onScreen(polyline, polyline.points, polyline.closed)) {
            batch.addStroke(line, kPreviewHalo * ratio, {kDark, kPreviewHaloAlpha});
            for (const ScreenLine& dash : dashes(line, kDash * ratio, kGap * ratio)) {
                batch.addStroke(dash, kPreview * ratio, {kPreviewColour});
            }
        }
    }

    [[nodiscard]] HandleState stateOf(int c, int i) const {
        const SketchProblem& problem = curve(c).problem;
        HandleState state;
        state.isBad =
            !problem.message.empty() &&
            (problem.picks.empty() || std::ranges::find(problem.picks, i) != problem.picks.end());
        state.isHovered = session_.hovered() == SketchHit{c, i, -1};
        state.isCorner = curve(c).picks[i].isCorner;
        state.isSelected = c == session_.sketch().active && i == session_.sketch().selected;
        return state;
    }

    [[nodiscard]] bool isHidden(const SketchPick& pick) const {
        return session_.hides(view_.pointerAt(view_.positionOf(pick.position)), pick);
    }

    // Of a curve, in order; nothing for those behind the eye.
    [[nodiscard]] std::vector<std::optional<PaintedPick>> paintedPicks(int c) const {
        std::vector<std::optional<PaintedPick>> painted;
        for (int i = 0; i < static_cast<int>(curve(c).picks.size()); ++i) {
            const SketchPick& pick = curve(c).picks[i];
            painted.emplace_back();
            if (const auto node = nodeOf(pick)) {
                painted.back() = {*node, stateOf(c, i), isHidden(pick)};
            }
        }
        return painted;
    }

    // Those that matter most above the others.
    void addHandles(
        const std::vector<std::optional<PaintedPick>>& picks, bool isShown, ScreenBatch& batch
    ) const {
        for (const bool isSpecial : {false, true}) {
            for (const std::optional<PaintedPick>& pick : picks) {
                if (pick && pick->isHidden != isShown && pick->state.isSpecial() == isSpecial) {
                    addHandle(batch, pick->node, pick->state, view_.ratio());
                }
            }
        }
    }

    // Beneath the pick itself.
    void addDirectionOfSelected(ScreenBatch& hidden, ScreenBatch& shown) const {
        const int selected = session_.sketch().selected;
        if (selected < 0 || session_.handlePixels() <= 0.0) {
            return;
        }
        const SketchPick& pick = session_.sketch().activeCurve()->picks[selected];
        const Vec3 normal = session_.normalAt(pick.point);
        const Pointer pointer = view_.pointerAt(view_.positionOf(pick.position));
        const auto middle = projection_.node(pick.position, normal);
        for (const int side : {1, -1}) {
            const auto handle = session_.handle(pick, side, pointer);
            const auto end = handle ? projection_.node(*handle, normal) : std::nullopt;
            if (middle && end) {
                const bool isHovered = session_.hovered().handle == side;
                addDirection(
                    isHidden(pick) ? hidden : shown, *middle, *end, isHovered, view_.ratio()
                );
            }
        }
    }

    void addNumbers(
        const std::vector<std::optional<PaintedPick>>& picks,
        ScreenBatch& hidden,
        ScreenBatch& shown
    ) const {
        for (std::size_t i = 0; i < picks.size(); ++i) {
            const std::optional<PaintedPick>& pick = picks[i];
            if (pick &&
                (isMarked(*pick) || (!pick->isHidden && isApart(picks, i, pick->node.at)))) {
                addHandleNumber(
                    pick->isHidden ? hidden : shown,
                    pick->node,
                    pick->state,
                    outside(picks, i, pick->node.at),
                    static_cast<int>(i) + 1,
                    view_.ratio()
                );
            }
        }
    }

    // Whether the number is shown in any case: not so where all picks are bad.
    [[nodiscard]] bool isMarked(const PaintedPick& pick) const {
        const bool isNamed =
            pick.state.isBad && !session_.sketch().activeCurve()->problem.picks.empty();
        return isNamed || pick.state.isHovered || pick.state.isSelected;
    }

    [[nodiscard]] bool isApart(
        const std::vector<std::optional<PaintedPick>>& picks,
        std::size_t i,
        const Eigen::Vector2d& here
    ) const {
        const double least = kLeastApart * view_.ratio();
        for (std::size_t k = 0; k < picks.size(); ++k) {
            const std::optional<PaintedPick>& other = picks[k];
            if (k != i && other && (other->node.at - here).squaredNorm() < least * least) {
                return false;
            }
        }
        return true;
    }

    // Across the curve at a pick, on the outer side of its bend; upwards where there is none.
    [[nodiscard]] Eigen::Vector2d outside(
        const std::vector<std::optional<PaintedPick>>& picks,
        std::size_t i,
        const Eigen::Vector2d& here
    ) const {
        const std::size_t count = picks.size();
        const bool closed = session_.sketch().activeCurve()->options.solver.closed;
        const auto wayTo = [&](std::size_t k, bool isThere) -> Eigen::Vector2d {
            const std::optional<PaintedPick>& other = picks[k];
            return isThere && other ? Eigen::Vector2d((other->node.at - here).normalized())
                                    : Eigen::Vector2d(Eigen::Vector2d::Zero());
        };
        const Eigen::Vector2d before = wayTo((i + count - 1) % count, closed || i > 0);
        const Eigen::Vector2d after = wayTo((i + 1) % count, closed || i + 1 < count);
        const Eigen::Vector2d along = after - before;
        Eigen::Vector2d across(-along.y(), along.x());
        if (across.norm() < std::numeric_limits<double>::epsilon()) {
            across = Eigen::Vector2d::UnitY();
        }
        const double bend = across.dot(before + after);
        const bool isStraight =
            before.isZero() || after.isZero() || std::abs(bend) < kLeastBend * across.norm();
        const bool isWrong = isStraight ? across.y() < 0.0 : bend > 0.0;
        return isWrong ? Eigen::Vector2d(-across.normalized())
                       : Eigen::Vector2d(across.normalized());
    }

    const DrawingSession& session_;
    const View& view_;
    ScreenProjection projection_;
};

}  // namespace

void paintSketch(const DrawingSession& session, const View& view) {
    const Painter painter(session, view);
    const ScreenBatch lines = painter.lines();
    const ScreenFrame frame(view);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    lines.draw(kHiddenLine);
    glDepthFunc(GL_LEQUAL);
    lines.draw();
    glDisable(GL_DEPTH_TEST);
    painter.paintHandles();
}

}  // namespace bspline_curve
