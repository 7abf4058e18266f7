// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/drawn_options.h"
#include "sketch/drawing_session.h"

#include <QWidget>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLayout;
class QPushButton;
class QSpinBox;

namespace bspline_curve {

/// The small window beside the view: options of the active curve, buttons, and what is to be said.
class ToolPanel : public QWidget {
    Q_OBJECT

public:
    explicit ToolPanel(QWidget* view);

    /// Shows the state of a session; null: it is not there yet. `active`: the options of the active
    /// curve, if there is one. `hasLayers`: curves became layers, which filters can use.
    void show(
        const DrawingSession* session, const std::optional<DrawnOptions>& active, bool hasLayers
    );
    void say(const QString& text);

signals:
    void optionsChanged(const bspline_curve::DrawnOptions& options);
    void keyAsked(bspline_curve::SketchKey key);
    void commitAsked();
    void useAsked(const bspline_curve::FilterDescription* filter);
    void keyPressed(QKeyEvent* event);  ///< that no part of the panel wanted

protected:
    void keyPressEvent(QKeyEvent* event) override { emit keyPressed(event); }

private:
    [[nodiscard]] QLayout* makeForm();
    [[nodiscard]] QWidget* makeUses();
    void addButton(const QString& text, const QString& help, SketchKey key);
    void changed();
    void setOptions(const DrawnOptions& options);
    void enableOptions();
    [[nodiscard]] DrawnOptions options() const;

    QCheckBox* closed_;
    QSpinBox* degree_;
    QDoubleSpinBox* tension_;
    QComboBox* field_;
    QDoubleSpinBox* fieldWeight_;
    QComboBox* avoid_;
    QDoubleSpinBox* avoidThreshold_;
    QWidget* buttons_;
    QPushButton* commit_;
    QWidget* uses_;
    QLabel* text_;
    bool isShowing_ = false;
};

}  // namespace bspline_curve
