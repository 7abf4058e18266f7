// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/window.h"

#include <QApplication>
#include <QMainWindow>
#include <algorithm>

namespace bspline_curve {

bool hasWindow() {
    // pymeshlab has no QApplication, and then no widgets either.
    if (qobject_cast<QApplication*>(QCoreApplication::instance()) == nullptr) {
        return false;
    }
    const QWidgetList widgets = QApplication::topLevelWidgets();
    return std::any_of(widgets.begin(), widgets.end(), [](const QWidget* widget) {
        return qobject_cast<const QMainWindow*>(widget) != nullptr;
    });
}

}  // namespace bspline_curve
