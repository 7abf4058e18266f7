// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

constexpr int kMargin = 8;
constexpr int kFrame = 24;  // height of a window's title
constexpr int kTextWidth = 240;
constexpr int kTextLines = 6;
constexpr int kMostDegree = 4;
constexpr double kLargest = 1e9;
constexpr double kTensionStep = 0.1, kWeightStep = 500.0, kThresholdStep = 0.05;

// What people want to know of a curve.
QString describe(const SketchCurve& curve) {
    const int picks = static_cast<int>(curve.picks.size());
    if (!curve.problem.message.empty()) {
        return QString::fromStdString(curve.problem.message);
    }
    if (!curve.isDrawable()) {
        return QObject::tr("%1 pick: click the next one").arg(picks);
    }
    if (curve.settled == nullptr) {
        return QObject::tr("%1 picks …").arg(picks);
    }
    const SurfacePolyline& line = curve.settled->polyline;
    double length = line.closed ? (line.points.front() - line.points.back()).norm() : 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        length += (line.points[i] - line.points[i - 1]).norm();
    }
    const SolveReport& report = curve.settled->report;
    const auto& s = report.seconds;
    const double seconds =
        s.path + s.initial + s.minimise + s.knots + s.polyline + s.failedAttempts;
    return QObject::tr("%1 picks, length %2\n%3 edges from the surface (allowed: %4)\n%5 ms")
        .arg(picks)
        .arg(length, 0, 'g', 4)
        .arg(report.maxDistance, 0, 'f', 3)
        .arg(report.allowedDistance, 0, 'f', 3)
        .arg(1e3 * seconds, 0, 'f', 1);
}

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

ToolPanel::ToolPanel(QWidget* view)
    : QWidget(view->window(), Qt::Tool),
      closed_(new QCheckBox(tr("closed"))),
      degree_(new QSpinBox),
      tension_(numberOf("tension", 0.0, 1.0, 2)),
      field_(choiceOf("field")),
      fieldWeight_(numberOf("field_weight", 0.0, kLargest, 1)),
      avoid_(choiceOf("avoid")),
      avoidThreshold_(numberOf("avoid_threshold", -kLargest, kLargest, 4)),
      buttons_(new QWidget),
      commit_(new QPushButton(tr("Make layers (Enter)"))),
      uses_(makeUses()),
      text_(new QLabel) {
    setWindowTitle(tr("B-spline Curves"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    auto* const grid = new QGridLayout(buttons_);
    grid->setContentsMargins(0, 0, 0, 0);
    addButton(tr("Undo"), tr("Ctrl+Z"), SketchKey::Undo);
    addButton(tr("Redo"), tr("Ctrl+Y"), SketchKey::Redo);
    addButton(tr("New curve"), tr("N"), SketchKey::NewCurve);
    addButton(tr("Remove"), tr("Delete: the selected pick, or the curve"), SketchKey::Remove);
    text_->setWordWrap(true);
    text_->setFixedSize(kTextWidth, kTextLines * fontMetrics().lineSpacing());
    text_->setAlignment(Qt::AlignTop);
    auto* const all = new QVBoxLayout(this);
    all->addLayout(makeForm());
    all->addWidget(buttons_);
    all->addWidget(commit_);
    all->addWidget(uses_);
    all->addWidget(text_);
    for (QWidget* const widget : findChildren<QPushButton*>()) {
        widget->setFocusPolicy(Qt::NoFocus);
    }
    connect(commit_, &QPushButton::clicked, this, &ToolPanel::commitAsked);
    setOptions(DrawnOptions());
    move(view->mapToGlobal(QPoint(kMargin, kFrame)));
}

QLayout* ToolPanel::makeForm() {
    degree_->setRange(
        static_cast<int>(parameter("degree").min.value_or(1)),
        static_cast<int>(parameter("degree").max.value_or(kMostDegree))
    );
    tension_->setSingleStep(kTensionStep);
    fieldWeight_->setSingleStep(kWeightStep);
    avoidThreshold_->setSingleStep(kThresholdStep);
    auto* const form = new QFormLayout;
    form->addRow(closed_);
    form->addRow(tr("degree"), degree_);
    form->addRow(tr("tension"), tension_);
    form->addRow(tr("field"), field_);
    form->addRow(tr("weight"), fieldWeight_);
    form->addRow(tr("avoid"), avoid_);
    form->addRow(tr("threshold"), avoidThreshold_);
    connect(closed_, &QCheckBox::toggled, this, &ToolPanel::changed);
    connect(degree_, qOverload<int>(&QSpinBox::valueChanged), this, &ToolPanel::changed);
    for (const QDoubleSpinBox* const box : {tension_, fieldWeight_, avoidThreshold_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ToolPanel::changed);
    }
    for (const QComboBox* const box : {field_, avoid_}) {
        connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &ToolPanel::changed);
    }
    return form;
}

QWidget* ToolPanel::makeUses() {
    auto* const row = new QWidget;
    auto* const layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const Use& use : uses()) {
        auto* const button = new QPushButton(use.text);
        button->setToolTip(tr("Makes layers, then: %1. %2")
                               .arg(
                                   QString::fromStdString(use.filter.name),
                                   QString::fromStdString(use.filter.shortDescription)
                               ));
        layout->addWidget(button);
        const FilterDescription* const filter = &use.filter;
        connect(button, &QPushButton::clicked, this, [this, filter] { emit useAsked(filter); });
    }
    return row;
}

void ToolPanel::addButton(const QString& text, const QString& help, SketchKey key) {
    auto* const grid = qobject_cast<QGridLayout*>(buttons_->layout());
    auto* const button = new QPushButton(text);
    button->setToolTip(help);
    const int count = grid->count();
    grid->addWidget(button, count / 2, count % 2);
    connect(button, &QPushButton::clicked, this, [this, key] { emit keyAsked(key); });
}

void ToolPanel::changed() {
    if (!isShowing_) {
        enableOptions();
        emit optionsChanged(options());
    }
}

void ToolPanel::setOptions(const DrawnOptions& options) {
    const bool wasShowing = std::exchange(isShowing_, true);
    closed_->setChecked(options.closed);
    degree_->setValue(options.degree);
    tension_->setValue(options.tension);
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
        .closed = closed_->isChecked(),
        .degree = degree_->value(),
        .tension = tension_->value(),
        .field = chosen(*field_),
        .fieldWeight = fieldWeight_->value(),
        .avoid = chosen(*avoid_),
        .avoidThreshold = avoidThreshold_->value()
    };
}

void ToolPanel::show(
    const DrawingSession* session, const std::optional<DrawnOptions>& active, bool hasLayers
) {
    const SketchCurve* const curve = session == nullptr ? nullptr : session->sketch().activeCurve();
    isShowing_ = true;
    closed_->setEnabled(curve != nullptr && curve->picks.size() >= 3);
    if (active) {
        setOptions(*active);
    } else {
        closed_->setChecked(false);
    }
    const bool hasCurves = session != nullptr && !session->sketch().curves.empty();
    commit_->setEnabled(hasCurves);
    uses_->setEnabled(hasCurves || hasLayers);
    if (curve != nullptr) {
        say(describe(*curve));
    } else if (session != nullptr) {
        say(tr(
            "Click points on the surface in the order of the curve. Drag picks; click the curve to "
            "insert one, the first pick to close it. Ctrl snaps, Shift removes, Alt moves the view."
        ));
    }
    isShowing_ = false;
}

void ToolPanel::say(const QString& text) {
    text_->setText(text);
}

}  // namespace bspline_curve
