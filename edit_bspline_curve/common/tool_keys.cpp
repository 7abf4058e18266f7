// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_keys.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <array>

namespace bspline_curve {
namespace {

struct KeyBinding {
    int key;
    Qt::KeyboardModifiers modifiers;
    SketchKey means;
};

const std::array kBindings = {
    KeyBinding{Qt::Key_Z, Qt::ControlModifier, SketchKey::Undo},
    KeyBinding{Qt::Key_Y, Qt::ControlModifier, SketchKey::Redo},
    KeyBinding{Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier, SketchKey::Redo},
    KeyBinding{Qt::Key_A, Qt::NoModifier, SketchKey::Add},
    KeyBinding{Qt::Key_M, Qt::NoModifier, SketchKey::Move},
    KeyBinding{Qt::Key_Period, Qt::NoModifier, SketchKey::Next},
    KeyBinding{Qt::Key_Comma, Qt::NoModifier, SketchKey::Previous},
    KeyBinding{Qt::Key_K, Qt::NoModifier, SketchKey::NextCurve},
    KeyBinding{Qt::Key_Delete, Qt::NoModifier, SketchKey::Remove},
    KeyBinding{Qt::Key_Backspace, Qt::NoModifier, SketchKey::Remove},
    KeyBinding{Qt::Key_C, Qt::NoModifier, SketchKey::Close},
    KeyBinding{Qt::Key_N, Qt::NoModifier, SketchKey::NewCurve},
    KeyBinding{Qt::Key_T, Qt::NoModifier, SketchKey::Kind},
    KeyBinding{Qt::Key_X, Qt::NoModifier, SketchKey::Cancel},
};

bool isText(const QWidget* focus) {
    return qobject_cast<const QLineEdit*>(focus) != nullptr ||
           qobject_cast<const QTextEdit*>(focus) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(focus) != nullptr;
}

bool isHistory(const ToolKey& key) {
    return key.action == ToolKey::Action::Sketch &&
           (key.sketch == SketchKey::Undo || key.sketch == SketchKey::Redo);
}

// What a field of numbers has no use for.
bool isLetter(const ToolKey& key) {
    if (key.action != ToolKey::Action::Sketch) {
        return false;
    }
    switch (key.sketch) {
        case SketchKey::Next:
        case SketchKey::Previous:
        case SketchKey::Remove:
            return false;
        default:
            return true;
    }
}

}  // namespace

std::optional<ToolKey> toolKeyOf(const QKeyEvent& event) {
    // A key of the number pad is the same key.
    const Qt::KeyboardModifiers modifiers =
        event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    const bool isPlain = modifiers == Qt::NoModifier;
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return isPlain ? std::optional(ToolKey{ToolKey::Action::MakeLayers}) : std::nullopt;
        case Qt::Key_Escape:
            return ToolKey{ToolKey::Action::TurnView};
        default:
            break;
    }
    for (const KeyBinding& binding : kBindings) {
        if (binding.key == event.key() && binding.modifiers == modifiers) {
            return ToolKey{ToolKey::Action::Sketch, binding.means};
        }
    }
    // With Shift or Ctrl a host deletes other parts of the mesh.
    if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace) {
        return ToolKey{ToolKey::Action::Nothing};
    }
    return std::nullopt;
}

bool isForTool(const ToolKey& key, const QWidget* focus, const QWidget& panel) {
    const bool isOwn = focus != nullptr && panel.isAncestorOf(focus);
    if (isOwn && isHistory(key)) {
        return true;
    }
    if (qobject_cast<const QAbstractSpinBox*>(focus) != nullptr) {
        return isOwn && isLetter(key);
    }
    if (qobject_cast<const QComboBox*>(focus) != nullptr) {
        return !isLetter(key);  // letters choose
    }
    return !isText(focus);
}

}  // namespace bspline_curve
