// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool and its host share: keys, the window and its end, the camera.
#include "edit_bspline_curve/common/curve_tool.h"
#include "edit_bspline_curve/common/curve_words.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <algorithm>
#include <utility>

namespace bspline_curve {

// ---- Keys, and the end of the host ----

bool CurveTool::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            return takeKey(*watched, static_cast<QKeyEvent&>(*event));
        case QEvent::Close:
            if (watched == view_.window()) {
                const bool may = mayClose();
                event->setAccepted(may);
                return !may;  // nothing of the tool from here on: it may have ended
            }
            if (const auto* const widget = qobject_cast<QWidget*>(watched);
                widget != nullptr && widget->isAncestorOf(&view_)) {
                finish();  // the host asks about layers
            }
            return false;
        case QEvent::MouseButtonRelease:
            return watched == &view_ && isLent_ &&
                   returnFromCamera(static_cast<QMouseEvent&>(*event));
        case QEvent::Leave:
            if (watched == &view_ && session_) {
                session_->leave();
                refresh();
            }
            return false;
        default:
            return false;
    }
}

// Whether keys in the host's window are for this view: nothing is open above, and its document is
// the one in front.
bool CurveTool::isInFront() const {
    if (QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr || panel_ == nullptr) {
        return false;
    }
    const QWidget* const active = QApplication::activeWindow();
    if (active != view_.window() && active != panel_) {
        return false;
    }
    for (const QWidget* widget = &view_; widget != nullptr; widget = widget->parentWidget()) {
        if (const auto* const document = qobject_cast<const QMdiSubWindow*>(widget)) {
            return document->mdiArea() == nullptr ||
                   document->mdiArea()->currentSubWindow() == document;
        }
    }
    return true;
}

// Whether nobody else is to have the key. The host's shortcuts never have it.
bool CurveTool::takeKey(QObject& watched, QKeyEvent& event) {
    const std::optional<ToolKey> key = toolKeyOf(event);
    if (!key || !isInFront()) {
        return false;
    }
    if (event.type() == QEvent::ShortcutOverride) {
        event.accept();
        return true;
    }
    const bool isOnItsWay = !watched.isWidgetType();  // to a widget
    if (isOnItsWay || !isForTool(*key, QApplication::focusWidget(), *panel_)) {
        return false;
    }
    event.accept();
    run(*key);
    return true;
}

void CurveTool::run(const ToolKey& key) {
    switch (key.action) {
        case ToolKey::Action::Sketch:
            runKey(key.sketch);
            break;
        case ToolKey::Action::MakeLayers:
            makeLayers();
            break;
        case ToolKey::Action::TurnView:
            if (isHostsCamera()) {
                suspending_->trigger();
            } else if (session_ && session_->isDragging()) {
                runKey(SketchKey::Cancel);
            } else {
                setTurning(!isTurning_);
            }
            break;
        case ToolKey::Action::Nothing:
            break;
    }
}

void CurveTool::runKey(SketchKey key) {
    notice_.clear();
    if (session_ && seen_) {
        Pointer pointer = seen_->pointerAt(last_);
        pointer.snaps = kept::isMagnetOn();
        session_->key(key, pointer);
        refresh();
    }
}

bool CurveTool::isSaved(const std::shared_ptr<SketchCurve>& curve) const {
    return layers_.isSaved(*curve) || std::ranges::find(saved_, curve) != saved_.end();
}

// The host does not ask, so this does.
bool CurveTool::mayClose() {
    if (!session_) {
        return true;
    }
    session_->cancel();
    const std::vector<std::shared_ptr<SketchCurve>>& curves = session_->sketch().curves;
    const auto count = static_cast<int>(std::ranges::count_if(curves, [&](const auto& curve) {
        return !isSaved(curve);
    }));
    if (count == 0) {
        return true;
    }
    QMessageBox question(
        QMessageBox::Question,
        tr("B-spline Curves"),
        tr("%1 that you drew %2 not saved in a file.")
            .arg(countText(count, "curve"), count == 1 ? "is" : "are"),
        QMessageBox::NoButton,
        view_.window()
    );
    const QPushButton* const saves = question.addButton(tr("Save …"), QMessageBox::AcceptRole);
    question.addButton(tr("Close without saving"), QMessageBox::DestructiveRole);
    QPushButton* const stay = question.addButton(tr("Go on drawing"), QMessageBox::RejectRole);
    question.setDefaultButton(stay);
    question.setEscapeButton(stay);
    const QPointer<CurveTool> self(this);
    question.exec();
    if (question.clickedButton() == saves) {
        // Where the tool ended meanwhile, and made layers, the window stays for these.
        return !self.isNull() && save();
    }
    return question.clickedButton() != stay;
}

// ---- The camera ----

// The host gives all events to the tool while it is not suspended.
void CurveTool::toggleCamera() {
    QMetaObject::invokeMethod(&view_, "suspendEditToggle");
}

bool CurveTool::isHostsCamera() const {
    return suspending_ != nullptr && suspending_->isEnabled() && suspending_->isChecked();
}

void CurveTool::setTurning(bool turns) {
    isTurning_ = turns;
    if (session_) {
        session_->cancel();
        session_->leave();
    }
    refresh();
}

// The right button turns the view as the left one does in the host's camera, since the left one
// draws.
void CurveTool::lendToCamera(QMouseEvent& event) {
    isLent_ = true;
    toggleCamera();
    const auto asLeft = [](Qt::MouseButton button) {
        return button == Qt::RightButton ? Qt::LeftButton : button;
    };
    QMouseEvent same(
        event.type(),
        event.localPos(),
        event.windowPos(),
        event.screenPos(),
        asLeft(event.button()),
        asLeft(event.button()),
        // What the tool alone asked for is not the camera's.
        event.modifiers() & ~Qt::KeyboardModifiers(Qt::AltModifier)
    );
    QCoreApplication::sendEvent(&view_, &same);
}

// Whether the event was handed on in another shape.
bool CurveTool::returnFromCamera(QMouseEvent& event) {
    // After the camera had it.
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (std::exchange(isLent_, false)) {
                toggleCamera();
            }
        },
        Qt::QueuedConnection
    );
    if (event.button() != Qt::RightButton) {
        return false;
    }
    QMouseEvent asLeft(
        event.type(),
        event.localPos(),
        event.windowPos(),
        event.screenPos(),
        Qt::LeftButton,
        Qt::NoButton,
        event.modifiers()
    );
    QCoreApplication::sendEvent(&view_, &asLeft);
    return true;
}

}  // namespace bspline_curve
