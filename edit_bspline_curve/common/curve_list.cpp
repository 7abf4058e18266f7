// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_list.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QPixmap>
#include <QPointer>
#include <utility>

namespace bspline_curve {
namespace {

constexpr int kEye = 0, kColour = 1, kName = 2, kColumns = 3;

constexpr int kSwatch = 14, kRows = 4, kNarrow = 28;

QColor toColor(const SketchColour& colour) {
    return {colour.red, colour.green, colour.blue};
}

QIcon swatch(const SketchColour& colour) {
    QPixmap pixmap(kSwatch, kSwatch);
    pixmap.fill(toColor(colour));
    return {pixmap};
}

}  // namespace

QString nameOf(const Sketch& sketch, int curve) {
    const std::string& name = sketch.curves[curve]->look.name;
    return name.empty() ? QObject::tr("curve %1").arg(curve + 1) : QString::fromStdString(name);
}

CurveList::CurveList() {
    setColumnCount(kColumns);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setHeaderLabels({tr("see"), "", tr("curve")});
    header()->setStretchLastSection(true);
    header()->setMinimumSectionSize(kNarrow);
    setColumnWidth(kEye, kNarrow + kSwatch / 2);
    setColumnWidth(kColour, kNarrow);
    setEditTriggers(QAbstractItemView::DoubleClicked);
    setToolTip(
        tr("Click a row to go on with its curve, the box to hide it, the colour to choose another; "
           "double-click the name to change it.")
    );
    connect(this, &QTreeWidget::itemClicked, this, &CurveList::clicked);
    connect(this, &QTreeWidget::itemChanged, this, &CurveList::changed);
}

QSize CurveList::sizeHint() const {
    return {QTreeWidget::sizeHint().width(), (kRows + 1) * (fontMetrics().height() + 6)};
}

void CurveList::show(const Sketch& sketch) {
    std::vector<SketchLook> looks;
    for (int c = 0; c < static_cast<int>(sketch.curves.size()); ++c) {
        SketchLook look = sketch.curves[c]->look;
        look.name = nameOf(sketch, c).toStdString();
        looks.push_back(std::move(look));
    }
    isShowing_ = true;
    if (looks != shown_) {
        clear();
        for (const SketchLook& look : looks) {
            auto* const item = new QTreeWidgetItem(this);
            item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
            item->setCheckState(kEye, look.isHidden ? Qt::Unchecked : Qt::Checked);
            item->setIcon(kColour, swatch(look.colour));
            item->setText(kName, QString::fromStdString(look.name));
        }
        shown_ = std::move(looks);
    }
    setCurrentItem(sketch.active < 0 ? nullptr : topLevelItem(sketch.active));
    isShowing_ = false;
}

void CurveList::clicked(QTreeWidgetItem* item, int column) {
    const int row = indexOfTopLevelItem(item);
    if (column == kColour) {
        SketchLook look = shown_[row];
        const QPointer<CurveList> self(this);
        const QColor chosen =
            QColorDialog::getColor(toColor(look.colour), window(), tr("Colour of the curve"));
        if (!self.isNull() && chosen.isValid()) {
            look.colour = {
                static_cast<std::uint8_t>(chosen.red()),
                static_cast<std::uint8_t>(chosen.green()),
                static_cast<std::uint8_t>(chosen.blue())
            };
            emit lookChanged(row, look);
        }
    } else if (column == kName && !shown_[row].isHidden) {
        emit this->chosen(row);
    }
}

void CurveList::changed(QTreeWidgetItem* item, int column) {
    const int row = indexOfTopLevelItem(item);
    if (isShowing_ || row < 0) {
        return;
    }
    SketchLook look = shown_[row];
    if (column == kEye) {
        look.isHidden = item->checkState(kEye) == Qt::Unchecked;
    } else if (column == kName) {
        look.name = item->text(kName).trimmed().toStdString();
    }
    if (look != shown_[row]) {
        emit lookChanged(row, look);
    }
}

}  // namespace bspline_curve
