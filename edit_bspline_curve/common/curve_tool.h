// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/drawn_curve.h"
#include "edit_bspline_curve/common/option_book.h"
#include "edit_bspline_curve/common/tool_panel.h"
#include "edit_bspline_curve/common/view.h"
#include "filters/layer_input.h"
#include "sketch/drawing_session.h"

#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace bspline_curve {

/// What the tool asks of MeshLab's document. What these throw is shown, and curves stay.
struct ToolHost {
    std::function<void(const std::vector<DrawnCurve>&)> makeLayers;
    /// Runs a filter with the curves that became layers.
    std::function<void(const FilterDescription&)> useCurves;
};

/// The drawing tool in a view of MeshLab, whatever its version: takes Qt's events, draws with
/// OpenGL. The surface is prepared on a thread of its own; until then only the camera moves.
class CurveTool : public QObject {
    Q_OBJECT

public:
    /// `reopened`: a curve to go on with. The view must outlive this.
    CurveTool(
        QGLWidget& view, LayerInput surface, std::optional<DrawnCurve> reopened, ToolHost host
    );
    ~CurveTool() override;
    CurveTool(const CurveTool&) = delete;
    CurveTool& operator=(const CurveTool&) = delete;

    /// Within the host's drawing.
    void draw();

    void mousePress(QMouseEvent& event);
    void mouseMove(QMouseEvent& event);
    void mouseRelease(QMouseEvent& event);
    void wheel(QWheelEvent& event);
    void keyPress(QKeyEvent& event);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// What is prepared on a thread of its own.
    struct Prepared {
        std::shared_ptr<const CurveDesigner> designer;
        LayerInput layer;  ///< quality and selections on the designer's mesh
        bool isMended = false;
    };

    void look();  ///< whether what is prepared is ready
    void begin(Prepared prepared);
    void prepareCrests();
    void refresh();  ///< after any change
    void setOptions(const DrawnOptions& options);
    void runKey(SketchKey key);
    bool commit();
    void use(const FilterDescription& filter);
    void reopen(const DrawnCurve& curve);
    [[nodiscard]] Progress untilTheEnd() const;
    [[nodiscard]] Pointer pointerOf(const QMouseEvent& event, const View& seen);
    void lendToCamera(QMouseEvent& event);
    void toggleCamera();

    QGLWidget& view_;
    ToolHost host_;
    std::optional<DrawnCurve> reopened_;  ///< until the session is there
    bool hadTracking_;
    ToolPanel panel_;
    QTimer timer_;
    std::atomic<bool> isEnding_ = false;
    std::future<Prepared> preparing_;
    std::future<SnapOptions> preparingCrests_;
    std::shared_ptr<const CurveDesigner> designer_;
    std::unique_ptr<OptionBook> options_;
    std::unique_ptr<DrawingSession> session_;
    bool hasCrests_ = false;    ///< or they are being prepared
    bool hasLayers_ = false;    ///< curves became layers
    std::optional<View> seen_;  ///< of the last drawing
    QPointF last_;              ///< where the mouse was
    bool isLent_ = false;       ///< the mouse moves the camera until its button is released
};

}  // namespace bspline_curve
