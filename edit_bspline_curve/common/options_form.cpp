// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/options_form.h"

#include "edit_bspline_curve/common/kept_settings.h"
#include "edit_bspline_curve/common/panel_widgets.h"
#include "filters/filter_description.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

constexpr int kMostDegree = 4;
constexpr int kTensionSteps = 100;  // of the slider, over [0, 1]
// Of the slider for the tolerance of picks, over so many mean edges.
constexpr int kToleranceSteps = 60;
constexpr double kMostTolerance = 3.0;
constexpr double kLargest = 1e9;
constexpr double kWeightStep = 500.0, kThresholdStep = 0.05;

// In the host's settings.
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

}  // namespace

OptionsForm::OptionsForm()
    : isClosed_(new QCheckBox(tr("closed"))),
      degree_(new QSpinBox),
      tension_(new QSlider(Qt::Horizontal)),
      tensionText_(new QLabel),
      tolerance_(new QSlider(Qt::Horizontal)),
      toleranceText_(new QLabel),
      field_(choiceOf("field")),
      fieldWeight_(numberOf("field_weight", 0.0, kLargest, 1)),
      avoid_(choiceOf("avoid")),
      avoidThreshold_(numberOf("avoid_threshold", -kLargest, kLargest, 4)),
      unit_(new QComboBox) {
    auto* const all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kPanelSpacing);
    addUsual(*all);
    addFolded(*all);
    show(DrawnOptions());
}

// ---- Parts ----

void OptionsForm::addUsual(QVBoxLayout& all) {
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
    tolerance_->setRange(0, kToleranceSteps);
    tolerance_->setFocusPolicy(Qt::NoFocus);
    tolerance_->setToolTip(helpOf(parameter("pick_tolerance")));
    toleranceText_->setMinimumWidth(fontMetrics().horizontalAdvance("0.00 edges "));
    connect(tolerance_, &QSlider::valueChanged, this, &OptionsForm::changeTolerance);
    connect(tolerance_, &QSlider::sliderReleased, this, &OptionsForm::change);
    connect(isClosed_, &QCheckBox::toggled, this, &OptionsForm::change);
    connect(degree_, qOverload<int>(&QSpinBox::valueChanged), this, &OptionsForm::change);
    connect(tension_, &QSlider::valueChanged, this, &OptionsForm::changeTension);
    connect(tension_, &QSlider::sliderReleased, this, &OptionsForm::change);
    isClosed_->setFocusPolicy(Qt::NoFocus);
    auto* const first = rowOf({isClosed_, new QLabel(tr("degree")), degree_});
    first->setStretch(0, 1);
    all.addLayout(first);
    auto* const form = new QFormLayout;
    form->setSpacing(kPanelSpacing);
    form->addRow(tr("tension"), rowOf({tension_, tensionText_}));
    form->addRow(tr("field"), field_);
    all.addLayout(form);
}

void OptionsForm::addFolded(QVBoxLayout& all) {
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
    form->setSpacing(kPanelSpacing);
    form->addRow(tr("tolerance"), rowOf({tolerance_, toleranceText_}));
    form->addRow(tr("weight"), fieldWeight_);
    form->addRow(tr("avoid"), avoid_);
    form->addRow(tr("threshold"), avoidThreshold_);
    form->addRow(tr("unit"), unit_);
    auto* const more = buttonOf(
        tr("More options"), tr("Tolerance of picks, weight of the field, faces to avoid, unit")
    );
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
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &OptionsForm::change);
    }
    for (const QComboBox* const box : {field_, avoid_}) {
        connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &OptionsForm::change);
    }
    connect(unit_, &QComboBox::editTextChanged, this, [this](const QString& unit) {
        kept::setUnit(unit.trimmed());
        emit unitChanged();
    });
}

// ---- Values ----

void OptionsForm::change() {
    if (!isShowing_) {
        enable();
        emit changed(options(), false);
    }
}

void OptionsForm::changeTension(int steps) {
    if (!isShowing_) {
        tensionValue_ = static_cast<double>(steps) / kTensionSteps;
        tensionText_->setText(QString::number(tensionValue_, 'f', 2));
        emit changed(options(), tension_->isSliderDown());
    }
}

void OptionsForm::changeTolerance(int steps) {
    if (!isShowing_) {
        toleranceValue_ = describe(
            MeshLength{.value = kMostTolerance * steps / kToleranceSteps, .isInEdges = steps > 0}
        );
        showTolerance();
        emit changed(options(), tolerance_->isSliderDown());
    }
}

// What is no number of edges stands in the text alone.
void OptionsForm::showTolerance() {
    const MeshLength length = parseLength(toleranceValue_, "pick_tolerance");
    toleranceText_->setText(
        QString::number(length.value, 'g', 3) + (length.isInEdges ? tr(" edges") : "")
    );
    if (!tolerance_->isSliderDown()) {
        const double steps =
            length.isInEdges ? length.value / kMostTolerance * kToleranceSteps : 0.0;
        const bool wasShowing = std::exchange(isShowing_, true);
        tolerance_->setValue(static_cast<int>(std::lround(steps)));
        isShowing_ = wasShowing;
    }
}

void OptionsForm::show(const DrawnOptions& options) {
    const bool wasShowing = std::exchange(isShowing_, true);
    isClosed_->setChecked(options.closed);
    degree_->setValue(options.degree);
    if (!tension_->isSliderDown()) {
        tension_->setValue(static_cast<int>(std::lround(options.tension * kTensionSteps)));
    }
    tensionValue_ = options.tension;
    tensionText_->setText(QString::number(tensionValue_, 'f', 2));
    toleranceValue_ = options.pickTolerance;
    showTolerance();
    choose(*field_, options.field);
    fieldWeight_->setValue(options.fieldWeight);
    choose(*avoid_, options.avoid);
    avoidThreshold_->setValue(options.avoidThreshold);
    enable();
    isShowing_ = wasShowing;
}

void OptionsForm::enable() {
    fieldWeight_->setEnabled(chosen(*field_) != DrawnOptions().field);
    const auto& rule = parameter("avoid_threshold").enabledWhen;
    avoidThreshold_->setEnabled(!rule || std::ranges::count(rule->values, chosen(*avoid_)) > 0);
}

void OptionsForm::showOpen() {
    const bool wasShowing = std::exchange(isShowing_, true);
    isClosed_->setChecked(false);
    isShowing_ = wasShowing;
}

void OptionsForm::setClosable(bool isClosable) {
    isClosed_->setEnabled(isClosable);
}

DrawnOptions OptionsForm::options() const {
    return {
        .closed = isClosed_->isChecked(),
        .degree = degree_->value(),
        .tension = tensionValue_,
        .pickTolerance = toleranceValue_,
        .field = chosen(*field_),
        .fieldWeight = fieldWeight_->value(),
        .avoid = chosen(*avoid_),
        .avoidThreshold = avoidThreshold_->value()
    };
}

}  // namespace bspline_curve
