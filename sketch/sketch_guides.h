// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/scalar_field.h"
#include "utility/threads.h"

#include <functional>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The field that curves follow and the faces that they avoid. A field takes seconds on a large
/// mesh, so it is made when a curve is first solved with it, and kept. Curves share it; several
/// threads may ask for it.
class SketchGuides {
public:
    struct Values {
        ScalarField field;
        std::vector<int> avoid;  ///< faces
    };

    using Maker = std::function<Values(const Progress&)>;

    explicit SketchGuides(Maker maker) : maker_(std::move(maker)) {}

    explicit SketchGuides(Values values) : values_(std::move(values)) {}

    /// Throws what the maker throws; an InputError again without asking it once more.
    [[nodiscard]] const Values& values(const Progress& progress = {}) const;

private:
    Maker maker_;
    mutable Mutex mutex_;  // of all below
    mutable std::optional<Values> values_;
    mutable std::optional<InputError> refusal_;
};

}  // namespace bspline_curve
