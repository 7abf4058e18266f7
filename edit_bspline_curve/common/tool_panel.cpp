// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_panel.h"

#include "edit_bspline_curve/common/curve_words.h"
#include "edit_bspline_curve/common/kept_settings.h"
#include "edit_bspline_curve/common/panel_widgets.h"

#include <QCloseEvent>
#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

namespace bspline_curve {
namespace {

constexpr int kMargin = 6, kTextLines = 5, kWidth = 236, kAllDone = 100;

// Names in the host's settings.
constexpr const char* kFloating = "panel_floating";
constexpr const char* kArea = "panel_area";
constexpr const char* kGeometry = "panel_geometry";

// What people can do with curves, and how buttons name it.
struct Use {
    const FilterDescription& filter;
    QString text;
};

std::vector<Use> uses() {
    return {
        {imprintFilter(), QObject::tr("Imprint")},
        {cutFilter(), QObject::tr("Cut")},
        {segmentFilter(), QObject::tr("Segment")},
    };
}

}  // namespace

ToolPanel::ToolPanel(QWidget& view)
    : QDockWidget(tr("B-spline Curves"), view.window()),
      turn_(buttonOf(
          tr("Turn view"),
          tr("The mouse turns the view instead of drawing (Escape). While drawing, the right "
             "button "
             "or Alt turns it too, the middle button moves it, and the wheel zooms.")
      )),
      magnet_(buttonOf(
          tr("Magnet"),
          tr("Picks snap to the nearest pick of another curve, boundary, crease, ridge, valley or "
             "vertex; Ctrl does the opposite for a moment.")
      )),
      list_(new CurveList),
      options_(new OptionsForm),
      commit_(buttonOf(
          tr("Make layers (Enter)"),
          tr("Makes a layer of each curve that is new or was changed. So does the end of the tool.")
      )),
      uses_(new QWidget),
      running_(new QWidget),
      done_(new QProgressBar),
      text_(new QLabel) {
    setObjectName("bspline_curve_panel");
    setAttribute(Qt::WA_ShowWithoutActivating);
    auto* const inside = new QWidget;
    auto* const all = new QVBoxLayout(inside);
    all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    all->setSpacing(kPanelSpacing);
    addModes(*all);
    all->addWidget(list_);
    all->addWidget(options_);
    all->addWidget(commit_);
    addUses(*all);
    addFiles(*all);
    text_->setWordWrap(true);
    text_->setMinimumHeight(kTextLines * fontMetrics().lineSpacing());
    text_->setAlignment(Qt::AlignTop);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setFocusPolicy(Qt::NoFocus);
    all->addWidget(text_, 1);
    auto* const scroll = new QScrollArea;  // of a window that is too low
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(kWidth);
    scroll->setWidget(inside);
    setWidget(scroll);
    connect(commit_, &QToolButton::clicked, this, &ToolPanel::commitAsked);
    connect(options_, &OptionsForm::changed, this, &ToolPanel::optionsChanged);
    connect(options_, &OptionsForm::unitChanged, this, &ToolPanel::unitChanged);
    show(PanelState());
    place(view);
}

ToolPanel::~ToolPanel() = default;

// ---- Parts ----

void ToolPanel::addModes(QVBoxLayout& all) {
    turn_->setCheckable(true);
    magnet_->setCheckable(true);
    magnet_->setChecked(kept::isMagnetOn());
    connect(turn_, &QToolButton::toggled, this, [this](bool turns) {
        if (!isShowing_) {
            emit turnAsked(turns);
        }
    });
    connect(magnet_, &QToolButton::toggled, this, [this](bool isOn) {
        kept::setMagnetOn(isOn);
        emit magnetChanged();
    });
    const auto keyButton = [this](const QString& text, const QString& help, SketchKey key) {
        auto* const button = buttonOf(text, help);
        connect(button, &QToolButton::clicked, this, [this, key] { emit keyAsked(key); });
        return button;
    };
    auto* const kind = keyButton(
        tr("Kind"),
        tr("T: the curve passes the selected pick smoothly; in a direction, which two handles "
           "turn; at a corner; or at a corner with a direction on either side, each with a handle"),
        SketchKey::Kind
    );
    all.addLayout(rowOf({turn_, magnet_, kind}));
    all.addLayout(rowOf(
        {keyButton(tr("Undo"), tr("Ctrl+Z"), SketchKey::Undo),
         keyButton(tr("Redo"), tr("Ctrl+Y"), SketchKey::Redo),
         keyButton(tr("New"), tr("N: the next click begins a curve"), SketchKey::NewCurve),
         keyButton(
             tr("Remove"),
             tr("Delete: the selected pick, or the active curve where none is selected"),
             SketchKey::Remove
         )}
    ));
    connect(list_, &CurveList::chosen, this, &ToolPanel::curveChosen);
    connect(list_, &CurveList::lookChanged, this, &ToolPanel::lookAsked);
}

void ToolPanel::addUses(QVBoxLayout& all) {
    auto* const row = new QHBoxLayout(uses_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kPanelSpacing);
    for (const Use& use : uses()) {
        auto* const button = buttonOf(
            use.text,
            tr("Makes layers of the curves, then runs %1 with those that are shown. %2")
                .arg(
                    QString::fromStdString(use.filter.name),
                    QString::fromStdString(use.filter.shortDescription)
                )
        );
        row->addWidget(button);
        const FilterDescription* const filter = &use.filter;
        connect(button, &QToolButton::clicked, this, [this, filter] { emit useAsked(filter); });
    }
    all.addWidget(uses_);
    // In the place of these while one runs.
    auto* const cancel = buttonOf(tr("Cancel"), tr("Gives it up: the curves stay as they are."));
    cancel->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    done_->setRange(0, kAllDone);
    auto* const run = rowOf({done_, cancel});
    run->setContentsMargins(0, 0, 0, 0);
    running_->setLayout(run);
    running_->hide();
    connect(cancel, &QToolButton::clicked, this, &ToolPanel::cancelAsked);
    all.addWidget(running_);
}

void ToolPanel::addFiles(QVBoxLayout& all) {
    save_ = buttonOf(
        tr("Save …"),
        tr("The curves with their picks and options, as .json, .obj or .dxf: all can be opened "
           "again.")
    );
    open_ = buttonOf(tr("Open …"), tr("Curves of a file, to go on with."));
    connect(save_, &QToolButton::clicked, this, &ToolPanel::saveAsked);
    connect(open_, &QToolButton::clicked, this, &ToolPanel::openAsked);
    all.addLayout(rowOf({save_, open_}));
}

// ---- Place ----

// Docked, so that it does not cover the mesh, or where it was left.
void ToolPanel::place(QWidget& view) {
    auto* const window = qobject_cast<QMainWindow*>(view.window());
    const bool floats = window == nullptr || kept::value(kFloating, false).toBool();
    if (window != nullptr) {
        const auto area = static_cast<Qt::DockWidgetArea>(
            kept::value(kArea, static_cast<int>(Qt::LeftDockWidgetArea)).toInt()
        );
        window->addDockWidget(
            area == Qt::RightDockWidgetArea ? area : Qt::LeftDockWidgetArea, this
        );
    }
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    setFloating(floats);
    if (floats) {
        const QRect kept = kept::value(kGeometry).toRect();
        if (kept.isValid()) {
            setGeometry(kept);
        } else {
            adjustSize();
            move(view.mapToGlobal(QPoint(kMargin, kMargin)));
        }
    }
    QDockWidget::show();
    const auto keep = [this] { keepPlace(); };
    connect(this, &QDockWidget::topLevelChanged, this, keep);
    connect(this, &QDockWidget::dockLocationChanged, this, keep);
    connect(this, &QDockWidget::visibilityChanged, this, keep);
}

void ToolPanel::keepPlace() const {
    kept::setValue(kFloating, isFloating());
    if (isFloating()) {
        kept::setValue(kGeometry, geometry());
    } else if (const auto* const window = qobject_cast<const QMainWindow*>(parentWidget())) {
        kept::setValue(
            kArea, static_cast<int>(window->dockWidgetArea(const_cast<ToolPanel*>(this)))
        );
    }
}

void ToolPanel::closeEvent(QCloseEvent* event) {
    keepPlace();
    event->ignore();  // who owns it ends the tool, and it with that
    emit closed();
}

bool ToolPanel::isMagnetOn() const {
    return magnet_->isChecked();
}

// ---- What is to be seen ----

void ToolPanel::show(const PanelState& state) {
    const SketchCurve* const curve =
        state.session == nullptr ? nullptr : state.session->sketch().activeCurve();
    isShowing_ = true;
    turn_->setChecked(state.isTurning);
    options_->setClosable(curve != nullptr && curve->picks.size() >= 3);
    if (state.active) {
        options_->show(*state.active);
    } else {
        options_->showOpen();
    }
    const bool hasCurves = state.session != nullptr && !state.session->sketch().curves.empty();
    commit_->setEnabled(hasCurves);
    uses_->setEnabled(hasCurves);
    save_->setEnabled(hasCurves);
    open_->setEnabled(state.session != nullptr);
    if (state.session != nullptr) {
        list_->show(state.session->sketch());
        say(textOf(state));
    }
    isShowing_ = false;
}

void ToolPanel::showUse(const FilterBeside* running) {
    uses_->setVisible(running == nullptr);
    running_->setVisible(running != nullptr);
    if (running != nullptr) {
        done_->setFormat(QString::fromStdString(running->filter().name) + ": %p%");
        done_->setValue(static_cast<int>(running->done() * kAllDone));
    }
}

QString ToolPanel::textOf(const PanelState& state) const {
    if (state.isHostsCamera) {
        return tr("MeshLab has the mouse: press the icon of this tool, or Escape, to draw on.");
    }
    if (state.isTurning) {
        return tr("The mouse turns the view. Press Escape or \"Turn view\" to draw on.");
    }
    if (state.isMaking) {
        return tr("Layers are made as soon as all curves are computed …");
    }
    if (!state.notice.isEmpty()) {
        return state.notice;
    }
    const DrawingSession& session = *state.session;
    const QString snapped = session.snapped().kind == SnapKind::None
                                ? QString()
                                : tr("\nSnaps to %1.").arg(nameOf(session.snapped().kind));
    if (const SketchCurve* const curve = session.sketch().activeCurve()) {
        return wordsFor(*curve, state.edge, kept::unit()) +
               wordsForKind(*curve, session.sketch().selected) + snapped;
    }
    return tr("Click points on the surface in the order of the curve. Drag picks; click the curve "
              "to insert one, the first pick to close it. Shift removes a pick; drag with Shift to "
              "draw freehand. The right button turns the view.") +
           snapped;
}

void ToolPanel::say(const QString& text) {
    text_->setText(text);
}

}  // namespace bspline_curve
