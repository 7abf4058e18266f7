// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"
#include "design/curve_designer.h"
#include "utility/threads.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A curve to be solved.
struct SolveRequest {
    std::uint64_t id = 0;  ///< of whoever asks; comes back with the answer
    std::vector<Vec3> picks;
    std::vector<int> corners;           ///< of these
    std::vector<PickTangent> tangents;  ///< likewise, see CurveInputs::tangents
    SketchCurveOptions options;
    std::shared_ptr<const Curve> start;  ///< see CurveInputs::start; null: from scratch
    /// A curve along this line is asked for, see CurveDesigner::fit(), in place of one through the
    /// picks; empty: none.
    std::vector<Vec3> line{};
    FitOptions fit{};
};

struct SolveAnswer {
    std::uint64_t id = 0;
    std::vector<Vec3> picks;             ///< those that were asked for
    std::shared_ptr<const Curve> curve;  ///< null: there is none, see `problem`
    SketchProblem problem;
};

/// Solves curves on a thread of its own: first the live one, of which there is one at a time and
/// the newest wins, then the others in their order. A live request that is being solved is
/// finished, so that answers keep coming while a mouse moves faster than curves are solved; one of
/// the others is given up for it and begun again later.
///
/// Where there are no threads, whoever takes or waits for answers solves: one curve at each call.
class CurveWorker {
public:
    /// `wake` is called on the worker's thread after each answer; may be empty.
    explicit CurveWorker(
        std::shared_ptr<const CurveDesigner> designer, std::function<void()> wake = {}
    );
    ~CurveWorker();
    CurveWorker(const CurveWorker&) = delete;
    CurveWorker& operator=(const CurveWorker&) = delete;

    /// Replaces the live request that waits.
    void askLive(SolveRequest request);
    /// Replaces the others, in the order in which they are to be solved; one that is being solved
    /// and is not among them is given up.
    void askOthers(std::vector<SolveRequest> requests);
    /// Gives up what is asked for and what is being solved.
    void dropLive();

    /// The answers since the last call, oldest first.
    [[nodiscard]] std::vector<SolveAnswer> takeAnswers();
    /// Waits until there is an answer or nothing is left to solve.
    void wait();
    /// The same, but no longer than until then; whether there was something before.
    [[nodiscard]] bool waitUntil(std::chrono::steady_clock::time_point end);

private:
    [[nodiscard]] bool isWorthWaking() const;
    void serve();
    void solveNext(MutexLock& lock);
    void solveHere();
    [[nodiscard]] Progress untilTheEnd() const;
    [[nodiscard]] SolveAnswer answerTo(const SolveRequest& request, const Progress& progress) const;

    std::shared_ptr<const CurveDesigner> designer_;
    std::function<void()> wake_;
    mutable Mutex mutex_;  // of all below
    Condition changed_;
    std::optional<SolveRequest> live_;
    std::vector<SolveRequest> others_;
    std::optional<std::uint64_t> running_;  // id
    bool isRunningLive_ = false;
    bool isGivenUp_ = false;    // the one that runs
    bool isPostponed_ = false;  // interrupted for a live one, to be begun again
    bool isEnding_ = false;
    std::vector<SolveAnswer> answers_;
    Thread thread_;  // last: it uses the others
};

}  // namespace bspline_curve
