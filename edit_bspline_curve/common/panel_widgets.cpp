// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/panel_widgets.h"

namespace bspline_curve {

QToolButton* buttonOf(const QString& text, const QString& help) {
    auto* const button = new QToolButton;
    button->setText(text);
    button->setToolTip(help);
    button->setFocusPolicy(Qt::NoFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
    auto* const row = new QHBoxLayout;
    row->setSpacing(kPanelSpacing);
    for (QWidget* const widget : widgets) {
        row->addWidget(widget);
    }
    return row;
}

}  // namespace bspline_curve
