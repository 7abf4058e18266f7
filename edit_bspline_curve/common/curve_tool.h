// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/tool_panel.h"
#include "edit_bspline_curve/common/view.h"
#include "filters/layer_input.h"
#include "sketch/drawing_session.h"

#include <QObject>
#include <QTimer>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace bspline_curve {

/// A curve that was drawn before.
struct DrawnCurve {
    std::vector<SketchPick> picks;
    SketchCurveOptions options;
};

/// The drawing tool in a view of MeshLab, whatever its version: takes Qt's events, draws with
/// OpenGL. The surface is prepared on a thread of its own; until then only the camera moves.
class CurveTool : public QObject {
    Q_OBJECT

public:
    using Curves = std::vector<std::shared_ptr<const SketchCurve>>;

    /// `commit` makes layers of curves; what it throws is shown, and the curves stay. `reopened`: a
    /// curve to go on with. The view must outlive this.
    CurveTool(
        QGLWidget& view,
        TriangleMesh surface,
        std::optional<DrawnCurve> reopened,
        std::function<void(const Curves&)> commit
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
    void look();     ///< whether the surface is ready
    void refresh();  ///< after any change
    void setOptions(bool closed, int degree, double tension);
    void runKey(SketchKey key);
    void commit();
    [[nodiscard]] static Pointer pointerOf(const QMouseEvent& event, const View& seen);
    void lendToCamera(QMouseEvent& event);
    void toggleCamera();

    QGLWidget& view_;
    std::function<void(const Curves&)> makeLayers_;
    std::optional<DrawnCurve> reopened_;  ///< until the session is there
    bool hadTracking_;
    ToolPanel panel_;
    QTimer timer_;
    std::future<std::shared_ptr<const CurveDesigner>> preparing_;
    std::unique_ptr<DrawingSession> session_;
    std::optional<View> seen_;  ///< of the last drawing
    QPointF last_;              ///< where the mouse was
    bool isLent_ = false;       ///< the mouse moves the camera until its button is released
};

}  // namespace bspline_curve
