// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"

#include <QTreeWidget>
#include <vector>

namespace bspline_curve {

/// The curves of a sketch, a row each: whether it is shown, its colour, its name.
class CurveList : public QTreeWidget {
    Q_OBJECT

public:
    CurveList();

    void show(const Sketch& sketch);

    [[nodiscard]] QSize sizeHint() const override;

    [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }

signals:
    void chosen(int curve);
    void lookChanged(int curve, const bspline_curve::SketchLook& look);

private:
    void clicked(QTreeWidgetItem* item, int column);
    void changed(QTreeWidgetItem* item, int column);

    std::vector<SketchLook> shown_;
    bool isShowing_ = false;
};

/// What people call a curve: its name, or its number from 1 on.
[[nodiscard]] QString nameOf(const Sketch& sketch, int curve);

}  // namespace bspline_curve
