// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_panel.h"

#include "edit_bspline_curve/common/curve_words.h"
#include "edit_bspline_curve/common/kept_settings.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

constexpr int kMargin = 6, kSpacing = 4, kTextLines = 5, kWidth = 236;
constexpr int kMostDegree = 4;
constexpr int kTensionSteps = 100;  // of the slider, over [0, 1]
constexpr double kLargest = 1e9;
constexpr double kWeightStep = 500.0, kThresholdStep = 0.05;

// Names in the host's settings.
constexpr const char* kFloating = "panel_floating";
constexpr const char* kArea = "panel_area";
constexpr const char* kGeometry = "panel_geometry";
constexpr const char* kMore = "panel_more";

// ---- Widgets for parameters of the filter ----

const ParameterDescription& parameter(const char* id) {
    return curveFilter().parameter(id);
}

QString helpOf(const ParameterDescription& described) {
    return QString("<p>%1</p>")
        .arg(QString::fromStdString(described.fullHelp()).toHtmlEscaped().replace('\n', "<br>"));
}

QComboBox* choiceOf(const char* id) {
    const ParameterDescription& described = parameter(id);
    auto* const box = new QComboBox;
    for (const EnumOption& option : described.options) {
        box->addItem(QString::fromStdString(option.label), QString::fromStdString(option.id));
    }
    box->setToolTip(helpOf(described));
    box->setFocusPolicy(Qt::TabFocus);  // else letters would choose an option after a click
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    return box;
}

QDoubleSpinBox* numberOf(const char* id, double least, double most, int decimals) {
    const ParameterDescription& described = parameter(id);
    auto* const box = new QDoubleSpinBox;
    box->setRange(described.min.value_or(least), described.max.value_or(most));
    box->setDecimals(decimals);
    box->setToolTip(helpOf(described));
    box->setKeyboardTracking(false);  // what is half typed is no number yet
    return box;
}

std::string chosen(const QComboBox& box) {
    return box.currentData().toString().toStdString();
}

void choose(QComboBox& box, const std::string& id) {
    box.setCurrentIndex(box.findData(QString::fromStdString(id)));
}

QToolButton* buttonOf(const QString& text, const QString& help) {
    auto* const button = new QToolButton;
    button->setText(text);
    button->setToolTip(help);
    button->setFocusPolicy(Qt::NoFocus);  // keys go on to the view
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
    auto* const row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    for (QWidget* const widget : widgets) {
        row->addWidget(widget);
    }
    return row;
}

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
      isClosed_(new QCheckBox(tr("closed"))),
      degree_(new QSpinBox),
      tension_(new QSlider(Qt::Horizontal)),
      tensionText_(new QLabel),
      field_(choiceOf("field")),
      fieldWeight_(numberOf("field_weight", 0.0, kLargest, 1)),
      avoid_(choiceOf("avoid")),
      avoidThreshold_(numberOf("avoid_threshold", -kLargest, kLargest, 4)),
      commit_(buttonOf(
          tr("Make layers (Enter)"),
          tr("Makes a layer of each curve that is new or was changed. So does the end of the tool.")
      )),
      uses_(new QWidget),
      unit_(new QComboBox),
      text_(new QLabel) {
    setObjectName("bspline_curve_panel");
    setAttribute(Qt::WA_ShowWithoutActivating);
    auto* const inside = new QWidget;
    auto* const all = new QVBoxLayout(inside);
    all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    all->setSpacing(kSpacing);
    addModes(*all);
    all->addWidget(list_);
    addOptions(*all);
    addMoreOptions(*all);
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
    setOptions(DrawnOptions());
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
    all.addLayout(rowOf({turn_, magnet_}));
    const auto keyButton = [this](const QString& text, const QString& help, SketchKey key) {
        auto* const button = buttonOf(text, help);
        connect(button, &QToolButton::clicked, this, [this, key] { emit keyAsked(key); });
        return button;
    };
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

void ToolPanel::addOptions(QVBoxLayout& all) {
    degree_->setRange(
        static_cast<int>(parameter("degree").min.value_or(1)),
        static_cast<int>(parameter("degree").max.value_or(kMostDegree))
    );
    degree_->setToolTip(helpOf(parameter("degree")));
    isClosed_->setToolTip(helpOf(parameter("closed")));
    tension_->setRange(0, kTensionSteps);
    tension_->setFocusPolicy(Qt::NoFocus);
    tension_->setToolTip(helpOf(parameter("tension")));
    tensionText_->setMinimumWidth(fontMetrics().horizontalAdvance("0.00 "));
    connect(isClosed_, &QCheckBox::toggled, this, &ToolPanel::changed);
    connect(degree_, qOverload<int>(&QSpinBox::valueChanged), this, &ToolPanel::changed);
    connect(tension_, &QSlider::valueChanged, this, &ToolPanel::tensionChanged);
    connect(tension_, &QSlider::sliderReleased, this, &ToolPanel::changed);
    isClosed_->setFocusPolicy(Qt::NoFocus);
    auto* const first = rowOf({isClosed_, new QLabel(tr("degree")), degree_});
    first->setStretch(0, 1);
    all.addLayout(first);
    auto* const form = new QFormLayout;
    form->setSpacing(kSpacing);
    form->addRow(tr("tension"), rowOf({tension_, tensionText_}));
    form->addRow(tr("field"), field_);
    all.addLayout(form);
}

void ToolPanel::addMoreOptions(QVBoxLayout& all) {
    fieldWeight_->setSingleStep(kWeightStep);
    avoidThreshold_->setSingleStep(kThresholdStep);
    unit_->setEditable(true);
    unit_->addItems({"", "mm", "cm", "m", "in"});
    unit_->setEditText(kept::unit());
    unit_->setToolTip(
        tr("The unit of the mesh, which its file does not tell: shown after lengths.")
    );
    auto* const folded = new QWidget;
    auto* const form = new QFormLayout(folded);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(kSpacing);
    form->addRow(tr("weight"), fieldWeight_);
    form->addRow(tr("avoid"), avoid_);
    form->addRow(tr("threshold"), avoidThreshold_);
    form->addRow(tr("unit"), unit_);
    auto* const more =
        buttonOf(tr("More options"), tr("Weight of the field, faces to avoid, unit"));
    more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    more->setAutoRaise(true);
    more->setCheckable(true);
    const auto fold = [more, folded](bool isOpen) {
        more->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        folded->setVisible(isOpen);
        kept::setValue(kMore, isOpen);
    };
    connect(more, &QToolButton::toggled, folded, fold);
    const bool wasOpen = kept::value(kMore, false).toBool();
    more->setChecked(wasOpen);
    all.addWidget(more);
    all.addWidget(folded);
    fold(wasOpen);
    for (const QDoubleSpinBox* const box : {fieldWeight_, avoidThreshold_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ToolPanel::changed);
    }
    for (const QComboBox* const box : {field_, avoid_}) {
        connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &ToolPanel::changed);
    }
    connect(unit_, &QComboBox::editTextChanged, this, [this](const QString& unit) {
        kept::setUnit(unit.trimmed());
        emit unitChanged();
    });
}

void ToolPanel::addUses(QVBoxLayout& all) {
    auto* const row = new QHBoxLayout(uses_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpacing);
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

// ---- Options ----

bool ToolPanel::isMagnetOn() const {
    return magnet_->isChecked();
}

void ToolPanel::changed() {
    if (!isShowing_) {
        enableOptions();
        emit optionsChanged(options(), false);
    }
}

void ToolPanel::tensionChanged(int steps) {
    if (!isShowing_) {
        tensionValue_ = static_cast<double>(steps) / kTensionSteps;
        tensionText_->setText(QString::number(tensionValue_, 'f', 2));
        emit optionsChanged(options(), tension_->isSliderDown());
    }
}

void ToolPanel::setOptions(const DrawnOptions& options) {
    const bool wasShowing = std::exchange(isShowing_, true);
    isClosed_->setChecked(options.closed);
    degree_->setValue(options.degree);
    if (!tension_->isSliderDown()) {
        tension_->setValue(static_cast<int>(std::lround(options.tension * kTensionSteps)));
    }
    tensionValue_ = options.tension;
    tensionText_->setText(QString::number(tensionValue_, 'f', 2));
    choose(*field_, options.field);
    fieldWeight_->setValue(options.fieldWeight);
    choose(*avoid_, options.avoid);
    avoidThreshold_->setValue(options.avoidThreshold);
    enableOptions();
    isShowing_ = wasShowing;
}

void ToolPanel::enableOptions() {
    fieldWeight_->setEnabled(chosen(*field_) != DrawnOptions().field);
    const auto& rule = parameter("avoid_threshold").enabledWhen;
    avoidThreshold_->setEnabled(!rule || std::ranges::count(rule->values, chosen(*avoid_)) > 0);
}

DrawnOptions ToolPanel::options() const {
    return {
        .closed = isClosed_->isChecked(),
        .degree = degree_->value(),
        .tension = tensionValue_,
        .field = chosen(*field_),
        .fieldWeight = fieldWeight_->value(),
        .avoid = chosen(*avoid_),
        .avoidThreshold = avoidThreshold_->value()
    };
}

// ---- What is to be seen ----

void ToolPanel::show(const PanelState& state) {
    const SketchCurve* const curve =
        state.session == nullptr ? nullptr : state.session->sketch().activeCurve();
    isShowing_ = true;
    turn_->setChecked(state.isTurning);
    isClosed_->setEnabled(curve != nullptr && curve->picks.size() >= 3);
    if (state.active) {
        setOptions(*state.active);
    } else {
        isClosed_->setChecked(false);
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
        return wordsFor(*curve, state.edge, kept::unit()) + snapped;
    }
    return tr("Click points on the surface in the order of the curve. Drag picks; click the curve "
              "to insert one, the first pick to close it. Shift removes. The right button turns "
              "the "
              "view.") +
           snapped;
}

void ToolPanel::say(const QString& text) {
    text_->setText(text);
}

}  // namespace bspline_curve
