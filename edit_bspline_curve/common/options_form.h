// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/drawn_options.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QSpinBox;
class QVBoxLayout;

namespace bspline_curve {

/// The options of a curve in the tool's panel; those that few need are folded away, with the unit
/// of the mesh.
class OptionsForm : public QWidget {
    Q_OBJECT

public:
    OptionsForm();

    void show(const DrawnOptions& options);
    void showOpen();  ///< no curve that could be closed
    void setClosable(bool isClosable);

signals:
    /// `isLive`: more of this change is to come.
    void changed(const bspline_curve::DrawnOptions& options, bool isLive);
    void unitChanged();

private:
    void addUsual(QVBoxLayout& all);
    void addFolded(QVBoxLayout& all);
    void change();
    void changeTension(int steps);
    void changeTolerance(int steps);
    void showTolerance();
    void enable();
    [[nodiscard]] DrawnOptions options() const;

    QCheckBox* isClosed_;
    QSpinBox* degree_;
    QSlider* tension_;
    QLabel* tensionText_;
    QSlider* tolerance_;
    QLabel* toleranceText_;
    QComboBox* field_;
    QDoubleSpinBox* fieldWeight_;
    QComboBox* avoid_;
    QDoubleSpinBox* avoidThreshold_;
    QComboBox* unit_;
    double tensionValue_ = 0.0;   ///< finer than the slider
    std::string toleranceValue_;  ///< may be a length in the mesh's unit
    bool isShowing_ = false;
};

}  // namespace bspline_curve
