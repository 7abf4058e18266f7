// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/document_drawing.h"

#include <common/ml_shared_data_context.h>

#include <QAction>
#include <QGLWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve::test_support {

class HostWindow;

/// The view of a host. It gives its events to the tool unless the tool is suspended, as MeshLab
/// does, and draws with the context that is current.
class HostView : public QGLWidget {
    Q_OBJECT

public:
    explicit HostView(HostWindow& host) : host_(host) {}

    /// Where a point of the world is seen, in the widget.
    [[nodiscard]] QPoint placeOf(const Vec3& point) const;

    [[nodiscard]] bool isSuspended() const { return isSuspended_; }

    Vec3 from = Vec3::UnitZ();  ///< the direction that the scene is seen from

public slots:

    // Those of MeshLab's view, which the tool calls by their names.
    void suspendEditToggle() { isSuspended_ = !isSuspended_; }

    void endEdit();

    void updateLayerTable() {}

protected:
    void paintEvent(QPaintEvent* event) override;

    void resizeEvent(QResizeEvent* /*event*/) override {}

    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    HostWindow& host_;
    bool isSuspended_ = false;
    std::optional<View> seen_;
};

/// The picks of the curves of a sketch.
using PicksOfCurves = std::vector<std::vector<Vec3>>;

/// What was drawn when the tool ended.
struct EndState {
    PicksOfCurves curves;
    PicksOfCurves changing;   ///< not solved: of those along a line, better picks may come
    int settled = 0;          ///< how many are solved
    bool isDragging = false;  ///< the active curve may go back to what it was
    bool isSurfaceThere = true;
};

/// The window of a host with a mesh and the drawing tool, without a display: MeshLab's document
/// with a window that does with the tool what MeshLab does, and has shortcuts for every key of the
/// tool.
class HostWindow : public QMainWindow {
    Q_OBJECT

public:
    HostWindow(const TriangleMesh& mesh, const Vec3& from);
    ~HostWindow() override;
    HostWindow(const HostWindow&) = delete;
    HostWindow& operator=(const HostWindow&) = delete;

    void startTool();  ///< where there is none
    void endTool();    ///< as its icon does

    [[nodiscard]] CurveTool* tool() { return drawing_ ? &drawing_->tool() : nullptr; }

    /// Null where there is none, or it is not prepared yet.
    [[nodiscard]] const DrawingSession* session();

    [[nodiscard]] MeshDocument& document() { return document_; }

    [[nodiscard]] HostView& view() { return *view_; }

    [[nodiscard]] QLineEdit& field() { return *field_; }

    [[nodiscard]] QAction& escape() { return *escape_; }

    [[nodiscard]] int surface() const { return surface_; }

    /// The host's own shortcuts that were reached while there was a tool.
    [[nodiscard]] int firedShortcuts() const { return fired_; }

    /// The user makes another layer the current one.
    void makeCurrent(int layer);
    /// The user removes a layer.
    void remove(int layer);

    /// What the tool held when it ended last.
    [[nodiscard]] const std::optional<EndState>& lastEnd() const { return lastEnd_; }

    /// All that the surface's layer consists of.
    [[nodiscard]] std::vector<std::uint8_t> bytesOfSurface() const;

private:
    void addShortcuts();
    void keepEnd();

    // In the order in which they are needed: the tool ends before all of them.
    vcg::QtThreadSafeMemoryInfo memory_{1 << 20};
    MeshDocument document_;
    MLSceneGLSharedDataContext shared_;
    HostView* view_;
    QLineEdit* field_;
    QAction* escape_;
    int surface_ = -1;
    int fired_ = 0;
    std::optional<EndState> lastEnd_;
    std::unique_ptr<DocumentDrawing> drawing_;
};

}  // namespace bspline_curve::test_support
