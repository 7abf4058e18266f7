// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"

#include <optional>

class QKeyEvent;
class QWidget;

namespace bspline_curve {

/// What a key means to the drawing tool.
struct ToolKey {
    enum class Action {
        Sketch,      ///< `sketch`
        MakeLayers,  ///< of what is drawn
        TurnView,    ///< ends a drag; else the mouse turns the view, or draws again
        Nothing,     ///< but the host must not have it either
    };

    Action action = Action::Nothing;
    SketchKey sketch = SketchKey::Cancel;
};

/// None: the key is the host's.
[[nodiscard]] std::optional<ToolKey> toolKeyOf(const QKeyEvent& event);

/// Whether a key of the tool goes to it, and not to what has the focus: fields that something is
/// typed into keep theirs, but for undo and redo in the tool's own panel, and letters in its fields
/// of numbers.
[[nodiscard]] bool isForTool(const ToolKey& key, const QWidget* focus, const QWidget& panel);

}  // namespace bspline_curve
