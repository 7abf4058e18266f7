// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sketch/drawing_session.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace bspline_curve {

/// The small window beside the view: options of the active curve, buttons, and what is to be said.
class ToolPanel : public QWidget {
    Q_OBJECT

public:
    explicit ToolPanel(QWidget* view);

    /// Shows the state of a session; null: it is not there yet.
    void show(const DrawingSession* session);
    void say(const QString& text);

signals:
    void optionsChanged(bool closed, int degree, double tension);
    void keyAsked(bspline_curve::SketchKey key);
    void commitAsked();
    void keyPressed(QKeyEvent* event);  ///< that no part of the panel wanted

protected:
    void keyPressEvent(QKeyEvent* event) override { emit keyPressed(event); }

private:
    void addButton(const QString& text, const QString& help, SketchKey key);
    void changed();

    QCheckBox* closed_;
    QSpinBox* degree_;
    QDoubleSpinBox* tension_;
    QWidget* buttons_;
    QPushButton* commit_;
    QLabel* text_;
    bool isShowing_ = false;
};

}  // namespace bspline_curve
