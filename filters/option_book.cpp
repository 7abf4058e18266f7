// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/option_book.h"

#include "workpiece/curve_guides.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

namespace {

// What decides the guides.
DrawnOptions choiceOf(const DrawnOptions& options) {
    DrawnOptions choice;
    choice.field = options.field;
    choice.avoid = options.avoid;
    choice.avoidThreshold = options.avoidThreshold;
    return choice;
}

}  // namespace

OptionBook::OptionBook(std::shared_ptr<const Workpiece> workpiece, LayerInput layer)
    : workpiece_(std::move(workpiece)),
      layer_(std::make_shared<const LayerInput>(std::move(layer))) {}

SketchCurveOptions OptionBook::toSketch(const DrawnOptions& options) {
    const CurveRequest request = curveRequest(valuesOf(options));
    SketchCurveOptions sketch;
    sketch.solver = request.solver;
    if (!request.field && request.avoid.by == FaceChoice::By::Nothing) {
        return sketch;
    }
    const DrawnOptions choice = choiceOf(options);
    auto entry = std::ranges::find(entries_, choice, &Entry::choice);
    if (entry == entries_.end()) {
        auto make = [workpiece = workpiece_, layer = layer_, request](const Progress& progress) {
            CurveGuides guides = curveGuides(*layer, surfaceOf(*workpiece), request, progress);
            return SketchGuides::Values{std::move(guides.field), std::move(guides.avoid)};
        };
        entries_.push_back({choice, std::make_shared<const SketchGuides>(std::move(make))});
        entry = entries_.end() - 1;
    }
    sketch.guides = entry->guides;
    return sketch;
}

DrawnOptions OptionBook::fromSketch(const SketchCurveOptions& options) const {
    const auto entry = std::ranges::find(entries_, options.guides, &Entry::guides);
    DrawnOptions drawn = entry == entries_.end() ? DrawnOptions() : entry->choice;
    drawn.closed = options.solver.closed;
    drawn.degree = options.solver.degree;
    drawn.tension = options.solver.tension;
    drawn.pickTolerance = describe(options.solver.pickTolerance);
    drawn.fieldWeight = options.solver.fieldWeight;
    return drawn;
}

}  // namespace bspline_curve
