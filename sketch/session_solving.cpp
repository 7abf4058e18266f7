// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that a session asks its worker for, and what it does with the answers.
#include "sketch/session_parts.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

std::uint64_t DrawingSession::ask(Asking kind, std::shared_ptr<SketchCurve> curve) {
    asked_.push_back({++lastId_, kind, std::move(curve)});
    return lastId_;
}

void DrawingSession::askLive() {
    preview_.reset();
    const std::shared_ptr<SketchCurve>& curve = sketch_.curves[sketch_.active];
    if (!curve->isDrawable()) {
        return;
    }
    const bool canStart = curve->last && curve->lastPicks.size() == curve->picks.size();
    solver_->worker.askLive(
        {ask(Asking::Live, curve),
         curve->positions(),
         curve->corners(),
         curve->tangents(),
         curve->options,
         canStart ? curve->last : nullptr}
    );
}

void DrawingSession::askPreview(const SurfacePoint& point) {
    const SketchCurve& curve = *sketch_.activeCurve();
    std::vector<Vec3> picks = curve.positions();
    picks.push_back(pickAt(point).position);
    std::vector<PickTangent> tangents = curve.tangents();
    if (!tangents.empty()) {
        tangents.emplace_back();
    }
    solver_->worker.askLive(
        {ask(Asking::Preview, nullptr),
         std::move(picks),
         curve.corners(),
         std::move(tangents),
         curve.options,
         nullptr}
    );
}

bool DrawingSession::isOfDrag(Asking kind) {
    return kind == Asking::Live || kind == Asking::Preview;
}

// Strokes first, then curves from scratch in the order of the sketch.
void DrawingSession::askSettled() {
    const auto isGone = [&](const auto& asked) {
        return asked.curve != nullptr &&
               std::ranges::find(sketch_.curves, asked.curve) == sketch_.curves.end();
    };
    std::erase_if(strokes_, isGone);
    std::erase_if(asked_, [&](const Asked& asked) {
        return !isOfDrag(asked.kind) && isGone(asked);
    });
    const auto idOf = [&](Asking kind, const std::shared_ptr<SketchCurve>& curve) {
        const auto before = std::ranges::find_if(asked_, [&](const Asked& asked) {
            return asked.kind == kind && asked.curve == curve;
        });
        return before != asked_.end() ? before->id : ask(kind, curve);
    };
    std::vector<SolveRequest> requests;
    for (const AskedStroke& stroke : strokes_) {
        requests.push_back(fitRequest(stroke, idOf(Asking::Stroke, stroke.curve)));
    }
    for (const std::shared_ptr<SketchCurve>& curve : sketch_.curves) {
        const bool isFitted =
            std::ranges::find(strokes_, curve, &AskedStroke::curve) != strokes_.end();
        if (curve->isSettled() || isFitted) {
            continue;
        }
        const std::uint64_t id = idOf(Asking::Settled, curve);
        requests.push_back(
            {id, curve->positions(), curve->corners(), curve->tangents(), curve->options, nullptr}
        );
    }
    solver_->worker.askOthers(std::move(requests));
}

void DrawingSession::dropLive() {
    preview_.reset();
    solver_->worker.dropLive();
    std::erase_if(asked_, [](const Asked& asked) { return isOfDrag(asked.kind); });
}

bool DrawingSession::update() {
    bool isOther = false;
    for (SolveAnswer& answer : solver_->worker.takeAnswers()) {
        isOther = take({std::move(answer)}) || isOther;
    }
    return isOther;
}

bool DrawingSession::take(const Answer& answer) {
    const auto place = std::ranges::find(asked_, answer.id, &Asked::id);
    if (place == asked_.end()) {
        return false;
    }
    const Asked asked = std::move(*place);
    asked_.erase(place);
    if (asked.kind == Asking::Settled) {
        SketchCurve& curve = *asked.curve;
        curve.settled = answer.curve;
        curve.isAnswered = true;
        curve.problem = answer.problem;
        if (answer.curve) {
            curve.last = answer.curve;
            curve.lastPicks = answer.picks;
        }
        return true;
    }
    if (asked.kind == Asking::Stroke) {
        takeStroke(answer, asked.curve);
        return true;
    }
    // Answers come in the order of their requests; older requests were replaced.
    std::erase_if(asked_, [&](const Asked& other) {
        return isOfDrag(other.kind) && other.id < answer.id;
    });
    if (asked.kind == Asking::Preview) {
        preview_ = mode_ == Mode::Idle ? answer.curve : nullptr;
        return true;
    }
    SketchCurve* const curve = mode_ == Mode::Dragging ? sketch_.activeCurve() : nullptr;
    if (curve == nullptr || curve->picks.size() != answer.picks.size()) {
        return false;
    }
    if (answer.curve) {
        curve->last = answer.curve;
        curve->lastPicks = answer.picks;
        curve->problem = {};
    } else if (curve->positions() == answer.picks) {
        curve->problem = answer.problem;
    }
    return true;
}

bool DrawingSession::isSettled() const {
    return std::ranges::all_of(sketch_.curves, [](const std::shared_ptr<SketchCurve>& curve) {
        return curve->isSettled();
    });
}

// Whether more answers of that kind are to come: none for a curve whose pick is being dragged.
bool DrawingSession::isSettling() const {
    return std::ranges::any_of(asked_, [](const Asked& asked) { return !isOfDrag(asked.kind); });
}

void DrawingSession::settle() {
    static_cast<void>(update());
    while (isSettling()) {
        solver_->worker.wait();
        static_cast<void>(update());
    }
}

bool DrawingSession::settleWithin(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    static_cast<void>(update());
    while (isSettling() && solver_->worker.waitUntil(end)) {
        static_cast<void>(update());
    }
    return isSettled();
}

}  // namespace bspline_curve
