// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that a session's user draws freehand.
#include "bspline_curve/spline.h"
#include "sketch/hit_test.h"
#include "sketch/session_parts.h"
#include "surface/provenance.h"
#include "surface/surface.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Points of a stroke are so many pixels apart.
constexpr double kStrokeStep = 2.0;

/// How far from the stroke the curve may be, in pixels, where that is more than the mesh asks for:
/// a hand trembles by about as much.
constexpr double kStrokePixels = 4.0;

/// A stroke that ends where it began is closed, if it is so many times longer than the gap may be.
constexpr double kLeastRound = 4.0;

/// Puts a curve in the place of another, where that is one of the sketch's. The selected pick stays
/// selected if it is one of the new curve, too; else none is.
void replaceIn(
    Sketch& sketch,
    const std::shared_ptr<SketchCurve>& curve,
    const std::shared_ptr<SketchCurve>& by
) {
    const auto place = std::ranges::find(sketch.curves, curve);
    if (place == sketch.curves.end()) {
        return;
    }
    *place = by;
    if (place - sketch.curves.begin() == sketch.active && sketch.selected >= 0) {
        const Vec3 selected = curve->picks[sketch.selected].position;
        const auto same = std::ranges::find_if(by->picks, [&](const SketchPick& pick) {
            return pick.position == selected;
        });
        const bool stays = same != by->picks.end();
        sketch.selected = stays ? static_cast<int>(same - by->picks.begin()) : -1;
    }
}

double lengthOf(const std::vector<SketchPick>& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += (line[i].position - line[i - 1].position).norm();
    }
    return length;
}

}  // namespace

void DrawingSession::beginStroke(const Pointer& pointer, const Seen& seen, const SketchHit& hit) {
    strokeStart_ = pointer;
    strokeFrom_ = hit.curve;
    strokePixel_ = pointer.pixelAt(seen.distance);
    stroke_ = {pickAt(solver_->designer->surface().provenance().toInput(seen.point))};
    pressedAt_ = seen.position;
    mode_ = Mode::Stroking;
    dropLive();
}

void DrawingSession::goOnWithStroke(const Seen& seen) {
    const bool isApart = seen.point.face >= 0 && (seen.position - stroke_.back().position).norm() >=
                                                     kStrokeStep * strokePixel_;
    if (isApart) {
        stroke_.push_back(pickAt(solver_->designer->surface().provenance().toInput(seen.point)));
    }
}

// A click where the hand did not move.
void DrawingSession::endStroke(const Pointer& pointer) {
    goOnWithStroke(seenBy(pointer));
    mode_ = Mode::Idle;
    std::vector<SketchPick> line = std::exchange(stroke_, {});
    if (lengthOf(line) <= settings_.dragPixels * strokePixel_) {
        Pointer click = strokeStart_;
        click.strokes = false;
        static_cast<void>(press(click) && release(click));
        return;
    }
    const double reach = settings_.radii.pick * strokePixel_;
    const int over = hitTest(sketch_, pointer, seenBy(pointer), settings_.radii).curve;
    if (over >= 0 && over == strokeFrom_) {
        if (auto stroke = strokeInto(*sketch_.curves[over], line, reach)) {
            sketch_.active = over;
            enterStroke({*std::move(stroke)});
            return;
        }
    }
    Stroke stroke{.line = std::move(line), .before = {}, .after = {}};
    stroke.closed = (stroke.line.front().position - stroke.line.back().position).norm() <= reach &&
                    lengthOf(stroke.line) > kLeastRound * reach && stroke.line.size() > 3;
    sketch_.active = -1;
    begun().options.solver.closed = stroke.closed;
    enterStroke({std::move(stroke)});
}

// With few picks of the line, until those of the fitted curve are known.
void DrawingSession::enterStroke(Freehand stroke) {
    SketchCurve& curve = changed();
    curve.picks = stroke.joined(stroke.thinned());
    sketch_.selected = -1;
    strokes_.push_back({sketch_.curves[sketch_.active], std::move(stroke), strokePixel_});
    enter();
}

DrawingSession::Request DrawingSession::fitRequest(
    const AskedStroke& asked, std::uint64_t id
) const {
    Request request;
    request.id = id;
    request.options = asked.curve->options;
    for (const SketchPick& pick : asked.stroke.line) {
        request.line.push_back(pick.position);
    }
    request.options.solver.closed = asked.stroke.closed;
    if (!asked.stroke.before.empty() || !asked.stroke.after.empty()) {
        request.fit.cornerAngle = 180.0;  // it comes to the curve at an angle, and is to join it
    }
    // Else what the mesh and the line itself ask for.
    if (tolerance(asked) > solver_->designer->surface().averageEdgeLength()) {
        request.fit.deviation.value = tolerance(asked);
    }
    return request;
}

double DrawingSession::tolerance(const AskedStroke& asked) const {
    return std::max(kStrokePixels * asked.pixel, solver_->designer->surface().averageEdgeLength());
}

// Its picks take the place of those few, in the same entry of the history. Where there is no curve
// along the stroke these stay.
void DrawingSession::takeStroke(const Answer& answer, const std::shared_ptr<SketchCurve>& of) {
    const auto place = std::ranges::find(strokes_, of, &AskedStroke::curve);
    if (place == strokes_.end()) {
        return;
    }
    const Stroke stroke = std::move(place->stroke);
    const double apart = tolerance(*place);
    strokes_.erase(place);
    if (answer.curve) {
        const SurfacePolyline& line = answer.curve->polyline;
        std::vector<SketchPick> along;
        for (const int point : line.picks) {
            along.push_back(pickAt(line.surfacePoints[point]));
        }
        for (const int corner : cornersOf(answer.curve->spline)) {
            along[corner].isCorner = true;
        }
        const auto curve = std::make_shared<SketchCurve>(*of);
        curve->picks = stroke.joined(describing(along, stroke.closed, apart));
        if (curve->isDrawable()) {
            if (stroke.before.empty() && stroke.after.empty()) {
                curve->last =
                    answer.curve;  // which is seen until the one through the picks is there
                curve->lastPicks = curve->positions();
            }
            Sketch now = history_.now();
            replaceIn(now, of, curve);
            history_.replace(now);
            replaceIn(sketch_, of, curve);
            hovered_ = {};
            const bool isHeld = mode_ == Mode::Pressed || mode_ == Mode::Dragging;
            if (isHeld && sketch_.selected < 0) {
                mode_ = Mode::Idle;  // what was pressed is no more
            }
        }
    }
    askSettled();
}

}  // namespace bspline_curve
