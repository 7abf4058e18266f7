// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_window.h"

#include "filter_bspline_curve/common/layer_making.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cstring>
#include <utility>

/// In the place of GLEW's own, which MeshLab's library calls and which wants a display.
extern "C" __attribute__((visibility("default"))) GLenum glewInit() {
    return GLEW_OK;
}

namespace bspline_curve::test_support {
namespace {

constexpr int kWindowWidth = 640, kWindowHeight = 480;

using Allocator = vcg::tri::Allocator<CMeshO>;

// Every attribute that a user could miss.
void fill(MeshModel& layer, const TriangleMesh& mesh) {
    CMeshO& to = layer.cm;
    layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    Allocator::AddVertices(to, mesh.vertices.size());
    Allocator::AddFaces(to, mesh.faces.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        to.vert[v].P() = toPoint3m(mesh.vertices[v]);
        to.vert[v].Q() = to.vert[v].P()[0];
        to.vert[v].C() = vcg::Color4b(static_cast<unsigned char>(v % 251), 90, 40, 255);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            to.face[f].V(k) = &to.vert[mesh.faces[f][k]];
        }
        if (f % 3 == 0) {
            to.face[f].SetS();
        }
    }
    vcg::tri::UpdateBounding<CMeshO>::Box(to);
    vcg::tri::UpdateNormal<CMeshO>::PerVertexNormalizedPerFaceNormalized(to);
}

// What the document's window holds. It is never closed: the host asks, and its user says no.
class DocumentWidget : public QWidget {
protected:
    void closeEvent(QCloseEvent* event) override { event->ignore(); }
};

template <class Value>
void append(std::vector<std::uint8_t>& bytes, const Value& value) {
    const std::size_t before = bytes.size();
    bytes.resize(before + sizeof(Value));
    std::memcpy(bytes.data() + before, &value, sizeof(Value));
}

}  // namespace

// ---- The view ----

QPoint HostView::placeOf(const Vec3& point) const {
    return seen_ ? seen_->positionOf(point).toPoint() : rect().center();
}

void HostView::endEdit() {
    host_.endTool();
}

void HostView::paintEvent(QPaintEvent* /*event*/) {
    glViewport(0, 0, width(), height());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    constexpr double kReach = 2.0;  // more than the meshes'
    const double wide = kReach * width() / height();
    glOrtho(-wide, wide, -kReach, kReach, -2.0 * kReach, 2.0 * kReach);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(from, Vec3::UnitZ());
    const Eigen::Matrix4d matrix = Eigen::Affine3d(turn).matrix();
    glMultMatrixd(matrix.data());
    seen_.emplace(*this);
    if (CurveTool* const tool = host_.tool()) {
        tool->draw();
    }
}

void HostView::mousePressEvent(QMouseEvent* event) {
    if (CurveTool* const tool = host_.tool(); tool != nullptr && !isSuspended_) {
        tool->mousePress(*event);
    }
}

void HostView::mouseMoveEvent(QMouseEvent* event) {
    if (CurveTool* const tool = host_.tool(); tool != nullptr && !isSuspended_) {
        tool->mouseMove(*event);
    }
}

void HostView::mouseReleaseEvent(QMouseEvent* event) {
    if (CurveTool* const tool = host_.tool(); tool != nullptr && !isSuspended_) {
        tool->mouseRelease(*event);
    }
}

void HostView::wheelEvent(QWheelEvent* event) {
    if (CurveTool* const tool = host_.tool(); tool != nullptr && !isSuspended_) {
        tool->wheel(*event);
    }
}

// ---- The window ----

HostWindow::HostWindow(const TriangleMesh& mesh, const Vec3& from)
    : shared_(document_, memory_, false, 1000),
      view_(new HostView(*this)),
      field_(new QLineEdit),
      escape_(new QAction("Not Editing", this)) {
    MeshModel* const layer = document_.addNewMesh("", "mesh", true);
    fill(*layer, mesh);
    surface_ = layer->id();
    view_->from = from;

    addShortcuts();
    auto* const area = new QMdiArea;
    auto* const inside = new DocumentWidget;
    auto* const all = new QVBoxLayout(inside);
    all->addWidget(view_, 1);
    all->addWidget(field_);
    area->addSubWindow(inside);
    setCentralWidget(area);
    resize(kWindowWidth, kWindowHeight);
    show();
    area->subWindowList().front()->showMaximized();
    QApplication::setActiveWindow(this);
    view_->setFocus();
}

HostWindow::~HostWindow() {
    drawing_.reset();
}

void HostWindow::addShortcuts() {
    escape_->setCheckable(true);
    escape_->setShortcut(Qt::Key_Escape);
    connect(escape_, &QAction::triggered, this, [this](bool isOn) {
        if (view_->isSuspended() != isOn) {
            view_->suspendEditToggle();
        }
    });
    addAction(escape_);
    for (const char* const keys :
         {"Del",
          "Shift+Del",
          "Ctrl+Del",
          "Ctrl+Shift+Del",
          "Backspace",
          "Shift+Backspace",
          "Ctrl+Z",
          "Ctrl+Shift+Z",
          "Ctrl+Y",
          "Return",
          "Enter",
          "A",
          "C",
          "K",
          "M",
          "N",
          "X",
          ".",
          ","}) {
        auto* const action = new QAction(keys, this);
        action->setShortcut(QKeySequence(keys));
        connect(action, &QAction::triggered, this, [this] { fired_ += drawing_ ? 1 : 0; });
        addAction(action);
    }
}

void HostWindow::startTool() {
    if (!drawing_) {
        lastEnd_.reset();
        drawing_ = std::make_unique<DocumentDrawing>(document_, shared_, *view_);
    }
}

const DrawingSession* HostWindow::session() {
    return drawing_ ? drawing_->tool().session() : nullptr;
}

void HostWindow::keepEnd() {
    EndState state;
    if (const DrawingSession* const now = session()) {
        const Sketch& sketch = now->sketch();
        state.isDragging = now->isDragging();
        for (std::size_t c = 0; c < sketch.curves.size(); ++c) {
            if (state.isDragging && static_cast<int>(c) == sketch.active) {
                continue;
            }
            const bool isChanging = !sketch.curves[c]->isSettled();
            (isChanging ? state.changing : state.curves).push_back(sketch.curves[c]->positions());
            state.settled += sketch.curves[c]->settled ? 1 : 0;
        }
    }
    state.isSurfaceThere = host::layerWithId(document_, surface_) != nullptr;
    lastEnd_ = std::move(state);
}

void HostWindow::endTool() {
    if (drawing_) {
        keepEnd();
        drawing_.reset();
        if (view_->isSuspended()) {
            view_->suspendEditToggle();
        }
        escape_->setChecked(false);
    }
}

void HostWindow::makeCurrent(int layer) {
    document_.setCurrentMesh(layer);
    if (drawing_ && !drawing_->hasSurface()) {  // as the tools for both versions do
        keepEnd();
        drawing_.reset();
    }
}

void HostWindow::remove(int layer) {
    host::removeLayer(document_, layer);
    makeCurrent(document_.size() == 0 ? -1 : document_.mm()->id());
}

std::vector<std::uint8_t> HostWindow::bytesOfSurface() const {
    std::vector<std::uint8_t> bytes;
    const MeshModel* const layer = host::layerWithId(document_, surface_);
    if (layer == nullptr) {
        return bytes;
    }
    const CMeshO& mesh = layer->cm;
    for (const CVertexO& vertex : mesh.vert) {
        append(bytes, vertex.cP());
        append(bytes, vertex.cN());
        append(bytes, vertex.cQ());
        append(bytes, vertex.cC());
        append(bytes, vertex.cFlags());
    }
    for (const CFaceO& face : mesh.face) {
        for (int k = 0; k < 3; ++k) {
            append(bytes, static_cast<std::int64_t>(face.cV(k) - mesh.vert.data()));
        }
        append(bytes, face.cN());
        append(bytes, face.cFlags());
    }
    append(bytes, mesh.Tr);
    return bytes;
}

}  // namespace bspline_curve::test_support
