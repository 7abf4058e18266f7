// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/filter_beside.h"
#include "edit_bspline_curve/common/sketch_layers.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// Filters that use the curves of a surface, asked for in the tool: one at a time, computed beside
/// the window, as if they were applied in their dialog, so that log and history show them.
class CurveUses {
public:
    /// `surface`: id of its layer. Document and layers must outlive this.
    CurveUses(MeshDocument& document, SketchLayers& layers, int surface)
        : document_(document), layers_(layers), surface_(surface) {}

    /// Gives up what runs.
    ~CurveUses() { finish(); }

    CurveUses(const CurveUses&) = delete;
    CurveUses& operator=(const CurveUses&) = delete;

    /// Starts a filter with the curves whose layers are shown, in place of one that runs. Throws
    /// std::runtime_error with what to tell.
    void start(const FilterDescription& filter);

    /// The one that runs; null where none does.
    [[nodiscard]] const FilterBeside* running() const { return running_.get(); }

    /// Whether something is to be done in the window's thread.
    [[nodiscard]] bool waits() const;

    /// Does a part of it that takes less than 0.2 s on a mesh of a million faces. Returns whether
    /// the results of a filter are all there now and shown. Throws std::runtime_error with what to
    /// tell.
    [[nodiscard]] bool step();

    /// Gives up the one that runs; whether there was one.
    bool cancel();

    /// The same, says so, and shows what waits to be shown.
    void finish();

private:
    void bring();

    MeshDocument& document_;
    SketchLayers& layers_;
    int surface_;
    RichParameterList parameters_;  ///< of the one that runs
    std::unique_ptr<FilterBeside> running_;
    std::vector<int> toShow_;  ///< new layers
};

}  // namespace bspline_curve
