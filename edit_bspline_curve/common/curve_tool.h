// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "bspline_curve/workpiece.h"
#include "edit_bspline_curve/common/curve_uses.h"
#include "edit_bspline_curve/common/sketch_layers.h"
#include "edit_bspline_curve/common/tool_keys.h"
#include "edit_bspline_curve/common/tool_panel.h"
#include "edit_bspline_curve/common/view.h"
#include "filters/drawn_curve_file.h"
#include "filters/option_book.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace bspline_curve {

/// What the tool begins with.
struct ToolStart {
    LayerArrays surface;
    std::vector<TakenUp> curves;
    int active = -1;  ///< index of one of them; -1: none
    QString note;     ///< to be said at first
};

/// The drawing tool in a view of MeshLab, whatever its version: takes Qt's events, draws with
/// OpenGL. The surface is prepared on a thread of its own; until then only the camera moves.
///
/// While it is there, its keys are its own wherever the focus is in MeshLab's window, so that they
/// reach none of the host's shortcuts (see tool_keys.h), and MeshLab does not close before what is
/// drawn is a layer or its user was asked.
class CurveTool : public QObject {
    Q_OBJECT

public:
    /// View, layers and uses must outlive this.
    CurveTool(QGLWidget& view, ToolStart start, SketchLayers& layers, CurveUses& uses);
    ~CurveTool() override;
    CurveTool(const CurveTool&) = delete;
    CurveTool& operator=(const CurveTool&) = delete;

    /// Makes layers of what is drawn, and keeps the rest with the surface.
    void finish();

    /// Within the host's drawing.
    void draw();

    void mousePress(QMouseEvent& event);
    void mouseMove(QMouseEvent& event);
    void mouseRelease(QMouseEvent& event);
    void wheel(QWheelEvent& event);

    bool eventFilter(QObject* watched, QEvent* event) override;

    /// What is drawn; null until the surface is prepared.
    [[nodiscard]] const DrawingSession* session() const { return session_.get(); }

private:
    /// What is prepared on a thread of its own.
    struct Prepared {
        std::shared_ptr<const Workpiece> workpiece;
        LayerInput layer;      ///< with quality and selections
        MeshChecksum ofLayer;  ///< in the layer's own coordinates
    };

    [[nodiscard]] Progress untilTheEnd() const;
    void connectPanel();
    static Prepared prepare(LayerArrays surface, const Progress& progress);
    void look();  ///< whether what is computed beside is ready
    void takePrepared();
    void takeUse();
    void begin(Prepared prepared);
    [[nodiscard]] SketchCurve toSketch(const DrawnCurve& drawn, bool isOnMesh);
    [[nodiscard]] DrawnCurve toDrawn(const SketchCurve& curve) const;
    void prepareCrests();
    void stop();     ///< all threads
    void refresh();  ///< after any change
    void setOptions(const DrawnOptions& options, bool isLive);
    void setLook(int curve, const SketchLook& look);
    void choose(int curve);
    [[nodiscard]] bool has(int curve);
    [[nodiscard]] CurveMaker maker();

    // Layers, when all curves are settled.
    void makeLayers();
    void use(const FilterDescription& filter);
    void cancelUse();
    void makeWhatWaits();
    bool bringLayers();
    [[nodiscard]] QString madeText(int made) const;

    // Files.
    bool save();
    void open();
    [[nodiscard]] CurveFileSurface fileSurface() const;

    // Keys and the host's window.
    [[nodiscard]] bool isInFront() const;
    bool takeKey(QObject& watched, QKeyEvent& event);
    void run(const ToolKey& key);
    void runKey(SketchKey key);
    bool mayClose();
    [[nodiscard]] bool isSaved(const std::shared_ptr<SketchCurve>& curve) const;

    // The camera.
    [[nodiscard]] Pointer pointerOf(const QMouseEvent& event, const View& seen);
    void lendToCamera(QMouseEvent& event);
    bool returnFromCamera(QMouseEvent& event);
    void toggleCamera();
    void setTurning(bool turns);
    [[nodiscard]] bool isHostsCamera() const;

    static constexpr int kLookEvery = 15;  // milliseconds

    QGLWidget& view_;
    SketchLayers& layers_;
    CurveUses& uses_;
    ToolStart start_;  ///< until the session is there
    bool hadTracking_;
    QPointer<ToolPanel> panel_;     ///< the host's window may delete it
    QPointer<QAction> suspending_;  ///< the host's own, which gives the mouse to the camera
    QTimer timer_;
    std::atomic<bool> isEnding_ = false;
    std::future<Prepared> preparing_;
    std::future<SnapOptions> preparingCrests_;
    std::shared_ptr<const Workpiece> workpiece_;
    bool hasResults_ = false;
    std::unique_ptr<OptionBook> options_;
    std::unique_ptr<DrawingSession> session_;
    bool hasCrests_ = false;                                 ///< or they are being prepared
    std::vector<std::shared_ptr<const SketchCurve>> saved_;  ///< to files, by their user
    QString notice_;                                         ///< to be said until the next event
    bool isMaking_ = false;                    ///< layers wait for curves that are being solved
    const FilterDescription* used_ = nullptr;  ///< and then this runs
    std::optional<View> seen_;                 ///< of the last drawing
    QPointF last_;                             ///< where the mouse was
    bool isTurning_ = false;                   ///< all of the mouse is the camera's
    bool isLent_ = false;  ///< the mouse moves the camera until its button is released
};

}  // namespace bspline_curve
