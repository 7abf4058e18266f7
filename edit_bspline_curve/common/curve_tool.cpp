// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_tool.h"

#include "edit_bspline_curve/common/sketch_painter.h"
#include "surface/mending.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <array>
#include <chrono>
#include <exception>
#include <utility>

namespace bspline_curve {
namespace {

constexpr int kLookEvery = 15;  // milliseconds

struct KeyBinding {
    int key;
    bool withControl;
    SketchKey means;
};

constexpr std::array kBindings = {
    KeyBinding{Qt::Key_Z, true, SketchKey::Undo},
    KeyBinding{Qt::Key_Y, true, SketchKey::Redo},
    KeyBinding{Qt::Key_A, false, SketchKey::Add},
    KeyBinding{Qt::Key_M, false, SketchKey::Move},
    KeyBinding{Qt::Key_Period, false, SketchKey::Next},
    KeyBinding{Qt::Key_Comma, false, SketchKey::Previous},
    KeyBinding{Qt::Key_K, false, SketchKey::NextCurve},
    KeyBinding{Qt::Key_Delete, false, SketchKey::Remove},
    KeyBinding{Qt::Key_Backspace, false, SketchKey::Remove},
    KeyBinding{Qt::Key_C, false, SketchKey::Close},
    KeyBinding{Qt::Key_N, false, SketchKey::NewCurve},
    KeyBinding{Qt::Key_X, false, SketchKey::Cancel},
};

}  // namespace

CurveTool::CurveTool(
    QGLWidget& view,
    TriangleMesh surface,
    std::optional<DrawnCurve> reopened,
    std::function<void(const Curves&)> commit
)
    : view_(view),
      makeLayers_(std::move(commit)),
      reopened_(std::move(reopened)),
      hadTracking_(view.hasMouseTracking()),
      panel_(&view),
      preparing_(std::async(std::launch::async, [mesh = std::move(surface)]() mutable {
          // Strictness is the filter's, which makes the layers.
          Mended<CurveDesigner> mended =
              makeMended(std::move(mesh), MendingOptions{}, [](TriangleMesh given) {
                  return CurveDesigner(std::move(given));
              });
          return std::make_shared<const CurveDesigner>(std::move(mended.made));
      })) {
    view_.setMouseTracking(true);
    view_.installEventFilter(this);
    connect(&timer_, &QTimer::timeout, this, &CurveTool::look);
    connect(&panel_, &ToolPanel::optionsChanged, this, &CurveTool::setOptions);
    connect(&panel_, &ToolPanel::keyAsked, this, &CurveTool::runKey);
    connect(&panel_, &ToolPanel::commitAsked, this, &CurveTool::commit);
    connect(&panel_, &ToolPanel::keyPressed, this, [this](QKeyEvent* event) { keyPress(*event); });
    panel_.say(tr("Preparing the surface …"));
    panel_.QWidget::show();
    timer_.start(kLookEvery);
}

CurveTool::~CurveTool() {
    view_.removeEventFilter(this);
    view_.setMouseTracking(hadTracking_);
    if (isLent_) {
        toggleCamera();
    }
}

void CurveTool::look() {
    if (preparing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return;
    }
    timer_.stop();
    try {
        SessionSettings settings;
        // The session's thread wakes ours.
        settings.wake = [this] {
            QMetaObject::invokeMethod(this, [this] { refresh(); }, Qt::QueuedConnection);
        };
        session_ = std::make_unique<DrawingSession>(preparing_.get(), std::move(settings));
        if (reopened_) {
            session_->reopen(std::move(reopened_->picks), reopened_->options);
        }
        refresh();
    } catch (const std::exception& error) {
        panel_.say(error.what());
    }
}

void CurveTool::refresh() {
    if (session_) {
        session_->update();
    }
    panel_.show(session_.get());
    view_.update();
}

void CurveTool::draw() {
    seen_.emplace(view_);
    if (session_) {
        session_->update();
        paintSketch(*session_, view_.devicePixelRatioF());
    }
}

// ---- Events ----

Pointer CurveTool::pointerOf(const QMouseEvent& event, const View& seen) {
    Pointer pointer = seen.pointerAt(event.localPos());
    pointer.snaps = event.modifiers().testFlag(Qt::ControlModifier);
    pointer.removes = event.modifiers().testFlag(Qt::ShiftModifier);
    return pointer;
}

void CurveTool::mousePress(QMouseEvent& event) {
    last_ = event.localPos();
    const bool isOurs = session_ && seen_ && event.button() == Qt::LeftButton &&
                        !event.modifiers().testFlag(Qt::AltModifier);
    if (!isOurs || !session_->press(pointerOf(event, *seen_))) {
        lendToCamera(event);
    }
    refresh();
}

void CurveTool::mouseMove(QMouseEvent& event) {
    last_ = event.localPos();
    if (session_ && seen_) {
        session_->move(pointerOf(event, *seen_));
        refresh();
    }
}

void CurveTool::mouseRelease(QMouseEvent& event) {
    if (session_ && seen_ && event.button() == Qt::LeftButton) {
        session_->release(pointerOf(event, *seen_));
        refresh();
    }
}

void CurveTool::wheel(QWheelEvent& event) {
    toggleCamera();
    QWheelEvent same(event);
    QCoreApplication::sendEvent(&view_, &same);
    toggleCamera();
}

void CurveTool::keyPress(QKeyEvent& event) {
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        event.accept();
        commit();
        return;
    }
    const bool withControl = event.modifiers().testFlag(Qt::ControlModifier);
    for (const KeyBinding& binding : kBindings) {
        if (binding.key == event.key() && binding.withControl == withControl) {
            event.accept();
            runKey(binding.means);
        }
    }
}

void CurveTool::runKey(SketchKey key) {
    if (session_ && seen_) {
        session_->key(key, seen_->pointerAt(last_));
        refresh();
    }
}

void CurveTool::setOptions(bool closed, int degree, double tension) {
    if (!session_) {
        return;
    }
    const SketchCurve* const curve = session_->sketch().activeCurve();
    SketchCurveOptions options = curve == nullptr ? SketchCurveOptions() : curve->options;
    options.solver.closed = closed;
    options.solver.degree = degree;
    options.solver.tension = tension;
    session_->setOptions(options);
    refresh();
}

void CurveTool::commit() {
    if (!session_) {
        return;
    }
    const Curves curves = session_->commit();
    refresh();
    try {
        makeLayers_(curves);
    } catch (const std::exception& error) {
        for (const std::shared_ptr<const SketchCurve>& curve : curves) {
            session_->reopen(curve->picks, curve->options);
        }
        refresh();
        panel_.say(error.what());
    }
}

// ---- The camera ----

// The host gives all events to the tool while it is not suspended.
void CurveTool::toggleCamera() {
    QMetaObject::invokeMethod(&view_, "suspendEditToggle");
}

void CurveTool::lendToCamera(QMouseEvent& event) {
    isLent_ = true;
    toggleCamera();
    QMouseEvent same(
        event.type(),
        event.localPos(),
        event.windowPos(),
        event.screenPos(),
        event.button(),
        event.buttons(),
        // What the tool alone asked for is not the camera's.
        event.modifiers() & ~Qt::KeyboardModifiers(Qt::AltModifier)
    );
    QCoreApplication::sendEvent(&view_, &same);
}

bool CurveTool::eventFilter(QObject* watched, QEvent* event) {
    if (isLent_ && event->type() == QEvent::MouseButtonRelease) {
        // After the camera had it.
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (std::exchange(isLent_, false)) {
                    toggleCamera();
                }
            },
            Qt::QueuedConnection
        );
    }
    if (session_ && event->type() == QEvent::Leave) {
        session_->leave();
        refresh();
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace bspline_curve
