// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/curve_worker.h"

#include "bspline_curve/error.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace bspline_curve {
namespace {

bool namesPicks(InputErrorCode code) {
    return code == InputErrorCode::PickTooFar || code == InputErrorCode::CoincidentPicks ||
           code == InputErrorCode::PicksOnDifferentComponents ||
           code == InputErrorCode::PickAvoided;
}

}  // namespace

CurveWorker::CurveWorker(std::shared_ptr<const CurveDesigner> designer, std::function<void()> wake)
    : designer_(std::move(designer)),
      wake_(std::move(wake)),
      thread_(startThread([this] { serve(); })) {}

CurveWorker::~CurveWorker() {
    {
        const MutexLock lock(mutex_);
        isEnding_ = isGivenUp_ = true;
    }
    changed_.notifyAll();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void CurveWorker::askLive(SolveRequest request) {
    {
        const MutexLock lock(mutex_);
        live_ = std::move(request);
        if (running_ && !isRunningLive_ && !isGivenUp_) {
            isGivenUp_ = isPostponed_ = true;
        }
    }
    changed_.notifyAll();
}

void CurveWorker::dropLive() {
    const MutexLock lock(mutex_);
    live_.reset();
    isGivenUp_ = isGivenUp_ || isRunningLive_;
}

void CurveWorker::askOthers(std::vector<SolveRequest> requests) {
    {
        const MutexLock lock(mutex_);
        others_ = std::move(requests);
        if (running_ && !isRunningLive_) {
            const auto same = std::ranges::find(others_, *running_, &SolveRequest::id);
            isPostponed_ = false;  // it is among them, or is not wanted any more
            if (same == others_.end()) {
                isGivenUp_ = true;
            } else if (!isGivenUp_) {
                others_.erase(same);
            }
        }
    }
    changed_.notifyAll();
}

std::vector<SolveAnswer> CurveWorker::takeAnswers() {
    solveHere();
    const MutexLock lock(mutex_);
    return std::exchange(answers_, {});
}

void CurveWorker::wait() {
    solveHere();
    MutexLock lock(mutex_);
    changed_.wait(lock, [this] { return isWorthWaking(); });
}

bool CurveWorker::waitUntil(std::chrono::steady_clock::time_point end) {
    solveHere();
    MutexLock lock(mutex_);
    return changed_.waitUntil(lock, end, [this] { return isWorthWaking(); });
}

// Under the lock: there is an answer, or none will come.
bool CurveWorker::isWorthWaking() const {
    return !answers_.empty() || (!running_ && !live_ && others_.empty());
}

void CurveWorker::serve() {
    MutexLock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return isEnding_ || live_ || !others_.empty(); });
        if (isEnding_) {
            return;
        }
        solveNext(lock);
    }
}

// Without a thread, so that what waits is solved all the same.
void CurveWorker::solveHere() {
    if (thread_.joinable()) {
        return;
    }
    MutexLock lock(mutex_);
    if (live_ || !others_.empty()) {
        solveNext(lock);
    }
}

// Under the lock, which is open while a curve is solved. Expects one that waits.
void CurveWorker::solveNext(MutexLock& lock) {
    isRunningLive_ = live_.has_value();
    SolveRequest request;
    if (isRunningLive_) {
        request = std::move(*live_);
        live_.reset();
    } else {
        request = std::move(others_.front());
        others_.erase(others_.begin());
    }
    running_ = request.id;
    isGivenUp_ = isPostponed_ = false;
    lock.unlock();
    std::optional<SolveAnswer> answer;
    try {
        answer = answerTo(request, [this](double, const char*) {
            const MutexLock inner(mutex_);
            return !isGivenUp_;
        });
    } catch (const Cancelled&) {
        answer.reset();
    }
    lock.lock();
    running_.reset();
    if (answer) {
        answers_.push_back(std::move(*answer));
    } else if (isPostponed_) {
        others_.insert(others_.begin(), std::move(request));
    }
    isRunningLive_ = false;
    lock.unlock();
    changed_.notifyAll();
    if (answer && wake_) {
        wake_();
    }
    lock.lock();
}

Progress CurveWorker::untilTheEnd() const {
    return [this](double, const char*) {
        const MutexLock lock(mutex_);
        return !isEnding_;
    };
}

SolveAnswer CurveWorker::answerTo(const SolveRequest& request, const Progress& progress) const {
    SolveAnswer answer{request.id, request.picks, nullptr, {}};
    CurveInputs inputs;
    inputs.start = request.start.get();
    inputs.isPreview = request.start != nullptr;  // from scratch once the pick is let go
    inputs.corners = request.corners;
    inputs.tangents = request.tangents;
    try {
        if (!request.line.empty()) {
            answer.curve = std::make_shared<const Curve>(
                designer_->fit(request.line, request.fit, request.options.solver, {}, progress)
            );
            return answer;
        }
        if (request.options.guides) {
            // Further requests need it as well, so it is finished where this one is given up.
            const SketchGuides::Values& values = request.options.guides->values(untilTheEnd());
            inputs.field = values.field;
            inputs.avoid = values.avoid;
        }
        answer.curve = std::make_shared<const Curve>(
            designer_->design(request.picks, request.options.solver, {}, inputs, progress)
        );
    } catch (const InputError& error) {
        answer.problem.message = error.what();
        answer.problem.remedy = error.remedy();
        if (namesPicks(error.code())) {
            answer.problem.picks.assign(error.elements().begin(), error.elements().end());
        }
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        answer.problem.message = std::string("the solver failed: ") + error.what();
    }
    return answer;
}

}  // namespace bspline_curve
