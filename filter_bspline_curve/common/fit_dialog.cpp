// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/fit_dialog.h"

#include "filter_bspline_curve/common/window.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QWindow>
#include <algorithm>

namespace bspline_curve {

namespace {

// Window managers place a window, and tell its frame, some time after it is shown.
constexpr int kLookAgainMilliseconds = 50;
constexpr int kLooks = 20;

/// MeshLab has no translations.
QPushButton* buttonNamed(const QDockWidget& dialog, const char* text) {
    for (QPushButton* const button : dialog.findChildren<QPushButton*>()) {
        if (button->text() == text) {
            return button;
        }
    }
    return nullptr;
}

/// MeshLab's widget with all parameters.
QFrame* parameterFrameOf(const QDockWidget& dialog) {
    for (QFrame* const frame : dialog.findChildren<QFrame*>()) {
        if (frame->inherits("RichParameterListFrame")) {
            return frame;
        }
    }
    return nullptr;
}

QScrollArea* areaAround(const QWidget& widget) {
    for (QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (auto* const area = qobject_cast<QScrollArea*>(above)) {
            return area;
        }
    }
    return nullptr;
}

/// Lets the frame scroll at its place in the layout; null where it has none.
QScrollArea* makeScroll(QFrame& frame) {
    QWidget* const parent = frame.parentWidget();
    if (parent == nullptr || parent->layout() == nullptr) {
        return nullptr;
    }
    auto* const area = new QScrollArea(parent);
    delete parent->layout()->replaceWidget(&frame, area);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(&frame);
    area->show();
    frame.show();
    return area;
}

/// Where a window without its title bar and borders can be on the screen.
QRect roomFor(const QWidget& dialog) {
    QMargins borders = dialog.windowHandle()->frameMargins();
    const QWidget* const parent = dialog.parentWidget();
    if (parent != nullptr && parent->window()->windowHandle() != nullptr) {
        // Those of the dialog come late; they are hardly wider.
        const QMargins other = parent->window()->windowHandle()->frameMargins();
        borders = {
            std::max(borders.left(), other.left()),
            std::max(borders.top(), other.top()),
            std::max(borders.right(), other.right()),
            std::max(borders.bottom(), other.bottom())
        };
    }
    return dialog.windowHandle()->screen()->availableGeometry().marginsRemoved(borders);
}

int naturalHeight(const QWidget& widget) {
    const QLayout* const layout = widget.layout();
    if (layout == nullptr || !layout->hasHeightForWidth()) {
        return widget.sizeHint().height();
    }
    return layout->totalHeightForWidth(widget.width());
}

bool takesTheWheel(QObject* object) {
    return qobject_cast<QAbstractSpinBox*>(object) != nullptr ||
           qobject_cast<QComboBox*>(object) != nullptr || qobject_cast<QSlider*>(object) != nullptr;
}

/// The text field of a parameter in the frame's grid, and its row; null where it is another widget.
struct TextRow {
    QLineEdit* field = nullptr;
    int row = 0;
};

TextRow textRow(const QGridLayout& grid, const QString& label) {
    for (int row = 0; row < grid.rowCount(); ++row) {
        QLayoutItem* const left = grid.itemAtPosition(row, 0);
        QLayoutItem* const right = grid.itemAtPosition(row, 1);
        if (left == nullptr || right == nullptr) {
            continue;
        }
        const auto* const name = qobject_cast<QLabel*>(left->widget());
        if (name != nullptr && name->text() == label) {
            return {.field = qobject_cast<QLineEdit*>(right->widget()), .row = row};
        }
    }
    return {};
}

/// Asks for a file, and writes its path into a text field.
void browse(const ParameterDescription& parameter, QLineEdit& field) {
    QStringList patterns;
    for (const std::string& extension : parameter.extensions) {
        patterns << "*" + QString::fromStdString(extension);
    }
    const auto ask = parameter.type == ParameterType::OpenFile ? &QFileDialog::getOpenFileName
                                                               : &QFileDialog::getSaveFileName;
    const QPointer<QLineEdit> still = &field;
    const QString label = QString::fromStdString(parameter.label);
    const QString filters = label + " (" + patterns.join(" ") + ")";
    const QString path = ask(field.window(), label, field.text(), filters, nullptr, {});
    if (still != nullptr && !path.isEmpty()) {
        field.setText(path);
    }
}

/// A button that chooses a file beside each text field of a path.
void addBrowseButtons(QFrame& frame, const FilterDescription& filter) {
    auto* const grid = qobject_cast<QGridLayout*>(frame.layout());
    if (grid == nullptr) {
        return;
    }
    for (const ParameterDescription& parameter : filter.parameters) {
        if (parameter.type != ParameterType::OpenFile &&
            parameter.type != ParameterType::SaveFile) {
            continue;
        }
        const TextRow found = textRow(*grid, QString::fromStdString(parameter.label));
        if (found.field == nullptr) {
            continue;  // it is a widget for files, or not offered
        }
        auto* const button = new QPushButton("...", &frame);
        button->setFixedWidth(button->sizeHint().height());
        auto* const both = new QHBoxLayout();
        grid->removeWidget(found.field);
        both->addWidget(found.field, 1);
        both->addWidget(button);
        grid->addLayout(both, found.row, 1);
        QLineEdit* const field = found.field;
        QObject::connect(button, &QPushButton::clicked, field, [field, &parameter] {
            browse(parameter, *field);
        });
    }
}

/// What a dialog of ours does beside what MeshLab's do. It belongs to the dialog and ends with it.
class FittedDialog : public QObject {
public:
    /// The dialog must have such a frame and button.
    FittedDialog(
        QDockWidget& dialog, QFrame& frame, QPushButton& apply, const FilterDescription& filter
    )
        : QObject(&dialog), dialog_(dialog), frame_(&frame), apply_(&apply) {
        setObjectName(kName);
        addBrowseButtons(frame, filter);
        area_ = areaAround(frame);
        if (area_ == nullptr) {
            area_ = makeScroll(frame);
            dialog_.setMinimumSize(0, 0);  // it was that of all parameters
        }
        for (const QPushButton* const button : dialog.findChildren<QPushButton*>()) {
            // Help, and what unfolds parameters: MeshLab's own answer comes first.
            if (button->text() == "Help" || button->isFlat()) {
                connect(button, &QPushButton::clicked, this, [this] { fitSoon(); });
            }
        }
        for (QWidget* const child : frame.findChildren<QWidget*>()) {
            if (takesTheWheel(child)) {
                child->setFocusPolicy(Qt::StrongFocus);
                child->installEventFilter(this);
            }
        }
        dialog_.installEventFilter(this);
        apply.setDefault(true);
        apply.setFocus();
        dialog_.activateWindow();  // 2025.07 leaves the keys with the main window
        fitSoon();
    }

    /// Fits size and place now, and again when the window manager has placed the window.
    void fitSoon() {
        looksLeft_ = kLooks;
        look();
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == &dialog_ && event->type() == QEvent::KeyPress) {
            return applies(static_cast<QKeyEvent&>(*event));
        }
        // The wheel scrolls; it changes only a value that was clicked.
        if (event->type() == QEvent::Wheel && takesTheWheel(watched) &&
            !static_cast<QWidget*>(watched)->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }

    static constexpr const char* kName = "bspline_curve_fitted_dialog";

private:
    /// Whether a key was Enter, which no widget of the dialog took for itself.
    bool applies(const QKeyEvent& key) {
        const bool isEnter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
        if (!isEnter || (key.modifiers() & ~Qt::KeypadModifier) != 0) {
            return false;
        }
        auto* const focused = qobject_cast<QPushButton*>(QApplication::focusWidget());
        QPushButton* const pressed = focused == nullptr ? apply_.data() : focused;
        if (pressed != nullptr && !key.isAutoRepeat()) {
            // Not now: what it does may end the dialog.
            QMetaObject::invokeMethod(pressed, "click", Qt::QueuedConnection);
        }
        return true;
    }

    void look() {
        if (frame_ == nullptr || area_ == nullptr || !dialog_.isVisible() ||
            dialog_.windowHandle() == nullptr) {
            return;
        }
        const QRect room = roomFor(dialog_);
        if (looksLeft_ == kLooks) {
            fitSize(room);
        } else {
            moveInto(room);
        }
        if (--looksLeft_ > 0) {
            QTimer::singleShot(kLookAgainMilliseconds, this, [this] { look(); });
        }
    }

    /// As high as all parameters need, as far as there is room.
    void fitSize(const QRect& room) {
        const int bar = area_->verticalScrollBar()->sizeHint().width();
        const int around = dialog_.width() - area_->viewport()->width();
        area_->setMinimumWidth(
            std::min(frame_->minimumSizeHint().width() + bar, room.width() - std::max(around, 0))
        );
        // The width may change how labels break.
        for (const QWidget* widget = area_; widget != &dialog_;) {
            widget = widget->parentWidget();
            if (widget->layout() != nullptr) {
                widget->layout()->activate();
            }
        }
        dialog_.resize(
            std::min(std::max(dialog_.width(), dialog_.minimumSizeHint().width()), room.width()),
            std::min(dialog_.height(), room.height())
        );
        const int natural = naturalHeight(*frame_);
        if (frame_->minimumHeight() > 0) {
            frame_->setMinimumHeight(natural);  // 2020.09 sets it once, without the help
        }
        const int lacking = natural - area_->viewport()->height();
        dialog_.resize(dialog_.width(), std::min(dialog_.height() + lacking, room.height()));
    }

    void moveInto(const QRect& room) {
        QRect place = dialog_.geometry();
        place.setSize(place.size().boundedTo(room.size()));
        place.moveRight(std::min(place.right(), room.right()));
        place.moveBottom(std::min(place.bottom(), room.bottom()));
        place.moveLeft(std::max(place.left(), room.left()));
        place.moveTop(std::max(place.top(), room.top()));
        if (place != dialog_.geometry()) {
            dialog_.setGeometry(place);
        }
    }

    QDockWidget& dialog_;
    QPointer<QFrame> frame_;
    QPointer<QScrollArea> area_;
    QPointer<QPushButton> apply_;
    int looksLeft_ = 0;
};

void fitDialog(const QString& title, const FilterDescription& filter) {
    for (QWidget* const widget : QApplication::topLevelWidgets()) {
        auto* const dialog = qobject_cast<QDockWidget*>(widget);
        if (dialog == nullptr || !dialog->isVisible() || dialog->windowTitle() != title ||
            dialog->findChild<QObject*>(FittedDialog::kName, Qt::FindDirectChildrenOnly) !=
                nullptr) {
            continue;
        }
        QFrame* const frame = parameterFrameOf(*dialog);
        QPushButton* const apply = buttonNamed(*dialog, "Apply");
        if (frame != nullptr && apply != nullptr) {
            new FittedDialog(*dialog, *frame, *apply, filter);  // the dialog's
        }
    }
}

}  // namespace

void fitDialogSoon(const QString& title, const FilterDescription& filter) {
    if (hasWindow()) {
        QTimer::singleShot(0, qApp, [title, &filter] { fitDialog(title, filter); });
    }
}

}  // namespace bspline_curve
