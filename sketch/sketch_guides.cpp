// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/sketch_guides.h"

namespace bspline_curve {

const SketchGuides::Values& SketchGuides::values(const Progress& progress) const {
    const MutexLock lock(mutex_);
    if (refusal_) {
        throw InputError(*refusal_);
    }
    if (!values_) {
        try {
            values_ = maker_(progress);
        } catch (const InputError& error) {
            refusal_ = error;
            throw;
        }
    }
    return *values_;
}

}  // namespace bspline_curve
