// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/drawing_session.h"

#include "sketch/hit_test.h"
#include "sketch/session_parts.h"
#include "sketch/snapping.h"
#include "surface/surface.h"
#include "surface/surface_point.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

DrawingSession::DrawingSession(std::shared_ptr<const Workpiece> workpiece, SessionSettings settings)
    : workpiece_(std::move(workpiece)), settings_(std::move(settings)) {
    const std::shared_ptr<const CurveDesigner> designer = sharedDesignerOf(*workpiece_);
    // NOLINTNEXTLINE(modernize-make-unique): an aggregate of what cannot be moved
    solver_.reset(
        new Solver{.designer = designer, .worker = CurveWorker(designer, settings_.wake)}
    );
}

DrawingSession::~DrawingSession() = default;

// ---- Points ----

SketchPick DrawingSession::pickAt(const SurfacePoint& point) const {
    return {point, positionOf(workpiece_->mesh(), point), false};
}

void DrawingSession::place(SketchPick& pick, const SurfacePoint& point) const {
    pick.point = point;
    pick.position = positionOf(workpiece_->mesh(), point);
}

DrawingSession::Seen DrawingSession::seenBy(const Pointer& pointer) const {
    return {solver_->designer->tree().firstHit(pointer.start, pointer.direction)};
}

bool DrawingSession::hides(const Pointer& pointer, const Vec3& point) const {
    return !isInSight(pointer, seenBy(pointer), point);
}

bool DrawingSession::hides(const Pointer& pointer, const SketchPick& pick) const {
    const TriangleTree::Hit seen = seenBy(pointer);
    const double along = (pick.position - pointer.start).dot(pointer.direction);
    const bool isFromBehind = normalAt(pick.point).dot(pointer.direction) > 0.0;
    return !isInSight(pointer, seen, pick.position) ||
           (isFromBehind && seen.point.face >= 0 && along - seen.distance > pointer.pixelAt(along));
}

SurfacePoint DrawingSession::pointUnder(const Pointer& pointer, const Seen& seen) {
    const Surface& surface = solver_->designer->surface();
    snapped_ = {SnapKind::None, seen.point};
    if (pointer.snaps) {
        const double reach = settings_.snapPixels * pointer.pixelAt(seen.distance);
        snapped_ = snap(surface, sketch_, sketch_.active, seen.point, reach, settings_.snapping);
    }
    snapped_.point = surface.provenance().toInput(snapped_.point);
    return snapped_.point;
}

bool DrawingSession::hasMoved(const Pointer& pointer) const {
    const Vec3 way = pressedAt_ - pointer.start;
    const double along = way.dot(pointer.direction);
    return (way - along * pointer.direction).norm() >
           settings_.dragPixels * pointer.pixelAt(std::max(along, 0.0));
}

// ---- Events ----

bool DrawingSession::press(const Pointer& pointer) {
    if (mode_ != Mode::Idle) {
        return true;
    }
    const Seen seen = seenBy(pointer);
    if (pressHandle(pointer, seen)) {
        return true;
    }
    const SketchHit hit = hitTest(sketch_, pointer, seen, settings_.radii);
    if (pointer.strokes && seen.point.face >= 0) {
        beginStroke(pointer, seen, hit);
        return true;
    }
    if (hit.pick >= 0) {
        if (pointer.removes) {
            sketch_.active = hit.curve;
            removePick(hit.pick);
            return true;
        }
        const SketchCurve& curve = *sketch_.curves[hit.curve];
        closesOnRelease_ = hit.curve == sketch_.active && hit.pick == 0 &&
                           !curve.options.solver.closed && curve.picks.size() >= 3;
        sketch_.active = hit.curve;
        sketch_.selected = hit.pick;
        pressedAt_ = curve.picks[hit.pick].position;
        mode_ = Mode::Pressed;
        dropLive();
        return true;
    }
    if (hit.curve >= 0 && hit.curve != sketch_.active) {
        select(hit.curve);
        return true;
    }
    if (seen.point.face < 0) {
        return false;
    }
    const SurfacePoint point = pointUnder(pointer, seen);
    if (hit.curve >= 0) {
        insertBehind(hit.after, point);
    } else {
        begun();
        insertBehind(static_cast<int>(sketch_.activeCurve()->picks.size()) - 1, point);
    }
    pressedAt_ = seen.position;
    closesOnRelease_ = false;
    mode_ = Mode::Dragging;
    askLive();
    return true;
}

bool DrawingSession::move(const Pointer& pointer) {
    const Seen seen = seenBy(pointer);
    snapped_ = {};
    if (mode_ == Mode::Stroking) {
        goOnWithStroke(seen);
        return true;
    }
    if (mode_ == Mode::Pressed && hasMoved(pointer)) {
        mode_ = Mode::Dragging;
        closesOnRelease_ = false;
    }
    if (mode_ == Mode::Dragging && turning_ != 0) {
        turn(pointer);
    } else if (mode_ == Mode::Dragging && seen.point.face >= 0) {
        const SurfacePoint point = pointUnder(pointer, seen);
        place(changed().picks[sketch_.selected], point);
        askLive();
    }
    if (mode_ != Mode::Idle) {
        return true;
    }
    snapped_ = {};
    if (const int handle = handleUnder(pointer, seen); handle != 0) {
        hovered_ = {sketch_.active, sketch_.selected, -1, handle};
        dropLive();
        return false;
    }
    hovered_ = hitTest(sketch_, pointer, seen, settings_.radii);
    const SketchCurve* const curve = sketch_.activeCurve();
    const bool wouldAdd = curve != nullptr && !curve->options.solver.closed &&
                          !curve->picks.empty() && hovered_.curve < 0 && seen.point.face >= 0;
    if (wouldAdd) {
        askPreview(pointUnder(pointer, seen));
    } else {
        dropLive();
    }
    return false;
}

bool DrawingSession::release(const Pointer& pointer) {
    if (mode_ == Mode::Idle) {
        return false;
    }
    if (mode_ == Mode::Stroking) {
        endStroke(pointer);
        return true;
    }
    static_cast<void>(move(pointer));
    const bool wasDragging = mode_ == Mode::Dragging;
    mode_ = Mode::Idle;
    if (wasDragging) {
        enter();
    } else if (closesOnRelease_) {
        setClosed(true);
    }
    return true;
}

void DrawingSession::leave() {
    hovered_ = {};
    snapped_ = {};
    if (mode_ == Mode::Idle) {
        dropLive();
    }
}

bool DrawingSession::key(SketchKey key, const Pointer& pointer) {
    if (mode_ != Mode::Idle) {
        // While a button is held all other keys wait for its release.
        if (key == SketchKey::Undo || key == SketchKey::Cancel) {
            cancel();
        }
        return true;
    }
    switch (key) {
        case SketchKey::Add:
            return press(pointer) && release(pointer);
        case SketchKey::Move:
            return moveSelected(pointer);
        case SketchKey::Remove:
        case SketchKey::Close:
            return change(key);
        case SketchKey::Next:
        case SketchKey::Previous:
        case SketchKey::NextCurve:
            return selectNext(key);
        case SketchKey::NewCurve:
            newCurve();
            return true;
        case SketchKey::Kind:
            return changeKind();
        case SketchKey::Undo:
            undo();
            return true;
        case SketchKey::Redo:
            redo();
            return true;
        case SketchKey::Cancel:
            cancel();
            sketch_.selected = -1;
            return true;
    }
    return false;
}

bool DrawingSession::moveSelected(const Pointer& pointer) {
    const Seen seen = seenBy(pointer);
    if (sketch_.selected < 0 || seen.point.face < 0) {
        return false;
    }
    movePick(sketch_.selected, pointUnder(pointer, seen));
    return true;
}

bool DrawingSession::change(SketchKey key) {
    const SketchCurve* const curve = sketch_.activeCurve();
    if (curve == nullptr) {
        return false;
    }
    if (key == SketchKey::Close) {
        setClosed(!curve->options.solver.closed);
    } else if (sketch_.selected >= 0) {
        removePick(sketch_.selected);
    } else {
        removeCurve(sketch_.active);
    }
    return true;
}

bool DrawingSession::selectNext(SketchKey key) {
    if (sketch_.curves.empty()) {
        return false;
    }
    if (key == SketchKey::NextCurve) {
        return selectNextCurve();
    }
    if (sketch_.active < 0) {
        return false;
    }
    const auto count = static_cast<int>(sketch_.activeCurve()->picks.size());
    const int before = sketch_.selected <= 0 ? count - 1 : sketch_.selected - 1;
    select(sketch_.active, key == SketchKey::Next ? (sketch_.selected + 1) % count : before);
    return true;
}

bool DrawingSession::selectNextCurve() {
    const auto count = static_cast<int>(sketch_.curves.size());
    for (int step = 1; step <= count; ++step) {
        const int next = (sketch_.active + step) % count;
        if (!sketch_.curves[next]->look.isHidden) {
            select(next);
            return true;
        }
    }
    return false;
}

// ---- Calls ----

void DrawingSession::addPick(const SurfacePoint& point) {
    cancel();
    begun();
    insertBehind(static_cast<int>(sketch_.activeCurve()->picks.size()) - 1, point);
    enter();
}

void DrawingSession::insertPick(int after, const SurfacePoint& point) {
    cancel();
    requirePick(after);
    insertBehind(after, point);
    enter();
}

void DrawingSession::movePick(int pick, const SurfacePoint& point) {
    cancel();
    requirePick(pick);
    place(changed().picks[pick], point);
    sketch_.selected = pick;
    enter();
}

// Ends a drag. Whether there is an active curve, and it is none that the drag had begun.
bool DrawingSession::staysWithoutDrag() {
    const std::uint64_t before = sketch_.active < 0 ? 0 : sketch_.activeCurve()->id;
    cancel();
    return before != 0 && sketch_.active >= 0 && sketch_.activeCurve()->id == before;
}

void DrawingSession::setCorner(int pick, bool isCorner) {
    requirePick(pick);
    if (!staysWithoutDrag()) {
        return;
    }
    requirePick(pick);
    if (sketch_.activeCurve()->picks[pick].isCorner != isCorner) {
        SketchPick& changedPick = changed().picks[pick];
        changedPick.isCorner = isCorner;
        changedPick.tangent = {};
        sketch_.selected = pick;
        enter();
    }
}

void DrawingSession::setTangent(int pick, const PickTangent& tangent) {
    requirePick(pick);
    if (!staysWithoutDrag()) {
        return;
    }
    requirePick(pick);
    if (sketch_.activeCurve()->picks[pick].tangent != tangent) {
        SketchPick& changedPick = changed().picks[pick];
        changedPick.tangent = tangent;
        changedPick.isCorner = tangent.isAny() ? changedPick.isCorner : !tangent.isOne();
        sketch_.selected = pick;
        enter();
    }
}

void DrawingSession::removePick(int pick) {
    cancel();
    requirePick(pick);
    if (sketch_.activeCurve()->picks.size() == 1) {
        removeCurve(sketch_.active);
        return;
    }
    SketchCurve& curve = changed();
    curve.picks.erase(curve.picks.begin() + pick);
    if (curve.picks.size() < 3) {
        curve.options.solver.closed = false;
    }
    sketch_.selected = std::min(pick, static_cast<int>(curve.picks.size()) - 1);
    enter();
}

void DrawingSession::select(int curve, int pick) {
    cancel();
    requireCurve(curve);
    sketch_.active = curve;
    if (pick >= 0) {
        requirePick(pick);
    }
    sketch_.selected = pick;
}

void DrawingSession::setClosed(bool closed) {
    if (!staysWithoutDrag()) {
        return;
    }
    SketchCurveOptions options = sketch_.activeCurve()->options;
    options.solver.closed = closed && sketch_.activeCurve()->picks.size() >= 3;
    if (options.solver.closed != sketch_.activeCurve()->options.solver.closed) {
        changed().options = std::move(options);
        enter();
    }
}

void DrawingSession::setOptions(const SketchCurveOptions& options, bool isLive) {
    options.solver.validate();
    const bool goesOn = isLiveChange_;
    cancel();
    settings_.options = options;
    settings_.options.solver.closed = false;  // of the curve, not of those to come
    if (sketch_.active >= 0) {
        const bool canClose = sketch_.activeCurve()->picks.size() >= 3;
        changed().options = options;
        sketch_.activeCurve()->options.solver.closed = options.solver.closed && canClose;
        if (goesOn) {
            history_.replace(sketch_);
            settleNow();
        } else {
            enter();
        }
        isLiveChange_ = isLive;
    }
}

void DrawingSession::newCurve() {
    cancel();
    sketch_.active = sketch_.selected = -1;
}

void DrawingSession::removeCurve(int curve) {
    cancel();
    requireCurve(curve);
    sketch_.curves.erase(sketch_.curves.begin() + curve);
    sketch_.active = sketch_.selected = -1;
    enter();
}

void DrawingSession::undo() {
    cancel();
    history_.undo();
    show(history_.now());
}

void DrawingSession::redo() {
    cancel();
    history_.redo();
    show(history_.now());
}

void DrawingSession::cancel() {
    dropLive();
    if (mode_ == Mode::Dragging) {
        mode_ = Mode::Idle;
        show(history_.now());
    }
    mode_ = Mode::Idle;
    stroke_.clear();
    closesOnRelease_ = isLiveChange_ = false;
}

void DrawingSession::setLook(int curve, SketchLook look) {
    cancel();
    requireCurve(curve);
    if (look == sketch_.curves[curve]->look) {
        return;
    }
    copied(curve).look = std::move(look);
    if (curve == sketch_.active && sketch_.curves[curve]->look.isHidden) {
        sketch_.active = sketch_.selected = -1;
    }
    enter();
}

void DrawingSession::begin(std::vector<SketchCurve> curves, int active) {
    cancel();
    sketch_ = {};
    for (SketchCurve& curve : curves) {
        append(std::move(curve));
    }
    sketch_.active = active;
    history_ = SketchHistory(sketch_);
    show(history_.now());
}

void DrawingSession::add(std::vector<SketchCurve> curves) {
    newCurve();
    for (SketchCurve& curve : curves) {
        append(std::move(curve));
    }
    enter();
}

// ---- Changes ----

SketchCurve& DrawingSession::copied(int curve) {
    std::shared_ptr<SketchCurve>& place = sketch_.curves[curve];
    place = std::make_shared<SketchCurve>(*place);
    return *place;
}

SketchCurve& DrawingSession::changed() {
    SketchCurve& curve = copied(sketch_.active);
    curve.settled.reset();
    curve.isAnswered = false;
    curve.problem = {};
    return curve;
}

void DrawingSession::append(SketchCurve curve) {
    if (curve.id == 0) {
        curve.id = ++lastCurveId_;
    }
    lastCurveId_ = std::max(lastCurveId_, curve.id);
    sketch_.curves.push_back(std::make_shared<SketchCurve>(std::move(curve)));
}

// The curve that the next pick is added to.
SketchCurve& DrawingSession::begun() {
    if (sketch_.active < 0 || sketch_.activeCurve()->options.solver.closed) {
        SketchCurve curve;
        curve.options = settings_.options;
        curve.look.colour = settings_.colour;
        append(std::move(curve));
        sketch_.active = static_cast<int>(sketch_.curves.size()) - 1;
    }
    return *sketch_.activeCurve();
}

void DrawingSession::insertBehind(int after, const SurfacePoint& point) {
    SketchCurve& curve = changed();
    curve.picks.insert(curve.picks.begin() + (after + 1), pickAt(point));
    sketch_.selected = after + 1;
}

void DrawingSession::enter() {
    isLiveChange_ = false;
    history_.add(sketch_);
    settleNow();
}

void DrawingSession::settleNow() {
    dropLive();
    hovered_ = {};
    askSettled();
}

void DrawingSession::show(const Sketch& state) {
    sketch_ = state;
    hovered_ = {};
    snapped_ = {};
    askSettled();
}

void DrawingSession::requireCurve(int curve) const {
    if (curve < 0 || curve >= static_cast<int>(sketch_.curves.size())) {
        throw std::out_of_range("there is no curve " + std::to_string(curve));
    }
}

void DrawingSession::requirePick(int pick) const {
    const SketchCurve* const curve = sketch_.activeCurve();
    if (curve == nullptr || pick < 0 || pick >= static_cast<int>(curve->picks.size())) {
        throw std::out_of_range("the active curve has no pick " + std::to_string(pick));
    }
}

}  // namespace bspline_curve
