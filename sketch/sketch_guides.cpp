// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/sketch.h"
#include "utility/threads.h"

#include <optional>

namespace bspline_curve {

struct SketchGuides::State {
    explicit State(Maker own) : maker(std::move(own)) {}

    Maker maker;
    Mutex mutex;  // of all below
    std::optional<Values> values;
    std::optional<InputError> refusal;
};

SketchGuides::SketchGuides(Maker maker) : state_(std::make_shared<State>(std::move(maker))) {}

SketchGuides::SketchGuides(Values values) : SketchGuides(Maker()) {
    state_->values = std::move(values);
}

const SketchGuides::Values& SketchGuides::values(const Progress& progress) const {
    const MutexLock lock(state_->mutex);
    if (state_->refusal) {
        throw InputError(*state_->refusal);
    }
    if (!state_->values) {
        try {
            state_->values = state_->maker(progress);
        } catch (const InputError& error) {
            state_->refusal = error;
            throw;
        }
    }
    return *state_->values;
}

}  // namespace bspline_curve
