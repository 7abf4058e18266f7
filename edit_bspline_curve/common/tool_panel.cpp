// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/tool_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace bspline_curve {
namespace {

constexpr int kMargin = 8;
constexpr int kFrame = 24;  // height of a window's title
constexpr int kTextWidth = 240;
constexpr int kTextLines = 6;

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
        return QObject::tr("%1 picks").arg(picks);
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

}  // namespace

ToolPanel::ToolPanel(QWidget* view)
    : QWidget(view->window(), Qt::Tool),
      closed_(new QCheckBox(tr("closed"))),
      degree_(new QSpinBox),
      tension_(new QDoubleSpinBox),
      buttons_(new QWidget),
      commit_(new QPushButton(tr("Make layers (Enter)"))),
      text_(new QLabel) {
    setWindowTitle(tr("B-spline Curves"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    degree_->setRange(2, 4);
    degree_->setValue(3);
    tension_->setRange(0.0, 1.0);
    tension_->setSingleStep(0.1);
    tension_->setToolTip(tr("0: as smooth as possible, 1: as straight as possible"));
    auto* const form = new QFormLayout;
    form->addRow(closed_);
    form->addRow(tr("degree"), degree_);
    form->addRow(tr("tension"), tension_);
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
    all->addLayout(form);
    all->addWidget(buttons_);
    all->addWidget(commit_);
    all->addWidget(text_);
    for (QWidget* const widget : findChildren<QPushButton*>()) {
        widget->setFocusPolicy(Qt::NoFocus);
    }
    connect(closed_, &QCheckBox::toggled, this, &ToolPanel::changed);
    connect(degree_, qOverload<int>(&QSpinBox::valueChanged), this, &ToolPanel::changed);
    connect(tension_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ToolPanel::changed);
    connect(commit_, &QPushButton::clicked, this, &ToolPanel::commitAsked);
    move(view->mapToGlobal(QPoint(kMargin, kFrame)));
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
        emit optionsChanged(closed_->isChecked(), degree_->value(), tension_->value());
    }
}

void ToolPanel::show(const DrawingSession* session) {
    isShowing_ = true;
    const SketchCurve* const curve = session == nullptr ? nullptr : session->sketch().activeCurve();
    closed_->setEnabled(curve != nullptr && curve->picks.size() >= 3);
    if (curve != nullptr) {
        closed_->setChecked(curve->options.solver.closed);
        degree_->setValue(curve->options.solver.degree);
        tension_->setValue(curve->options.solver.tension);
    } else {
        closed_->setChecked(false);
    }
    commit_->setEnabled(session != nullptr && !session->sketch().curves.empty());
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
