// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"
#include "bspline_curve/workpiece.h"
#include "filters/drawn_options.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// Translates what drawing tools offer to what a session draws with, and back. Fields and faces to
/// avoid are made once for each choice.
class OptionBook {
public:
    /// `layer`: quality and selections that go with the workpiece's mesh.
    OptionBook(std::shared_ptr<const Workpiece> workpiece, LayerInput layer);

    /// Throws InputError where a number is out of its range.
    [[nodiscard]] SketchCurveOptions toSketch(const DrawnOptions& options);
    /// Of options that toSketch() made, or that have no guides.
    [[nodiscard]] DrawnOptions fromSketch(const SketchCurveOptions& options) const;

private:
    struct Entry {
        DrawnOptions choice;  ///< of what decides the guides
        std::shared_ptr<const SketchGuides> guides;
    };

    std::shared_ptr<const Workpiece> workpiece_;
    std::shared_ptr<const LayerInput> layer_;
    std::vector<Entry> entries_;
};

}  // namespace bspline_curve
