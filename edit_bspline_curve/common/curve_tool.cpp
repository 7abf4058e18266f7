// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_tool.h"

#include "bspline_curve/error.h"
#include "design/designer_surface.h"
#include "design/mended_designer.h"
#include "edit_bspline_curve/common/sketch_painter.h"
#include "field/make_field.h"
#include "filters/mended_layer.h"

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
    QGLWidget& view, LayerInput surface, std::optional<DrawnCurve> reopened, ToolHost host
)
    : view_(view),
      host_(std::move(host)),
      reopened_(std::move(reopened)),
      hadTracking_(view.hasMouseTracking()),
      panel_(&view),
      preparing_(
          std::async(
              std::launch::async, [layer = std::move(surface), progress = untilTheEnd()]() mutable {
                  // Strictness is the filter's, which makes the layers.
                  Mended<CurveDesigner> mended =
                      makeMendedDesigner(std::move(layer.mesh), {}, {}, progress);
                  if (const MeshRepair* const repair = mended.repair()) {
                      layer = carriedOver(layer, *repair);
                  }
                  return Prepared{
                      std::make_shared<const CurveDesigner>(std::move(mended.made)),
                      std::move(layer),
                      mended.repair() != nullptr
                  };
              }
          )
      ) {
    view_.setMouseTracking(true);
    view_.installEventFilter(this);
    connect(&timer_, &QTimer::timeout, this, &CurveTool::look);
    connect(&panel_, &ToolPanel::optionsChanged, this, &CurveTool::setOptions);
    connect(&panel_, &ToolPanel::keyAsked, this, &CurveTool::runKey);
    connect(&panel_, &ToolPanel::commitAsked, this, &CurveTool::commit);
    connect(&panel_, &ToolPanel::useAsked, this, [this](const FilterDescription* filter) {
        use(*filter);
    });
    connect(&panel_, &ToolPanel::keyPressed, this, [this](QKeyEvent* event) { keyPress(*event); });
    panel_.say(tr("Preparing the surface …"));
    panel_.QWidget::show();
    timer_.start(kLookEvery);
}

CurveTool::~CurveTool() {
    isEnding_ = true;
    view_.removeEventFilter(this);
    view_.setMouseTracking(hadTracking_);
    if (isLent_) {
        toggleCamera();
    }
}

Progress CurveTool::untilTheEnd() const {
    return [this](double, const char*) { return !isEnding_; };
}

void CurveTool::look() {
    const auto isReady = [](const auto& future) {
        return future.valid() &&
               future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    try {
        if (isReady(preparing_)) {
            begin(preparing_.get());
        }
        if (isReady(preparingCrests_)) {
            session_->setSnapping(preparingCrests_.get());
        }
    } catch (const std::exception& error) {
        panel_.say(error.what());
    }
    if (!preparing_.valid() && !preparingCrests_.valid()) {
        timer_.stop();
    }
}

void CurveTool::begin(Prepared prepared) {
    designer_ = std::move(prepared.designer);
    options_ = std::make_unique<OptionBook>(designer_, std::move(prepared.layer));
    SessionSettings settings;
    // The session's thread wakes ours.
    settings.wake = [this] {
        QMetaObject::invokeMethod(this, [this] { refresh(); }, Qt::QueuedConnection);
    };
    session_ = std::make_unique<DrawingSession>(designer_, std::move(settings));
    if (reopened_) {
        for (SketchPick& pick : reopened_->picks) {
            if (prepared.isMended) {
                pick.point = treeOf(*designer_).closestPoint(pick.position).point;
            }
        }
        reopen(*reopened_);
    }
    refresh();
}

void CurveTool::reopen(const DrawnCurve& curve) {
    session_->reopen(curve.picks, options_->toSketch(curve.options));
}

// Ridges and valleys take seconds on a large mesh, so they wait until somebody snaps.
void CurveTool::prepareCrests() {
    if (std::exchange(hasCrests_, true)) {
        return;
    }
    preparingCrests_ =
        std::async(std::launch::async, [designer = designer_, progress = untilTheEnd()] {
            const auto field = [&](FieldKind kind) {
                return std::make_shared<const std::vector<double>>(
                    makeField(surfaceOf(*designer), FieldOptions{.kind = kind}, {}, progress)
                );
            };
            SnapOptions snapping;
            snapping.ridge = field(FieldKind::Ridge);
            snapping.valley = field(FieldKind::Valley);
            return snapping;
        });
    timer_.start(kLookEvery);
}

void CurveTool::refresh() {
    if (session_) {
        session_->update();
    }
    const SketchCurve* const curve = session_ ? session_->sketch().activeCurve() : nullptr;
    panel_.show(
        session_.get(),
        curve == nullptr ? std::nullopt : std::optional(options_->fromSketch(curve->options)),
        hasLayers_
    );
    view_.update();
}

void CurveTool::draw() {
    seen_.emplace(view_);
    if (session_) {
        session_->update();
        paintSketch(*session_, *seen_);
    }
}

// ---- Events ----

Pointer CurveTool::pointerOf(const QMouseEvent& event, const View& seen) {
    Pointer pointer = seen.pointerAt(event.localPos());
    pointer.snaps = event.modifiers().testFlag(Qt::ControlModifier);
    pointer.removes = event.modifiers().testFlag(Qt::ShiftModifier);
    if (pointer.snaps) {
        prepareCrests();
    }
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

void CurveTool::setOptions(const DrawnOptions& options) {
    if (!session_) {
        return;
    }
    try {
        session_->setOptions(options_->toSketch(options));
        refresh();
    } catch (const InputError& error) {
        panel_.say(error.what());
    }
}

// Whether there was nothing to be made, or it was made.
bool CurveTool::commit() {
    if (!session_) {
        return false;
    }
    std::vector<DrawnCurve> curves;
    for (const std::shared_ptr<const SketchCurve>& curve : session_->commit()) {
        curves.push_back({curve->picks, options_->fromSketch(curve->options)});
    }
    refresh();
    try {
        host_.makeLayers(curves);
    } catch (const std::exception& error) {
        for (const DrawnCurve& curve : curves) {
            reopen(curve);
        }
        refresh();
        panel_.say(error.what());
        return false;
    }
    hasLayers_ = hasLayers_ || !curves.empty();
    refresh();
    return true;
}

void CurveTool::use(const FilterDescription& filter) {
    if (!commit()) {
        return;
    }
    try {
        host_.useCurves(filter);
    } catch (const std::exception& error) {
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
