// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "edit_bspline_curve/common/curve_list.h"
#include "edit_bspline_curve/common/filter_beside.h"
#include "edit_bspline_curve/common/options_form.h"
#include "filters/drawn_options.h"

#include <QDockWidget>
#include <optional>

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace bspline_curve {

/// What the panel shows.
struct PanelState {
    const DrawingSession* session = nullptr;  ///< null: it is not there yet
    std::optional<DrawnOptions> active = {};  ///< options of the active curve
    bool isTurning = false;                   ///< the mouse turns the view
    bool isHostsCamera = false;               ///< MeshLab has suspended the tool
    bool isMaking = false;                    ///< layers will be made when curves are ready
    QString notice = {};                      ///< what is to be said before anything else
    double edge = 0.0;                        ///< mean edge length, in the mesh's unit
};

/// The panel beside the view: options of the active curve, buttons, the list of curves, and what is
/// to be said. It is docked, or where it was left. The host's window owns it and may delete it.
class ToolPanel : public QDockWidget {
    Q_OBJECT

public:
    explicit ToolPanel(QWidget& view);
    ~ToolPanel() override;
    ToolPanel(const ToolPanel&) = delete;
    ToolPanel& operator=(const ToolPanel&) = delete;

    void show(const PanelState& state);
    /// A filter that runs, null for none: how far it is, and a button to give it up.
    void showUse(const FilterBeside* running);
    void say(const QString& text);

    [[nodiscard]] bool isMagnetOn() const;

signals:
    /// `isLive`: more of this change is to come.
    void optionsChanged(const bspline_curve::DrawnOptions& options, bool isLive);
    void keyAsked(bspline_curve::SketchKey key);
    void commitAsked();
    void useAsked(const bspline_curve::FilterDescription* filter);
    void cancelAsked();  ///< of the filter that runs
    void turnAsked(bool turns);
    void magnetChanged();
    void unitChanged();
    void curveChosen(int curve);
    void lookAsked(int curve, const bspline_curve::SketchLook& look);
    void saveAsked();
    void openAsked();
    void closed();  ///< by its user

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void place(QWidget& view);
    void keepPlace() const;
    void addModes(QVBoxLayout& all);
    void addUses(QVBoxLayout& all);
    void addFiles(QVBoxLayout& all);
    [[nodiscard]] QString textOf(const PanelState& state) const;

    QToolButton* turn_;
    QToolButton* magnet_;
    CurveList* list_;
    OptionsForm* options_;
    QToolButton* commit_;
    QWidget* uses_;
    QWidget* running_;
    QProgressBar* done_;
    QToolButton* save_ = nullptr;
    QToolButton* open_ = nullptr;
    QLabel* text_;
    bool isShowing_ = false;
};

}  // namespace bspline_curve
